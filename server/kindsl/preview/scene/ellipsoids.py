"""The solid ellipsoid that has a link's mass and inertia."""

from dataclasses import dataclass

import numpy as np

from kindsl.dynamics.bodies import Bodies
from kindsl.spatial.arrays import Array
from kindsl.spatial.inertia import point_inertia, second_moment

# As in Drake: an axis is never drawn thinner than this share of the largest.
THINNEST = 0.01
# A second moment may be negative by this share of the largest, which rounding explains.
TOLERANCE = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class InertiaEllipsoids:
    """Ellipsoids of all bodies, the base first.

    Attributes:
        semi_axes: Shape (n + 1, 3), metres; zeros for a body without mass or extent.
        rotations: `body_R_ellipsoid`, shape (n + 1, 3, 3).
        about_com: Inertia tensors about the centres of mass, body axes, (n + 1, 3, 3), kg m^2.
        is_consistent: Whether a rigid body with such an inertia exists, shape (n + 1,).
    """

    semi_axes: Array
    rotations: Array
    about_com: Array
    is_consistent: tuple[bool, ...]


def inertia_ellipsoids(bodies: Bodies) -> InertiaEllipsoids:
    """Return the solid ellipsoid of the same mass and inertia for each body.

    A solid ellipsoid's second moment along a semi-axis `a` is `m a^2 / 5`.
    """
    about_com = bodies.inertias - point_inertia(bodies.masses, bodies.coms)
    moments, axes = np.linalg.eigh(second_moment(about_com))
    largest = moments[:, 2]
    has_body = (bodies.masses > 0.0) & (largest > 0.0)
    mass = np.where(has_body, bodies.masses, 1.0)
    squares = np.where(has_body[:, None], 5.0 * moments / mass[:, None], 0.0)
    semi_axes = np.sqrt(np.maximum(squares, THINNEST**2 * squares[:, 2:]))
    consistent = (bodies.masses >= 0.0) & (moments[:, 0] >= -TOLERANCE * np.abs(largest))
    is_consistent = tuple(bool(value) for value in consistent)
    return InertiaEllipsoids(semi_axes, _right_handed(axes), about_com, is_consistent)


def _right_handed(axes: Array) -> Array:
    signs = np.sign(np.linalg.det(axes))
    return np.concatenate((axes[..., :2], axes[..., 2:] * signs[:, None, None]), axis=-1)
