"""Documents in which KD705 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot


def _arm(joints: str) -> str:
    links = link("upper", 1, "lower via elbow"), link("lower", 2)
    return robot(*links, base="upper via shoulder", joints=joints)


GOOD = (_arm("shoulder elbow"),)
BAD = (_arm("elbow shoulder"),)
