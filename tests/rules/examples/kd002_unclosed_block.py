"""Documents in which KD002 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_LINK = link("upper", 1, "lower via elbow")

GOOD = (_LINK,)
BAD = (Example(link("upper", 1, "lower via elbow").removesuffix("}\n"), fixed=_LINK),)
