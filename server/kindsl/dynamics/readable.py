"""Evaluates quantities by the readable algorithms."""

import numpy as np

from kindsl.dynamics.bias_torque import bias_torque
from kindsl.dynamics.bodies import Bodies
from kindsl.dynamics.forward_dynamics import forward_dynamics
from kindsl.dynamics.forward_kinematics import body_poses, frame_poses
from kindsl.dynamics.gravity_torque import gravity_torque
from kindsl.dynamics.inverse_dynamics import floating_base_inverse_dynamics, inverse_dynamics
from kindsl.dynamics.joint_space_inertia import joint_space_inertia
from kindsl.dynamics.quantities import Quantity
from kindsl.spatial.arrays import Array


def evaluate(bodies: Bodies, quantity: Quantity, arguments: list[Array]) -> Array:
    """Return a quantity's entries in one row per configuration, shape (..., entries).

    Args:
        bodies: The mechanism.
        quantity: What to compute.
        arguments: As `quantities.ARGUMENTS` lists them, all with the same leading dimensions.

    Raises:
        numpy.linalg.LinAlgError: If a floating base's inertia is singular.
    """
    evaluator = {
        "poses": _poses,
        "joint_space_inertia": _joint_space_inertia,
        "inverse_dynamics": _inverse_dynamics,
        "forward_dynamics": _forward_dynamics,
        "gravity_torque": gravity_torque,
        "bias_torque": bias_torque,
    }[quantity]
    entries: Array = evaluator(bodies, *arguments)
    return entries


def _poses(bodies: Bodies, q: Array) -> Array:
    poses = body_poses(bodies, q)
    named = [*poses[1:], *frame_poses(bodies, poses)]
    return np.stack(named, axis=-3).reshape((*q.shape[:-1], 16 * len(named)))


def _joint_space_inertia(bodies: Bodies, q: Array) -> Array:
    return joint_space_inertia(bodies, q).reshape((*q.shape[:-1], bodies.n_velocities**2))


def _inverse_dynamics(
    bodies: Bodies, q: Array, qd: Array, qdd: Array, base_velocity: Array, gravity: Array
) -> Array:
    if not bodies.is_floating:
        return inverse_dynamics(bodies, q, qd, qdd, gravity)
    results = floating_base_inverse_dynamics(bodies, q, qd, qdd, base_velocity, gravity)
    return np.concatenate(results, axis=-1)


def _forward_dynamics(
    bodies: Bodies, q: Array, qd: Array, tau: Array, base_velocity: Array, gravity: Array
) -> Array:
    qdd, base_acceleration = forward_dynamics(bodies, q, qd, tau, base_velocity, gravity)
    if not bodies.is_floating:
        return qdd
    return np.concatenate((qdd, base_acceleration), axis=-1)
