"""Random robots whose every body, joint and axis is given in the world, and the formats of them.

Each format says the same in its own way; MuJoCo, which reads the plainest of them, is the referee.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from kindsl.mechanics.spatial.arrays import Array

RootKind = Literal["placed", "floating", "on joints"]


@dataclass(frozen=True, slots=True)
class PlacedBody:
    """A body at joint values of zero, all in the world.

    Attributes:
        name: Of the body; its joint is `j_<name>`, its frame `f_<name>`.
        parent: Index, -1 for the world.
        kind: `revolute`, `prismatic`, `fixed` or `free`.
        pose: Shape (4, 4).
        anchor: A point on the axis, shape (3,).
        axis: Shape (3,), of length one.
        mass: Kilograms.
        inertial: Pose of the centre of mass and the tensor's axes, shape (4, 4).
        tensor: About the centre of mass along these axes, shape (3, 3).
        frame: Pose of a frame fixed to it, shape (4, 4).
    """

    name: str
    parent: int
    kind: str
    pose: Array
    anchor: Array
    axis: Array
    mass: float
    inertial: Array
    tensor: Array
    frame: Array


def placed_robot(chance: np.random.Generator, root: RootKind) -> list[PlacedBody]:
    """Return up to eight bodies, parents first, one of them moving at least."""
    first = {"placed": "fixed", "floating": "free", "on joints": "revolute"}[root]
    kinds = [first, "revolute", *chance.choice(["revolute", "prismatic", "fixed"], 6)]
    bodies = []
    for index, kind in enumerate(kinds[: chance.integers(2, 9)]):
        parent = int(chance.integers(index)) if index else -1
        if root == "on joints" and index == 1:
            parent = -1
        bodies.append(_body(chance, f"b{index}", parent, str(kind)))
    return bodies


def quaternion(R: Array) -> Array:
    """Return x, y, z, w."""
    values, vectors = np.linalg.eigh(_quaternion_matrix(R))
    return np.asarray(vectors[:, np.argmax(values)])


def fixed_axis_angles(R: Array) -> Array:
    """Return roll, pitch, yaw; no roll where only its sum with the yaw matters."""
    if np.hypot(R[0, 0], R[1, 0]) < 1e-9:
        return np.array([0.0, np.arctan2(-R[2, 0], 0.0), np.arctan2(-R[0, 1], R[1, 1])])
    return np.array([
        np.arctan2(R[2, 1], R[2, 2]),
        np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0])),
        np.arctan2(R[1, 0], R[0, 0]),
    ])  # fmt: skip


def random_pose(chance: np.random.Generator) -> Array:
    """Return a turn of any angle, or of quarters, after a translation."""
    pose = np.eye(4)
    if chance.integers(3):
        Q, R = np.linalg.qr(chance.normal(size=(3, 3)))
        Q = Q @ np.diag(np.sign(np.diag(R)))
        pose[:3, :3] = Q * np.linalg.det(Q)
    else:
        pose[:3, :3] = np.roll(np.eye(3), chance.integers(3), axis=0)
    pose[:3, 3] = chance.uniform(-1.0, 1.0, 3)
    return pose


def _quaternion_matrix(R: Array) -> Array:
    """Return the symmetric matrix whose greatest eigenvector is the quaternion.

    Source: Bar-Itzhack 2000, New method for extracting the quaternion from a rotation matrix.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R
    return np.array([
        [xx - yy - zz, yx + xy, zx + xz, zy - yz],
        [yx + xy, yy - xx - zz, zy + yz, xz - zx],
        [zx + xz, zy + yz, zz - xx - yy, yx - xy],
        [zy - yz, xz - zx, yx - xy, xx + yy + zz],
    ])  # fmt: skip


def _body(chance: np.random.Generator, name: str, parent: int, kind: str) -> PlacedBody:
    points = chance.uniform(-0.5, 0.5, (6, 3))
    masses = chance.uniform(0.1, 2.0, 6)
    inertial = random_pose(chance)
    about = points - masses @ points / masses.sum()
    squares = np.sum(about * about, axis=1)
    tensor = np.einsum("i,ijk->jk", masses, squares[:, None, None] * np.eye(3))
    tensor -= np.einsum("i,ij,ik->jk", masses, about, about)
    axis = chance.normal(size=3)
    return PlacedBody(
        name,
        parent,
        kind,
        random_pose(chance),
        chance.uniform(-1.0, 1.0, 3),
        axis / np.linalg.norm(axis),
        float(masses.sum()),
        inertial,
        tensor,
        random_pose(chance),
    )
