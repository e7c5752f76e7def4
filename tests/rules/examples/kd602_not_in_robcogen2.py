"""Documents in which KD602 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint

from kindsl.judgement.rules.context import ROBCOGEN2


def _joint(height: str, comment: str = "") -> Example:
    text = comment + joint("shoulder").replace("0.3", height)
    return Example(text, (ROBCOGEN2,), (("reach", 0.3), ("pitch", 0.1)))


GOOD = (_joint("0.3"), _joint("reach/2.0"), _joint("0.3", "// seen from above\n"))
BAD = (
    _joint("2.0 reach")._replace(fixed=_joint("reach/0.5").text),
    _joint("pitch"),
    _joint("0.3", "/* seen from above */\n")._replace(
        fixed=_joint("0.3", "// seen from above\n").text
    ),
)
