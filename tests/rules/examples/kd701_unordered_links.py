"""Documents in which KD701 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot

_UPPER, _LOWER = link("upper", 1, "lower via elbow"), link("lower", 2)

GOOD = (robot(_UPPER, _LOWER, base="upper via shoulder", joints="shoulder elbow"),)
BAD = (robot(_LOWER, _UPPER, base="upper via shoulder", joints="shoulder elbow"),)
