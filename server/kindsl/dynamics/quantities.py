"""The quantities that exist in a readable and in a generated form, and what they depend on."""

from typing import Final, Literal, TypeAlias

Quantity: TypeAlias = Literal[
    "poses",
    "joint_space_inertia",
    "inverse_dynamics",
    "forward_dynamics",
    "gravity_torque",
    "bias_torque",
]

ARGUMENTS: Final[dict[Quantity, tuple[str, ...]]] = {
    "poses": ("q",),
    "joint_space_inertia": ("q",),
    "inverse_dynamics": ("q", "qd", "qdd", "base_velocity", "gravity"),
    "forward_dynamics": ("q", "qd", "tau", "base_velocity", "gravity"),
    "gravity_torque": ("q", "gravity"),
    "bias_torque": ("q", "qd", "base_velocity", "gravity"),
}


class SingularInertiaError(ValueError):
    """The inertia that resists a motion is zero, so the acceleration is not defined."""
