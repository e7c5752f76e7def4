"""Documents in which KD522 finds nothing, and in which it finds something."""

from tests.support.examples import urdf_arm

GOOD = (
    urdf_arm('<limit lower="-1.57" upper="0.785" effort="80" velocity="3"/>'),
    urdf_arm('<limit lower="-100" upper="100" effort="80" velocity="3"/>'),
    urdf_arm('<limit lower="-20" upper="20" effort="100" velocity="0.5"/>'),
)
BAD = (
    urdf_arm('<limit lower="-90" upper="45" effort="80" velocity="3"/>'),
    urdf_arm('<limit lower="-20" upper="50" effort="80" velocity="3"/>'),
)
