"""Documents in which KD001 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_LINK = link("upper", 1, "lower via elbow wrist via roll")

GOOD = (_LINK,)
BAD = (Example(link("upper", 1, "lower via elbow, wrist via roll"), fixed=_LINK),)
