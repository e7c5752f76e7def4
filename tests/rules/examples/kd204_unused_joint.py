"""Documents in which KD204 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot


def _arm(joints: str) -> str:
    return robot(link("upper", 1), base="upper via shoulder", joints=joints)


GOOD = (_arm("shoulder"),)
BAD = (_arm("shoulder spare"),)
