"""Documents in which KD706 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_LINK = link("upper", 1, inertia="").replace("{", "{ // %s", 1)

_GOOD = _LINK % "kindsl: ignore[KD304]"

GOOD = (_GOOD,)
BAD = (
    Example(_LINK % "kindsl: ignore[KD3O4]", fixed=_GOOD),
    Example(_LINK % "kindsl: ignore[KD304, KD999]", fixed=_GOOD),
    Example(_LINK % "kindsl: ignroe[KD304]", fixed=_GOOD),
    Example(_LINK % "kindsl: ignore", fixed=_GOOD),
    Example(_LINK % "kindsl: ignore[missing-inertia]", fixed=_GOOD),
)
