"""Documents in which KD411 finds nothing, and in which it finds something."""

from tests.support.examples import Example, inertia, link


def _hand(moment: str) -> Example:
    text = link("hand", 1, inertia=inertia("payload", "0.3", moment, moment, "payload/100.0"))
    return Example(text, parameters=(("payload", 1.0),), ranges=(("payload", 0.5, 4.0),))


GOOD = (_hand("payload/10.0"),)
BAD = (_hand("0.095"),)
