"""Documents in which KD108 finds nothing, and in which it finds something."""

from tests.support.examples import STEEL_BALL, link, robot

_FRAMES = "frames { %s { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }\n}"


def _arm(frame: str, other: str) -> str:
    upper = link("upper", 1, "lower via elbow", STEEL_BALL[:-1] + "ref_frame = fr_COM }")
    lower = link("lower", 2).removesuffix("}\n") + _FRAMES % other
    upper = upper.removesuffix("}\n") + _FRAMES % frame
    return robot(upper, lower, base="upper via shoulder", joints="shoulder elbow")


GOOD = (_arm("fr_COM", "camera"),)
BAD = (_arm("camera", "fr_COM"),)
