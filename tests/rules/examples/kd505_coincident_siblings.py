"""Documents in which KD505 finds nothing, and in which it finds something."""

from tests.support.examples import joint, link, robot


def _hand(height: float, second: str = "wheel") -> str:
    links = link("thumb", 1), link("finger", 2), link("palm", 3)
    joints = joint("pivot", 0.1), joint(second, height), joint("wrist", 0.5)
    base = f"thumb via pivot finger via {second} palm via wrist"
    return robot(*links, *joints, base=base)


GOOD = (_hand(0.2), _hand(0.1, "pivot2"))
BAD = (_hand(0.1),)
