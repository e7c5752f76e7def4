"""The numeric description of a mechanism that all algorithms work on."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from kindsl.spatial.arrays import Array

JointKind = Literal["revolute", "prismatic"]

ORTHONORMAL_TOLERANCE = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Frame:
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
class Bodies:
    """A tree of rigid bodies: the base, body 0, and the links 1 to n, parents before children.

    Link i and its supporting joint i have the index i - 1 in what has a length of n.

    Attributes:
        base_name: The base's name.
        link_names: Names of the n links, unique together with the base's and the frames'.
        joint_names: Names of the n supporting joints.
        joint_kinds: `"revolute"` (turns about the joint frame's z) or `"prismatic"` (slides
            along it).
        parents: Body index of each link's parent, less than the link's own.
        p_R_j: Rotations from joint frames to predecessor frames, shape (n, 3, 3).
        p_r_j: Joint frames' origins in predecessor frames, shape (n, 3), metres.
        masses: Of the base and the links, shape (n + 1,), kg.
        coms: Centres of mass in the bodies' frames, shape (n + 1, 3), metres.
        inertias: Inertia tensors about the bodies' origins and axes, products of inertia with
            their minus signs, shape (n + 1, 3, 3), kg m^2.
        is_floating: Whether the base is free to move; if not, its inertia does not matter.
        frames: Further named frames.

    Raises:
        ValueError: On construction, if shapes, numbering, names or values are not as above.
    """

    base_name: str
    link_names: tuple[str, ...]
    joint_names: tuple[str, ...]
    joint_kinds: tuple[JointKind, ...]
    parents: tuple[int, ...]
    p_R_j: Array
    p_r_j: Array
    masses: Array
    coms: Array
    inertias: Array
    is_floating: bool
    frames: tuple[Frame, ...] = ()

    def __post_init__(self) -> None:
        n = len(self.link_names)
        _check_tree(self, n)
        _check_names(self)
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
        _check_values(self)
        object.__setattr__(self, "frames", tuple(_checked_frame(f, n) for f in self.frames))

    @property
    def n_links(self) -> int:
        """Number of moving links, which is also the number of joints."""
        return len(self.link_names)

    @property
    def n_velocities(self) -> int:
        """Number of velocity variables: the joints, and six more for a floating base."""
        return self.n_links + (6 if self.is_floating else 0)

    def links(self) -> Iterator[tuple[int, int]]:
        """Yield each link's body index and its parent's, parents first."""
        return enumerate(self.parents, start=1)

    def links_leaves_first(self) -> Iterator[tuple[int, int]]:
        """Yield what `links` yields, children first."""
        return reversed(list(self.links()))

    def support(self, body: int) -> list[int]:
        """Return the joints between the base and a body, nearest to the body first."""
        joints = []
        while body:
            joints.append(body)
            body = self.parents[body - 1]
        return joints


def _check_tree(bodies: Bodies, n: int) -> None:
    if n == 0:
        raise ValueError("a mechanism has at least one link")
    for attribute in ("joint_names", "joint_kinds", "parents"):
        if len(getattr(bodies, attribute)) != n:
            got = len(getattr(bodies, attribute))
            raise ValueError(f"{attribute} has {got} entries, expected {n}, one per link")
    for link, parent in bodies.links():
        name = bodies.link_names[link - 1]
        if not 0 <= parent < link:
            raise ValueError(f"link '{name}' is body {link}: its parent {parent} is not before it")
        if bodies.joint_kinds[link - 1] not in ("revolute", "prismatic"):
            kind = bodies.joint_kinds[link - 1]
            raise ValueError(f"joint of '{name}': '{kind}' is neither revolute nor prismatic")


def _check_names(bodies: Bodies) -> None:
    _check_unique([bodies.base_name, *bodies.link_names, *(frame.name for frame in bodies.frames)])
    _check_unique(bodies.joint_names)


def _check_unique(names: Sequence[str]) -> None:
    seen: set[str] = set()
    for name in names:
        if name in seen:
            raise ValueError(f"the name '{name}' is used twice")
        seen.add(name)


def _check_values(bodies: Bodies) -> None:
    if not np.allclose(bodies.inertias, np.swapaxes(bodies.inertias, -1, -2), atol=1e-12):
        raise ValueError("an inertia tensor is not symmetric")
    for name, R in zip(bodies.joint_names, bodies.p_R_j, strict=True):
        _check_rotation(f"joint '{name}'", R)


def _checked_frame(frame: Frame, n: int) -> Frame:
    if not 0 <= frame.body <= n:
        raise ValueError(f"frame '{frame.name}' is on body {frame.body}, of 0 to {n}")
    R = _frozen_array(f"rotation of frame '{frame.name}'", frame.body_R_frame, (3, 3))
    r = _frozen_array(f"position of frame '{frame.name}'", frame.body_r_frame, (3,))
    _check_rotation(f"frame '{frame.name}'", R)
    return Frame(frame.name, frame.body, R, r)


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
