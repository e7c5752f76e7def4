"""Documents in which KD504 finds nothing, and in which it finds something."""

from tests.support.examples import joint

GOOD = (joint("elbow", rotation="0.0, PI/2.0, PI"),)
BAD = (joint("elbow", rotation="PI/4.0, PI/2.0, PI/4.0"),)
