"""Documents in which KD005 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint

_ELBOW = joint("elbow", 1.0)

GOOD = (_ELBOW,)
BAD = (
    Example(_ELBOW.replace("1.0", "1"), fixed=_ELBOW),
    Example(_ELBOW.replace("1.0", "1,0"), fixed=_ELBOW),
    Example(_ELBOW.replace("1.0", "10.0*10^-1"), fixed=_ELBOW),
    Example(_ELBOW.replace("1.0", "0.123 456"), fixed=_ELBOW.replace("1.0", "0.123456")),
)
