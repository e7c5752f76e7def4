"""Evaluates quantities for all bodies at once, in base coordinates: for long chains.

With every vector in the base's coordinates, sums along the path from the base to a body, and over
the subtree that a body carries, are products with the path matrix. The number of NumPy calls then
hardly grows with the number of bodies; the number of operations grows with its square.

Source: Featherstone 2008, sec. 2.3 (base coordinates); Rodriguez, Jain, Kreutz-Delgado 1992.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.chunks import evaluate_in_chunks
from kindsl.mechanics.dynamics.evaluation.request import Request
from kindsl.mechanics.dynamics.joints import (
    apply,
    motion_cross_product,
    rigid_body_force,
    solve,
    uniform_acceleration,
)
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross
from kindsl.mechanics.spatial.inertia import move_inertia, spatial_inertia
from kindsl.mechanics.spatial.transforms import homogeneous, rotation_about_z


@dataclass(frozen=True, slots=True, eq=False)
class Posture:
    """The poses of all bodies in base coordinates; the base first.

    Attributes:
        poses: `base_T_body`, shape (..., n + 1, 4, 4).
        S: Motion subspaces of the supporting joints, shape (..., n + 1, 6); zero for the base.
        inertias: Spatial inertias, shape (..., n + 1, 6, 6).
    """

    poses: Array
    S: Array
    inertias: Array


class PathForm:
    """A mechanism with the path matrix, which is 1 where the column's joint moves the row's body.

    Attributes:
        bodies: The mechanism.
        path: The path matrix, shape (n + 1, n + 1), base first.
    """

    __slots__ = ("_joint_in_parent", "_jumps", "bodies", "path")

    def __init__(self, bodies: Bodies) -> None:
        self.bodies = bodies
        self.path = np.eye(bodies.n_links + 1)
        for link, parent in bodies.links():
            self.path[link] += self.path[parent]
        self._joint_in_parent = homogeneous(bodies.p_R_j, bodies.p_r_j)
        self._jumps = _jumps(bodies)

    def evaluate(self, request: Request) -> Array:
        """Return a quantity's entries in one row per configuration, shape (..., entries).

        Raises:
            numpy.linalg.LinAlgError: If an inertia is singular.
        """
        return evaluate_in_chunks(self._entries, self.bodies.n_links, request)

    def _entries(self, request: Request) -> Array:
        quantity, _, joint_vectors, base_velocity, gravity = request
        q, weight = joint_vectors[0], uniform_acceleration(gravity)
        if quantity == "poses":
            return self._named_poses(self._poses(q))
        state = self._state(q)
        if quantity == "joint_space_inertia":
            return self._joint_space_inertia(state).reshape((len(q), self.bodies.n_velocities**2))
        rest = np.zeros_like(q)
        if quantity == "gravity_torque":
            return self._forces(state, rest, rest, np.zeros(6), -weight)
        qd = joint_vectors[1]
        if quantity == "bias_torque":
            return self._forces(state, qd, rest, base_velocity, -weight)
        if quantity == "forward_dynamics":
            return self._forward_dynamics(state, qd, joint_vectors[2], base_velocity, weight)
        qdd = joint_vectors[2]
        if not self.bodies.is_floating:
            return self._forces(state, qd, qdd, base_velocity, -weight)
        forces = self._forces(state, qd, qdd, base_velocity, np.zeros(6))
        M = self._joint_space_inertia(state)
        base = -solve(M[..., :6, :6], forces[..., :6])
        tau = forces[..., 6:] + apply(M[..., 6:, :6], base)
        return np.concatenate((tau, base + weight), axis=-1)

    def _poses(self, q: Array) -> Array:
        n = self.bodies.n_links
        is_revolute = np.array([kind == "revolute" for kind in self.bodies.joint_kinds])
        joint_T_link = homogeneous(rotation_about_z(q * is_revolute), np.zeros((n, 3)))
        joint_T_link[..., 2, 3] = q * ~is_revolute
        poses = np.empty((*q.shape[:-1], n + 1, 4, 4))
        poses[..., 0, :, :] = np.eye(4)
        poses[..., 1:, :, :] = self._joint_in_parent @ joint_T_link
        # Each jump doubles the length of the path that a pose spans.
        for links, ancestors in self._jumps:
            poses[..., links, :, :] = poses[..., ancestors, :, :] @ poses[..., links, :, :]
        return poses

    def _named_poses(self, poses: Array) -> Array:
        frames = [
            poses[..., frame.body, :, :] @ homogeneous(frame.body_R_frame, frame.body_r_frame)
            for frame in self.bodies.frames
        ]
        links = poses[..., 1:, :, :]
        named = np.concatenate((links, np.stack(frames, axis=-3)), axis=-3) if frames else links
        return named.reshape((len(poses), 16 * named.shape[-3]))

    def _state(self, q: Array) -> Posture:
        poses = self._poses(q)
        R, r, axis = poses[..., :3, :3], poses[..., :3, 3], poses[..., :3, 2]
        is_revolute = np.array([[kind == "revolute"] for kind in self.bodies.joint_kinds])
        S = np.zeros((*r.shape[:-1], 6))
        S[..., 1:, :3] = axis[..., 1:, :] * is_revolute
        S[..., 1:, 3:] = np.where(is_revolute, cross(r, axis)[..., 1:, :], axis[..., 1:, :])
        masses = self.bodies.masses
        com, inertia = move_inertia(masses, self.bodies.coms, self.bodies.inertias, R, r)
        return Posture(poses, S, spatial_inertia(masses, com, inertia))

    def _forces(
        self, state: Posture, qd: Array, qdd: Array, base_velocity: Array, base_acceleration: Array
    ) -> Array:
        """Return the forces of a motion, shape (..., nv); accelerations are less gravity's."""
        v_joint, a_joint = np.zeros_like(state.S), np.zeros_like(state.S)
        v_joint[..., 1:, :] = state.S[..., 1:, :] * qd[..., None]
        v = self.path @ v_joint + base_velocity[..., None, :]
        a_joint[..., 1:, :] = state.S[..., 1:, :] * qdd[..., None]
        a_joint += motion_cross_product(v, v_joint)
        a = self.path @ a_joint + base_acceleration[..., None, :]
        f = self.path.T @ rigid_body_force(state.inertias, v, a)
        tau = np.sum(state.S * f, axis=-1)[..., 1:]
        if self.bodies.drives is not None:
            tau = tau + self.bodies.drives.force(qd, qdd)
        if not self.bodies.is_floating:
            return np.asarray(tau)
        return np.concatenate((f[..., 0, :], tau), axis=-1)

    def _joint_space_inertia(self, state: Posture) -> Array:
        shape = state.inertias.shape
        composite = (self.path.T @ state.inertias.reshape((*shape[:-2], 36))).reshape(shape)
        f = apply(composite, state.S)
        lower = (f @ np.swapaxes(state.S, -1, -2) * self.path)[..., 1:, 1:]
        between_joints = lower + np.swapaxes(np.tril(lower, -1), -1, -2)
        if self.bodies.drives is not None:
            between_joints = between_joints + np.diag(self.bodies.drives.armature)
        if not self.bodies.is_floating:
            return np.asarray(between_joints)
        base = f[..., 1:, :]
        upper = np.concatenate((composite[..., 0, :, :], np.swapaxes(base, -1, -2)), axis=-1)
        return np.concatenate((upper, np.concatenate((base, between_joints), axis=-1)), axis=-2)

    def _forward_dynamics(
        self, state: Posture, qd: Array, tau: Array, base_velocity: Array, weight: Array
    ) -> Array:
        M, rest = self._joint_space_inertia(state), np.zeros_like(qd)
        if not self.bodies.is_floating:
            return solve(M, tau - self._forces(state, qd, rest, base_velocity, -weight))
        bias = self._forces(state, qd, rest, base_velocity, np.zeros(6))
        free = np.concatenate((np.zeros((len(tau), 6)), tau), axis=-1)
        a = solve(M, free - bias)
        return np.concatenate((a[..., 6:], a[..., :6] + weight), axis=-1)


def _jumps(bodies: Bodies) -> list[tuple[npt.NDArray[np.intp], npt.NDArray[np.intp]]]:
    """Return, by step, the links whose pose does not start at the base yet, and where it does."""
    ancestors = np.array([0, *bodies.parents])
    jumps = []
    while ancestors.any():
        links = np.flatnonzero(ancestors)
        jumps.append((links, ancestors[links]))
        ancestors = ancestors[ancestors]
    return jumps
