"""The poses of a mechanism's links and frames, by name."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from kindsl.mechanics.spatial.arrays import Array


class Poses(Mapping[str, Array]):
    """Poses `base_T_x` (..., 4, 4) by the names of the links and frames x."""

    __slots__ = ("_indices", "_poses")

    def __init__(self, indices: Mapping[str, int], poses: Array) -> None:
        """Keep poses (poses, ..., 4, 4) by their numbers."""
        self._indices = indices
        self._poses = poses

    def __getitem__(self, name: str) -> Array:
        pose: Array = self._poses[self._indices[name]]
        return pose

    def __iter__(self) -> Iterator[str]:
        return iter(self._indices)

    def __len__(self) -> int:
        return len(self._indices)

    def __repr__(self) -> str:
        return repr(dict(self))


class FreeMotionTorque(NamedTuple):
    """Inverse dynamics with a floating base on which no wrench acts.

    Attributes:
        tau: Joint forces, shape (..., n), N m and N.
        base_acceleration: Spatial acceleration, gravity's effect included, shape (..., 6), base
            coordinates, angular part first.
    """

    tau: Array
    base_acceleration: Array


class ActuatedTorque(NamedTuple):
    """Inverse dynamics with a floating base whose acceleration is given.

    Attributes:
        tau: Joint forces, shape (..., n), N m and N.
        base_wrench: What acts on the base besides gravity and external forces, shape (..., 6), base
            coordinates, moment first.
    """

    tau: Array
    base_wrench: Array


class FloatingConfiguration(NamedTuple):
    """A configuration of a floating base's mechanism.

    Attributes:
        q: Joint positions, shape (..., n), radians and metres.
        base_pose: `world_T_base`, shape (..., 4, 4).
    """

    q: Array
    base_pose: Array


class FreeMotion(NamedTuple):
    """Forward dynamics with a floating base on which no wrench acts.

    Attributes:
        qdd: Joint accelerations, shape (..., n).
        base_acceleration: Spatial acceleration, gravity's effect included, shape (..., 6), base
            coordinates, angular part first.
    """

    qdd: Array
    base_acceleration: Array


class ConstrainedMotion(NamedTuple):
    """Forward dynamics while k frames are held at m components in all.

    Attributes:
        qdd: Joint accelerations, shape (..., n).
        base_acceleration: Spatial acceleration of a floating base, zero for a fixed one, gravity's
            effect included, shape (..., 6), base coordinates, angular part first.
        contact_forces: What acts on the robot at each frame's origin, in base coordinates: forces,
            shape (..., k, 3), or moments and forces, shape (..., k, 6).
        Lambda: The inertia that the contacts meet, shape (..., m, m).
    """

    qdd: Array
    base_acceleration: Array
    contact_forces: Array
    Lambda: Array
