"""Documents in which KD010 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

from kindsl.language.syntax.vocabulary import MOMENTS

_LINK = link("upper", 1)

_HEAD = "inertia_params {\n        mass = 4.1\n        CoM = (0.0, 0.0, 0.0)\n        "

_SIX = "\n        ".join(f"{name} = {0.2 if len(name) < 3 else 0.0}" for name in MOMENTS)

_TODAY = link("upper", 1, inertia=f"{_HEAD}{_SIX}\n    }}")

GOOD = (_LINK,)
BAD = (
    Example(_LINK.replace("children", "childrn"), fixed=_LINK),
    Example(_TODAY.replace(_SIX, "moments = 0.2, 0.2, 0.2, 0.0, 0.0, 0.0"), fixed=_TODAY),
)
