"""Documents in which KD103 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot

_LINKS = link("arm", 1, "hand via wrist"), link("hand", 2)

GOOD = (robot(*_LINKS, base="arm via shoulder", joints="shoulder wrist"),)
BAD = (
    robot(*_LINKS, base="arm via shoulder", joints="shoulder wrist wrist"),
    robot(*_LINKS, base="arm via shoulder", joints="wrist wrist"),
)
