"""The motion of all bodies in base coordinates, for derivatives and the regressor."""

from dataclasses import dataclass

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.forward_kinematics import body_poses
from kindsl.mechanics.dynamics.joints import apply, apply_transposed, motion_subspaces
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import motion_cross
from kindsl.mechanics.spatial.transforms import plucker


@dataclass(frozen=True, slots=True)
class SpatialMotion:
    """Lists over bodies, the base first; vectors in base coordinates at the base's origin.

    Attributes:
        i_X_base: Motion transforms from the base to each body, shape (..., 6, 6).
        S: Unit motion of each supporting joint, shape (..., 6); zero for the base.
        v: Velocities, shape (..., 6).
        a: Accelerations less gravity's, shape (..., 6).
    """

    i_X_base: list[Array]
    S: list[Array]
    v: list[Array]
    a: list[Array]


def spatial_motion(
    bodies: Bodies, q: Array, qd: Array, qdd: Array, base_velocity: Array, base_acceleration: Array
) -> SpatialMotion:
    """Return the motion of all bodies; arguments as of `newton_euler`."""
    transforms = [
        plucker(np.swapaxes(pose[..., :3, :3], -1, -2), pose[..., :3, 3])
        for pose in body_poses(bodies, q)
    ]
    local = motion_subspaces(bodies)
    motion = SpatialMotion(transforms, [local[0]], [base_velocity], [base_acceleration])
    for i, parent in bodies.links():
        S = apply(inverse(transforms[i]), local[i])
        v_joint = S * qd[..., i - 1, None]
        motion.S.append(S)
        motion.v.append(motion.v[parent] + v_joint)
        a_joint = S * qdd[..., i - 1, None] + apply(motion_cross(motion.v[parent]), v_joint)
        motion.a.append(motion.a[parent] + a_joint)
    return motion


def inverse(transform: Array) -> Array:
    """Return the inverse of a motion transform, shape (..., 6, 6)."""
    inverted = np.zeros(transform.shape)
    for row in (slice(0, 3), slice(3, 6)):
        for column in (slice(0, 3), slice(3, 6)):
            inverted[..., row, column] = np.swapaxes(transform[..., row, column], -1, -2)
    return inverted


def in_base(i_X_base: Array, inertia: Array) -> Array:
    """Return a body's inertia (..., 6, 6) at the base's origin, in base coordinates."""
    moved: Array = np.swapaxes(i_X_base, -1, -2) @ inertia @ i_X_base
    return moved


def velocity_columns(bodies: Bodies, S: list[Array]) -> Array:
    """Return what each velocity variable moves by, as columns (..., 6, nv)."""
    columns = np.stack(S[1:], axis=-1)
    if not bodies.is_floating:
        return columns
    base = np.broadcast_to(np.eye(6), (*columns.shape[:-1], 6))
    return np.concatenate((base, columns), axis=-1)


def support_mask(bodies: Bodies, body: int) -> Array:
    """Return one for each velocity variable that moves a body, zero for the others: (nv,)."""
    first = bodies.n_velocities - bodies.n_links
    mask = np.zeros(bodies.n_velocities)
    mask[:first] = 1.0
    mask[[first + joint - 1 for joint in bodies.support(body)]] = 1.0
    return mask


def force_of(inertia: Array, v: Array, a: Array) -> Array:
    """Return the force `I a + v x* I v` of a motion, shape (..., 6)."""
    total: Array = apply(inertia, a) - apply_transposed(motion_cross(v), apply(inertia, v))
    return total
