"""Documents in which KD503 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint, pitched_joint

GOOD = (joint("elbow", rotation="PI/2.0, 1.5, 1.6"),)
BAD = (
    Example(pitched_joint("1.5708"), fixed=pitched_joint("PI/2.0")),
    Example(pitched_joint("-3.14"), fixed=pitched_joint("-PI")),
    Example(pitched_joint("0.785398"), fixed=pitched_joint("PI/4.0")),
)
