"""Documents in which KD510 finds nothing, and in which it finds something."""

from tests.support.examples import two_arms

GOOD = (two_arms("0.3, -0.1, 0.02"), two_arms("0.37, 0.0, -0.1"))
BAD = (two_arms("0.03, -0.1, 0.02"), two_arms("-0.1, 0.3, 0.02"))
