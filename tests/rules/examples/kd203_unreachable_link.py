"""Documents in which KD203 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot

_ARM = link("upper", 1, "lower via elbow"), link("lower", 2)

GOOD = (robot(*_ARM, base="upper via shoulder", joints="shoulder elbow"),)
BAD = (
    robot(*_ARM, joints="elbow"),
    robot(*_ARM, joints="shoulder elbow"),
    robot(*_ARM, link("camera", 3), base="upper via shoulder", joints="shoulder elbow"),
)
