"""Documents in which KD507 finds nothing, and in which it finds something."""

from tests.support.examples import STEEL_BALL, Example, link

from kindsl.judgement.rules.context import ROBCOGEN2


def _ball(product: str) -> str:
    return link("ball", 1, inertia=STEEL_BALL.replace("Ixy=0.0", f"Ixy={product}"))


GOOD = (_ball("0.000006"),)
BAD = tuple(Example(_ball(product), (ROBCOGEN2,)) for product in ("0.000003", "-0.000001"))
