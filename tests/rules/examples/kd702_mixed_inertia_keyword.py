"""Documents in which KD702 finds nothing, and in which it finds something."""

from tests.support.examples import STEEL_BALL, Example, link, robot


def _arm(keyword: str) -> str:
    lower = link("lower", 2, inertia=STEEL_BALL.replace("inertia_params", keyword))
    upper = link("upper", 1, "lower via elbow"), lower
    return robot(*upper, base="upper via shoulder", joints="shoulder elbow")


GOOD = (_arm("inertia_params"),)
BAD = (Example(_arm("inertia_properties"), fixed=_arm("inertia_params")),)
