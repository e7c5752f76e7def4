"""Documents in which KD102 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot

_BASE = "finger via left thumb via right"

GOOD = (robot(link("finger", 1), link("thumb", 2), base=_BASE, joints="left right"),)
BAD = (
    robot(link("finger", 1), link("finger", 2), base=_BASE, joints="left right"),
    robot(link("ground", 1), link("thumb", 2), base="thumb via left", joints="left right"),
)
