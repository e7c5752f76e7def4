"""Documents in which KD704 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_LINK = link("upper", 1, inertia="").replace("{", "{ // kindsl: ignore[%s]", 1)

GOOD = (_LINK % "KD304",)
BAD = (
    Example(_LINK % "KD301", fixed=_LINK.replace(" // kindsl: ignore[%s]", "")),
    Example(_LINK % "KD304, KD301", fixed=_LINK % "KD304"),
    Example(_LINK % "KD301, KD304", fixed=_LINK % "KD304"),
)
