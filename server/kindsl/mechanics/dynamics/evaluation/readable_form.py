"""Evaluates quantities by the readable algorithms."""

from functools import partial

import numpy as np

from kindsl.mechanics.dynamics.bias_torque import bias_torque, gravity_torque
from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.chunks import evaluate_in_chunks
from kindsl.mechanics.dynamics.evaluation.request import Request
from kindsl.mechanics.dynamics.forward_dynamics import forward_dynamics
from kindsl.mechanics.dynamics.forward_kinematics import body_poses, frame_poses
from kindsl.mechanics.dynamics.inverse_dynamics import (
    floating_base_inverse_dynamics,
    inverse_dynamics,
)
from kindsl.mechanics.dynamics.joint_space_inertia import joint_space_inertia
from kindsl.mechanics.spatial.arrays import Array


def evaluate(bodies: Bodies, request: Request) -> Array:
    """Return a quantity's entries in one row per configuration, shape (..., entries).

    Raises:
        numpy.linalg.LinAlgError: If a floating base's inertia is singular.
    """
    return evaluate_in_chunks(partial(_entries, bodies), bodies.n_links, request)


def _entries(bodies: Bodies, request: Request) -> Array:
    quantity, _, joint_vectors, base_velocity, gravity = request
    q = joint_vectors[0]
    if quantity == "poses":
        poses = body_poses(bodies, q)
        named = [*poses[1:], *frame_poses(bodies, poses)]
        return np.stack(named, axis=-3).reshape((len(q), 16 * len(named)))
    if quantity == "joint_space_inertia":
        return joint_space_inertia(bodies, q).reshape((len(q), bodies.n_velocities**2))
    if quantity == "gravity_torque":
        return gravity_torque(bodies, q, gravity)
    if quantity == "bias_torque":
        return bias_torque(bodies, q, joint_vectors[1], base_velocity, gravity)
    _, qd, qdd_or_tau = joint_vectors
    if quantity == "inverse_dynamics" and not bodies.is_floating:
        return inverse_dynamics(bodies, q, qd, qdd_or_tau, gravity)
    algorithm = (
        floating_base_inverse_dynamics if quantity == "inverse_dynamics" else forward_dynamics
    )
    joints, base = algorithm(bodies, q, qd, qdd_or_tau, base_velocity, gravity)
    return np.concatenate((joints, base), axis=-1) if bodies.is_floating else joints
