"""Documents in which KD525 finds nothing, and in which it finds something."""

from tests.support.examples import urdf_arm

_LIMIT = '<limit lower="0" upper="1.57" effort="80" velocity="3"/>'

GOOD = (urdf_arm(_LIMIT),)
BAD = (urdf_arm(f'{_LIMIT}<mimic joint="elbow"/>'), urdf_arm(f'{_LIMIT}<mimic joint="shoulder"/>'))
