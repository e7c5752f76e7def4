"""A mechanism in one configuration, all bodies at once in base coordinates.

With every vector in the base's coordinates, sums along the path from the base to a body, and over
the subtree that a body carries, are products with the path matrix. The number of NumPy calls then
hardly grows with the number of bodies; the number of operations grows with its square.

Source: Featherstone 2008, sec. 2.3 (base coordinates); Rodriguez, Jain, Kreutz-Delgado 1992.
"""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.forward_kinematics import body_poses
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross
from kindsl.mechanics.spatial.inertia import move_inertia, spatial_inertia


@dataclass(frozen=True, slots=True, eq=False)
class Posture:
    """The bodies in base coordinates, the base first.

    Attributes:
        bodies: The mechanism.
        path: 1 where the column's joint moves the row's body, shape (n + 1, n + 1); the base's
            column is all ones.
        poses: `base_T_body`, shape (..., n + 1, 4, 4).
        S: Motion subspaces of the supporting joints, shape (..., n + 1, 6); zero for the base.
        inertias: Spatial inertias at the base's origin, shape (..., n + 1, 6, 6).
    """

    bodies: Bodies
    path: Array
    poses: Array
    S: Array
    inertias: Array

    def carried(self, each: Array) -> Array:
        """Return the sums of what belongs to each body (..., n + 1, k, ...) over its subtree."""
        n_bodies = self.S.ndim - 1
        rows = each.reshape((*each.shape[:n_bodies], math.prod(each.shape[n_bodies:])))
        return (self.path.T @ rows).reshape(each.shape)

    def composites(self) -> Array:
        """Return the inertias of the subtrees, as if rigid, shape (..., n + 1, 6, 6)."""
        return self.carried(self.inertias)

    def velocities(self, qd: Array, base_velocity: Array) -> Array:
        """Return the bodies' spatial velocities, shape (..., n + 1, 6)."""
        return self.path @ self.along_joints(qd) + base_velocity[..., None, :]

    def along_joints(self, rates: Array) -> Array:
        """Return the motion across each joint at some rates (..., n), shape (..., n + 1, 6)."""
        across = self.S[..., 1:, :] * rates[..., None]
        return np.concatenate((np.zeros((*across.shape[:-2], 1, 6)), across), axis=-2)

    def columns(self) -> Array:
        """Return the unit motion of each velocity variable, shape (..., nv, 6)."""
        joints = self.S[..., 1:, :]
        if not self.bodies.is_floating:
            return joints
        base = np.broadcast_to(np.eye(6), (*joints.shape[:-2], 6, 6))
        return np.concatenate((base, joints), axis=-2)

    def of_columns(self, each: Array) -> Array:
        """Return what belongs to each body (..., n + 1, ...), by velocity variable."""
        return np.take(each, moved_bodies(self.bodies), axis=self.S.ndim - 2)


def posture(bodies: Bodies, q: Array) -> Posture:
    """Return a mechanism at joint positions (..., n)."""
    poses = body_poses(bodies, q)
    R, r, axis = poses[..., :3, :3], poses[..., :3, 3], poses[..., :3, 2]
    is_revolute = np.array([[kind == "revolute"] for kind in bodies.joint_kinds])
    S = np.zeros((*r.shape[:-1], 6))
    S[..., 1:, :3] = axis[..., 1:, :] * is_revolute
    S[..., 1:, 3:] = np.where(is_revolute, cross(r, axis)[..., 1:, :], axis[..., 1:, :])
    com, inertia = move_inertia(bodies.masses, bodies.coms, bodies.inertias, R, r)
    inertias = spatial_inertia(bodies.masses, com, inertia)
    return Posture(bodies, path_matrix(bodies.parents), poses, S, inertias)


@lru_cache(maxsize=64)
def path_matrix(parents: tuple[int, ...]) -> Array:
    """Return the path matrix of a tree by its parents, see `Posture`."""
    path = np.eye(len(parents) + 1)
    for link, parent in enumerate(parents, start=1):
        path[link] += path[parent]
    path.flags.writeable = False
    return path


def moved_bodies(bodies: Bodies) -> list[int]:
    """Return the body that each velocity variable moves: six times the base, then the links."""
    return [*([0] * (bodies.n_velocities - bodies.n_links)), *range(1, bodies.n_links + 1)]


def supports(bodies: Bodies) -> Array:
    """Return 1 where the column's velocity variable moves the row's body, shape (nv, nv)."""
    of = moved_bodies(bodies)
    return path_matrix(bodies.parents)[of][:, of]
