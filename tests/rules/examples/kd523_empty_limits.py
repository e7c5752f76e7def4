"""Documents in which KD523 finds nothing, and in which it finds something."""

from tests.support.examples import urdf_arm

GOOD = (urdf_arm('<limit lower="0" upper="1.57" effort="80" velocity="3"/>'),)
BAD = (
    urdf_arm('<limit effort="80" velocity="3"/>'),
    urdf_arm('<limit lower="0.5" upper="0.5" effort="80" velocity="3"/>'),
)
