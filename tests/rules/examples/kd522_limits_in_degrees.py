"""Documents in which KD522 finds nothing, and in which it finds something."""

from tests.support.examples import urdf_arm

GOOD = (
    urdf_arm('<limit lower="-1.57" upper="0.785" effort="80" velocity="3"/>'),
    urdf_arm('<limit lower="-100" upper="100" effort="80" velocity="3"/>'),
    urdf_arm('<limit lower="-20" upper="20" effort="100" velocity="0.5"/>'),
    urdf_arm('<limit lower="0" upper="62.8" effort="100" velocity="0.5"/>'),
    urdf_arm('<limit lower="-18" upper="27" effort="100" velocity="0.5"/>'),
    urdf_arm('<limit lower="-31.25" upper="44.17" effort="100" velocity="0.5"/>'),
)
BAD = (
    urdf_arm('<limit lower="-90" upper="45" effort="80" velocity="3"/>'),
    urdf_arm('<limit lower="-20" upper="50" effort="80" velocity="3"/>'),
    urdf_arm('<limit lower="-92" upper="114" effort="80" velocity="3"/>'),
    urdf_arm('<limit lower="-57.3" upper="68.8" effort="80" velocity="3"/>'),
)
