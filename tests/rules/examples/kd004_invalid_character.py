"""Documents in which KD004 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_LINK = link("upper", 1)

GOOD = (_LINK,)
BAD = (
    Example(_LINK.replace("id = 1", "id\xa0= 1"), fixed=_LINK),
    Example(_LINK.replace("id = 1", "\xa7 id = 1"), fixed=_LINK.replace("id = 1", " id = 1")),
    Example(_LINK.replace("0.0041", "4.1\xd710⁻³", 1), fixed=_LINK),
    Example(_LINK.replace("4.1", "\u0664\u066b\u0661", 1), fixed=_LINK),
    Example(_LINK.replace("(0.0", "(\u22120.0"), fixed=_LINK.replace("(0.0", "(-0.0")),
)
