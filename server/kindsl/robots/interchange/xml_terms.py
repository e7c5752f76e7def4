"""What URDF and SDF call the same."""

from typing import Literal

LinkJoint = Literal["", "fixed", "revolute", "prismatic"]
# The kinds of joints that there are here.
JOINT_KINDS: dict[str, LinkJoint] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
}
# The moments of `Symmetric`.
TENSOR = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
