"""Documents in which KD210 finds nothing, and in which it finds something."""

from tests.support.examples import Example, four_legs

GOOD = (four_legs(),)
BAD = (Example(four_legs().replace("r_joint RH_KFE", "p_joint RH_KFE"), fixed=four_legs()),)
