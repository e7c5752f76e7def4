"""Documents in which KD208 finds nothing, and in which it finds something."""

from tests.support.examples import Example, four_legs

_SHANK = "RF_shank via RF_KFE"

_HERE, _THERE = f"children {{ {_SHANK} }}", "children { LF_shank via LF_KFE }"

_CROSSED = four_legs().replace(_HERE, "children { }").replace(_THERE, f"{_THERE[:-1]}{_SHANK} }}")

GOOD = (four_legs(),)
BAD = (Example(_CROSSED, fixed=four_legs()),)
