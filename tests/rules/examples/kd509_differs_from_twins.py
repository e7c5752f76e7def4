"""Documents in which KD509 finds nothing, and in which it finds something."""

from tests.support.examples import Example, four_legs

GOOD = (four_legs(), four_legs(LH="0.1, 0.0, 0.0", RH="0.1, 0.0, 0.0"))
BAD = (Example(four_legs(RH="0.8, 0.0, 0.0"), fixed=four_legs()),)
