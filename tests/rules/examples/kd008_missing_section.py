"""Documents in which KD008 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_LINK = link("upper", 1)

GOOD = (_LINK,)
BAD = (
    _LINK.replace("id = 1", ""),
    Example(
        _LINK.replace("{  }", "{  }\n    frames {}"), fixed=_LINK.replace("{  }", "{  }\n    ")
    ),
)
