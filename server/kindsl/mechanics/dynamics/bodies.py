"""The numeric description of a mechanism that all algorithms work on."""

from dataclasses import dataclass

import numpy as np

from kindsl.mechanics.rigid.topology import Topology, check_topology
from kindsl.mechanics.spatial.arrays import Array

ORTHONORMAL_TOLERANCE = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class BodyFrame:
    """A named frame fixed to a body.

    Attributes:
        name: Its name, unique among the links and frames.
        body: Index of the body that carries it, 0 for the base.
        body_R_frame: Rotation of coordinates from the frame to the body, shape (3, 3).
        body_r_frame: The frame's origin in the body's frame, shape (3,), metres.
    """

    name: str
    body: int
    body_R_frame: Array
    body_r_frame: Array


@dataclass(frozen=True, slots=True, eq=False)
class Drives:
    """Rotors and friction of joints, which take forces besides those of the bodies.

    Attributes:
        armature: Inertia of the rotors, seen from the joints, shape (n,), kg m^2 or kg.
        damping: Viscous friction, force a velocity, shape (n,).
        friction: Coulomb friction, shape (n,), N m or N; none at rest.
    """

    armature: Array
    damping: Array
    friction: Array

    def force(self, qd: Array, qdd: Array) -> Array:
        """Return the joint forces (..., n) that they take of a motion."""
        return self.armature * qdd + self.damping * qd + self.friction * np.sign(qd)


@dataclass(frozen=True, slots=True, eq=False)
class Bodies(Topology):
    """A tree of rigid bodies; names of bodies and frames are unique together.

    Attributes:
        p_R_j: Rotations from joint frames to predecessor frames, shape (n, 3, 3).
        p_r_j: Joint frames' origins in predecessor frames, shape (n, 3), metres.
        masses: Of the base and the links, shape (n + 1,), kg.
        coms: Centres of mass in the bodies' frames, shape (n + 1, 3), metres.
        inertias: Inertia tensors about the bodies' origins and axes, products of inertia with
            their minus signs, shape (n + 1, 3, 3), kg m^2.
        is_floating: Whether the base floats; if not, its inertia does not matter.
        frames: Further named frames.
        drives: Rotors and friction of the joints, None where nothing is known of them.

    Raises:
        ValueError: On construction, if shapes, numbering, names or values are not as above.
    """

    p_R_j: Array
    p_r_j: Array
    masses: Array
    coms: Array
    inertias: Array
    is_floating: bool
    frames: tuple[BodyFrame, ...] = ()
    drives: Drives | None = None

    def __post_init__(self) -> None:
        n = self.n_links
        if n == 0:
            raise ValueError("no joint moves: a mechanism has at least one link")
        check_topology(self, (frame.name for frame in self.frames))
        shapes = {
            "p_R_j": (n, 3, 3),
            "p_r_j": (n, 3),
            "masses": (n + 1,),
            "coms": (n + 1, 3),
            "inertias": (n + 1, 3, 3),
        }
        for attribute, shape in shapes.items():
            frozen = _frozen_array(attribute, getattr(self, attribute), shape)
            object.__setattr__(self, attribute, frozen)
        if self.drives is not None:
            named = {field: getattr(self.drives, field) for field in Drives.__slots__}
            frozen_drives = Drives(**{k: _frozen_array(k, x, (n,)) for k, x in named.items()})
            object.__setattr__(self, "drives", frozen_drives)
        _check_values(self)
        object.__setattr__(self, "frames", tuple(_checked_frame(f, n) for f in self.frames))

    @property
    def n_velocities(self) -> int:
        """Number of velocity variables: the joints, and six more for a floating base."""
        return self.n_links + (6 if self.is_floating else 0)

    def support(self, body: int) -> list[int]:
        """Return the joints between the base and a body, nearest to the body first."""
        joints = []
        while body:
            joints.append(body)
            body = self.parents[body - 1]
        return joints


def _check_values(bodies: Bodies) -> None:
    if not np.allclose(bodies.inertias, np.swapaxes(bodies.inertias, -1, -2), atol=1e-12):
        raise ValueError("an inertia tensor is not symmetric")
    for name, R in zip(bodies.joint_names, bodies.p_R_j, strict=True):
        _check_rotation(f"joint '{name}'", R)


def _checked_frame(frame: BodyFrame, n: int) -> BodyFrame:
    if not 0 <= frame.body <= n:
        raise ValueError(f"frame '{frame.name}' is on body {frame.body}, of 0 to {n}")
    R = _frozen_array(f"rotation of frame '{frame.name}'", frame.body_R_frame, (3, 3))
    r = _frozen_array(f"position of frame '{frame.name}'", frame.body_r_frame, (3,))
    _check_rotation(f"frame '{frame.name}'", R)
    return BodyFrame(frame.name, frame.body, R, r)


def _check_rotation(owner: str, R: Array) -> None:
    is_orthonormal = np.allclose(R @ R.T, np.eye(3), rtol=0.0, atol=ORTHONORMAL_TOLERANCE)
    if not is_orthonormal or np.linalg.det(R) < 0.0:
        raise ValueError(f"{owner}: the rotation matrix is not a rotation")


def _frozen_array(quantity: str, values: Array, shape: tuple[int, ...]) -> Array:
    array = np.array(values, dtype=np.float64)
    if array.shape != shape:
        raise ValueError(f"{quantity} has shape {array.shape}, expected {shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{quantity} holds a value that is not finite")
    array.flags.writeable = False
    return array
