"""Documents in which KD315 finds nothing, and in which it finds something."""

from tests.support.examples import urdf_link

GOOD = (urdf_link('ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"'),)
BAD = (
    urdf_link('ixx="0.0123" ixy="0.0123" ixz="0" iyy="0.025" iyz="0" izz="0.025"'),
    urdf_link('ixx="0.01" ixy="0.01" ixz="0.01" iyy="0.01" iyz="0.01" izz="0.01"'),
)
