"""Documents in which KD401 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint

_JOINT = joint("elbow").replace("0.3", "length")

GOOD = (
    Example(_JOINT, parameters=(("length", 0.3),)),
    joint("elbow").replace("0.3", "length[0.3]"),
)
BAD = (
    _JOINT,
    Example(_JOINT, targets=("robcogen2",), fixed=_JOINT.replace("length", "length[0.0]")),
)
