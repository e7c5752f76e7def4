"""The quantities that exist in both forms, the book's and generated code; what they depend on."""

from typing import Final, Literal, TypeAlias

Quantity: TypeAlias = Literal[
    "poses",
    "joint_space_inertia",
    "inverse_dynamics",
    "forward_dynamics",
    "gravity_torque",
    "bias_torque",
]

# What each depends on; besides, all may depend on the base's velocity and on gravity.
JOINT_VECTORS: Final[dict[Quantity, tuple[str, ...]]] = {
    "poses": ("q",),
    "joint_space_inertia": ("q",),
    "inverse_dynamics": ("q", "qd", "qdd"),
    "forward_dynamics": ("q", "qd", "tau"),
    "gravity_torque": ("q",),
    "bias_torque": ("q", "qd"),
}

# What solves for accelerations: of a floating base alone, or of all.
ACCELERATING: Final = {
    "inverse_dynamics": "base", "forward_dynamics": "all", "inertia_factorization": "all",
    "forward_dynamics_derivatives": "all", "joint_space_inertia_inverse": "all",
    "contact_dynamics": "all",
}  # fmt: skip

# The names that methods have for arguments of generated code.
KEYWORDS: Final = {"v0": "base_velocity", "a0": "base_acceleration", "g": "gravity"}
STANDARD_GRAVITY: Final = (0.0, 0.0, -9.81)


class SingularInertiaError(ValueError):
    """Some motion meets no inertia, so its acceleration is not defined.

    Attributes:
        moving: Whose motion: `joint 'x'`, `the base`, or nothing if unknown.
    """

    def __init__(self, moving: str = "") -> None:
        self.moving = moving
        why = f"nothing resists motion of {moving}: " if moving else ""
        message = f"the acceleration is not defined: {why}the inertia matrix is singular"
        super().__init__(message)
