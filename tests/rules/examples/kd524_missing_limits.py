"""Documents in which KD524 finds nothing, and in which it finds something."""

from tests.support.examples import sdf_arm, urdf_arm

GOOD = (
    urdf_arm('<limit lower="0" upper="1.57" effort="80" velocity="3"/>'),
    sdf_arm(axis="<limit><lower>0</lower><upper>1.57</upper></limit>"),
)
BAD = (urdf_arm(""), urdf_arm('<limit lower="0" upper="1.57" velocity="3"/>'))
