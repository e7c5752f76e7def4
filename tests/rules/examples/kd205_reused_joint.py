"""Documents in which KD205 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot


def _hand(right: str) -> str:
    base = f"left via finger right via {right}"
    return robot(link("left", 1), link("right", 2), base=base, joints="finger thumb")


GOOD = (_hand("thumb"),)
BAD = (_hand("finger"),)
