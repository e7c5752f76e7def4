"""Documents in which KD101 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link, robot


def _arm(second: int) -> str:
    links = link("upper", 1, "lower via elbow"), link("lower", second)
    return robot(*links, base="upper via shoulder", joints="shoulder elbow")


GOOD = (_arm(2),)
BAD = (Example(_arm(1), fixed=_arm(2)),)
