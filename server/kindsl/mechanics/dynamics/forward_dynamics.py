"""Forward dynamics by articulated bodies, or by the joint-space inertia of a few configurations."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.inverse_dynamics import newton_euler
from kindsl.mechanics.dynamics.joint_space_inertia import inertia_of
from kindsl.mechanics.dynamics.joints import (
    apply,
    apply_transposed,
    body_inertias,
    link_transforms,
    motion_cross_product,
    motion_subspaces,
    rigid_body_force,
    solve,
    uniform_acceleration,
)
from kindsl.mechanics.dynamics.posture import Posture
from kindsl.mechanics.spatial.arrays import Array


def forward_dynamics(
    bodies: Bodies,
    q: Array,
    qd: Array,
    tau: Array,
    base_velocity: Array,
    gravity: Array,
    external: Array | None = None,
) -> tuple[Array, Array]:
    """Return the accelerations of joints and base under given joint forces.

    Args:
        bodies: The mechanism.
        q: Joint positions, shape (..., n), radians and metres.
        qd: Joint velocities, shape (..., n).
        tau: Joint forces, shape (..., n), N m and N.
        base_velocity: Spatial velocity of the base, shape (..., 6), zero if it is fixed.
        gravity: Shape (..., 3), m/s^2, base coordinates.
        external: The wrench on each body at its origin in its coordinates, shape (..., n + 1, 6).

    Returns:
        `qdd` (..., n), and the base's spatial acceleration (..., 6), gravity's effect included.

    Raises:
        numpy.linalg.LinAlgError: If a floating base's articulated inertia is singular.

    Source: Featherstone 2008, table 7.1 and table 9.4.
    """
    X, S, I_A = link_transforms(bodies, q), motion_subspaces(bodies), body_inertias(bodies)
    # Outward: velocities, and the forces at zero acceleration.
    v = [base_velocity]
    c: dict[int, Array] = {}
    p_A = [rigid_body_force(I_A[0], v[0], np.zeros(6))]
    for i, parent in bodies.links():
        v_joint = S[i] * qd[..., i - 1, None]
        v.append(apply(X[i], v[parent]) + v_joint)
        c[i] = motion_cross_product(v[i], v_joint)
        p_A.append(rigid_body_force(I_A[i], v[i], np.zeros(6)))
    if external is not None:
        p_A = [p - external[..., body, :] for body, p in enumerate(p_A)]
    drives = bodies.drives
    if drives is not None:
        tau = tau - drives.force(qd, np.zeros_like(qd))
    # Inward: what each joint lets through of the inertia and the force behind it.
    U: dict[int, Array] = {}
    D: dict[int, Array] = {}
    u: dict[int, Array] = {}
    for i, parent in bodies.links_leaves_first():
        U[i] = I_A[i] @ S[i]
        D[i] = U[i] @ S[i] + (drives.armature[i - 1] if drives is not None else 0.0)
        u[i] = tau[..., i - 1] - p_A[i] @ S[i]
        I_a = I_A[i] - U[i][..., :, None] * (U[i] / D[i][..., None])[..., None, :]
        p_a = p_A[i] + apply(I_a, c[i]) + U[i] * (u[i] / D[i])[..., None]
        I_A[parent] = I_A[parent] + np.swapaxes(X[i], -1, -2) @ I_a @ X[i]
        p_A[parent] = p_A[parent] + apply_transposed(X[i], p_a)
    # Outward: accelerations, relative to gravity.
    free_fall = uniform_acceleration(gravity)
    if bodies.is_floating:
        a = [-solve(I_A[0], p_A[0])]
    else:
        a = [-free_fall]
    joint_accelerations = []
    for i, parent in bodies.links():
        a_i = apply(X[i], a[parent]) + c[i]
        qdd_i = (u[i] - np.sum(U[i] * a_i, axis=-1)) / D[i]
        joint_accelerations.append(qdd_i)
        a.append(a_i + S[i] * qdd_i[..., None])
    return np.stack(joint_accelerations, axis=-1), a[0] + free_fall


def accelerations_by_inertia(
    state: Posture,
    qd: Array,
    tau: Array,
    base_velocity: Array,
    gravity: Array,
    external: Array | None = None,
) -> tuple[Array, Array]:
    """Return all accelerations (..., nv), a floating base's first, and the joint-space inertia.

    Of a chain of 100 links this takes a tenth of the time of `forward_dynamics` for one
    configuration, the same for fifty, and more for larger batches.

    Args:
        state: The mechanism in its configuration; the others are those of `forward_dynamics`.
        qd: Joint velocities.
        tau: Joint forces.
        base_velocity: Spatial velocity of the base.
        gravity: In base coordinates.
        external: The wrench on each body.

    Raises:
        numpy.linalg.LinAlgError: If nothing resists some motion.

    Source: Featherstone 2008, sec. 6.1.
    """
    first = state.bodies.n_velocities - state.bodies.n_links
    rest, weight = np.zeros_like(qd), uniform_acceleration(gravity)
    M = inertia_of(state)
    start = -weight if not first else np.zeros_like(weight)
    bias = newton_euler(state, qd, rest, base_velocity, start, external)
    forces = np.concatenate((np.zeros((*tau.shape[:-1], first)), tau), axis=-1)
    accelerations = solve(M, forces - bias)
    accelerations[..., :first] += weight[..., :first]
    return accelerations, M
