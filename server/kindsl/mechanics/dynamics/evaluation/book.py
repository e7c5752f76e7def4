"""Evaluates quantities by the book's algorithms, which share no code with what is generated."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.forward_dynamics import forward_dynamics
from kindsl.mechanics.dynamics.forward_kinematics import body_poses, frame_poses
from kindsl.mechanics.dynamics.inverse_dynamics import floating_base_inverse_dynamics, newton_euler
from kindsl.mechanics.dynamics.joint_space_inertia import inertia_of
from kindsl.mechanics.dynamics.joints import uniform_acceleration
from kindsl.mechanics.dynamics.posture import posture
from kindsl.mechanics.spatial.arrays import Array

# The working set is some dozens of 6x6 matrices per body and configuration; of 500 to 20,000 bodies
# this takes the least time for a chain of 100.
BODIES_AT_A_TIME = 5_000


class Request(NamedTuple):
    """A quantity for a batch of configurations.

    Attributes:
        function: The name of the generated function that computes it.
        batch_shape: Common shape of the leading dimensions of all vectors.
        vectors: What it depends on by the names that generated functions have for it: joint vectors
            (..., n), `v0` and `g`, and where they are given `a0` and `fext` (..., 6 (n + 1)).
    """

    function: str
    batch_shape: tuple[int, ...]
    vectors: Mapping[str, Array]


def rows_of(vector: Array, batch_shape: tuple[int, ...]) -> Array:
    """Return the vector of each configuration of a batch in a row."""
    components = vector.shape[-1]
    return np.broadcast_to(vector, (*batch_shape, components)).reshape((-1, components))


def evaluate(bodies: Bodies, request: Request) -> Array:
    """Return a quantity's entries in one row per configuration, shape (*batch_shape, entries).

    Raises:
        numpy.linalg.LinAlgError: If a floating base's inertia is singular.
    """
    shape = request.batch_shape
    rows = {name: rows_of(vector, shape) for name, vector in request.vectors.items()}
    size, chunk = len(rows["q"]), max(1, BODIES_AT_A_TIME // bodies.n_links)
    entries = []
    # A batch without rows is computed once: only the result says how long rows are.
    for start in range(0, max(1, size), chunk):
        part = {name: row[start : start + chunk] for name, row in rows.items()}
        entries.append(_entries(bodies, request.function, part))
    joined = np.concatenate(entries)
    return joined.reshape((*shape, joined.shape[-1]))


def _entries(bodies: Bodies, function: str, x: dict[str, Array]) -> Array:
    q, v0, rest = x["q"], x["v0"], np.zeros_like(x["q"])
    if function == "poses":
        poses = body_poses(bodies, q)
        named = np.concatenate((poses[:, 1:], frame_poses(bodies, poses)), axis=1)
        return named.reshape((len(q), 16 * named.shape[1]))
    state, weight = posture(bodies, q), uniform_acceleration(x["g"])
    if function == "joint_space_inertia":
        return inertia_of(state).reshape((len(q), bodies.n_velocities**2))
    if function == "gravity_torque":
        return newton_euler(state, rest, rest, np.zeros(6), -weight)
    qd = x["qd"]
    if function == "bias_torque":
        return newton_euler(state, qd, rest, v0, -weight)
    external = x["fext"].reshape((len(q), bodies.n_links + 1, 6)) if "fext" in x else None
    if function == "forward_dynamics":
        found, _ = forward_dynamics(state, qd, x["tau"], v0, x["g"], external)
    elif function == "inverse_dynamics" and bodies.is_floating:
        tau, base = floating_base_inverse_dynamics(state, qd, x["qdd"], v0, x["g"], external)
        return np.concatenate((tau, base), axis=-1)
    else:
        found = newton_euler(state, qd, x["qdd"], v0, x.get("a0", 0.0) - weight, external)
    return np.roll(found, -6, axis=-1) if bodies.is_floating else found
