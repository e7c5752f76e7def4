"""Documents in which KD508 finds nothing, and in which it finds something."""

from tests.support.examples import STEEL_BALL, link


def _ball(mass: str) -> str:
    return link("ball", 1, inertia=STEEL_BALL.replace("4.1", mass))


GOOD = (_ball("4.10000001"),)
BAD = (_ball("4.100000000012"),)
