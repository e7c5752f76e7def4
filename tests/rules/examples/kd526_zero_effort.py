"""Documents in which KD526 finds nothing, and in which it finds something."""

from tests.support.examples import urdf_arm

GOOD = (urdf_arm('<limit lower="0" upper="1.57" effort="80" velocity="3"/>'),)
BAD = (urdf_arm('<limit lower="0" upper="1.57" effort="0" velocity="3"/>'),)
