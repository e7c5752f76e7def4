"""Documents in which KD303 finds nothing, and in which it finds something."""

from tests.support.examples import STEEL_BALL, Example, link


def _ball(mass: str) -> str:
    return link("ball", 1, inertia=STEEL_BALL.replace("4.1", mass, 1))


GOOD = (_ball("4.1"), _ball("m_ball"))
BAD = (
    Example(_ball("-4.1"), fixed=_ball("4.1")),
    link("ball", 1, inertia=STEEL_BALL.replace("4.1", "-4.1", 1).replace("0.0041", "-0.0041")),
    _ball("0.0"),
    _ball("-m_ball[4.1]"),
)
