"""Documents in which KD410 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint


def _joint(value: float) -> Example:
    text = joint("elbow").replace("0.3", "length")
    return Example(text, parameters=(("length", value),), ranges=(("length", 0.2, 0.5),))


GOOD = (_joint(0.3), _joint(0.5))
BAD = (_joint(0.9), _joint(0.1))
