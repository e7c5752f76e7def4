"""Documents in which KD501 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint, pitched_joint

GOOD = (joint("elbow", rotation="PI/2.0, 3.0, 2.0 PI"),)
BAD = (
    Example(pitched_joint("90.0"), fixed=pitched_joint("PI/2.0")),
    Example(pitched_joint("-37.5"), fixed=pitched_joint("-0.65449847")),
    Example(pitched_joint("14.3239"), fixed=pitched_joint("0.25")),
)
