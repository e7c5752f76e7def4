"""Documents in which KD111 finds nothing, and in which it finds something."""

from tests.support.examples import joint, link, robot


def _numbered(name: str, number: int) -> str:
    return joint(name).replace("{", f"{{ id = {number}", 1)


def _arm(number: int) -> str:
    links = link("upper", 1, "lower via elbow"), link("lower", 2)
    joints = _numbered("shoulder", 1), _numbered("elbow", number)
    return robot(*links, *joints, base="upper via shoulder")


GOOD = (_arm(2),)
BAD = (_arm(1),)
