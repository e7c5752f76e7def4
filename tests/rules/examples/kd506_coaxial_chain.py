"""Documents in which KD506 finds nothing, and in which it finds something."""

from tests.support.examples import joint, link, robot


def _arm(rotation: str) -> str:
    links = link("upper", 1, "lower via elbow"), link("lower", 2)
    joints = joint("shoulder"), joint("elbow", rotation=rotation)
    return robot(*links, *joints, base="upper via shoulder")


GOOD = (_arm("PI/2.0, 0.0, 0.0"),)
BAD = (_arm("0.0, 0.0, PI/4.0"), _arm("PI, 0.0, 0.0"))
