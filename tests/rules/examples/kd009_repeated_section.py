"""Documents in which KD009 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_LINK = link("upper", 1)

GOOD = (_LINK,)
BAD = (
    Example(_LINK.replace("id = 1", "id = 1 id = 1"), fixed=_LINK),
    Example(_LINK.replace("Iy=", "Ix="), fixed=_LINK),
)
