"""Documents in which KD006 finds nothing, and in which it finds something."""

from tests.support.examples import Example, pitched_joint

GOOD = (pitched_joint("PI/4.0"),)
BAD = (
    Example(pitched_joint("3.0*PI/4.0"), fixed=pitched_joint("2.356194490192345")),
    Example(pitched_joint("(PI/4.0)"), fixed=pitched_joint("PI/4.0")),
    pitched_joint("tilt+0.1"),
    pitched_joint("atan(1.0)"),
)
