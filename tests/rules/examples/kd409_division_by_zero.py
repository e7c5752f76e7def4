"""Documents in which KD409 finds nothing, and in which it finds something."""

from tests.support.examples import joint

GOOD = (joint("elbow", rotation="PI/2.0, 0.0, 0.0"),)
BAD = (
    joint("elbow", rotation="PI/0.0, 0.0, 0.0"),
    joint("elbow", rotation="PI/scale[0.0], 0.0, 0.0"),
)
