"""The motion without inertia, where an inertia matrix is singular."""

from collections.abc import Iterable, Mapping

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.joint_space_inertia import joint_space_inertia
from kindsl.mechanics.dynamics.quantities import SingularInertiaError
from kindsl.mechanics.spatial.arrays import Array

_NEGLIGIBLE = 1e-12


def singular_inertia(bodies: Bodies, q: Array) -> SingularInertiaError:
    """Return the error that names the joint, or the base, whose motion nothing resists.

    Args:
        q: Joint positions, shape (..., n), of which at least one gives a singular matrix.
    """
    n_base = bodies.n_velocities - bodies.n_links
    with np.errstate(all="ignore"):
        matrices = joint_space_inertia(bodies, q).reshape(
            -1, bodies.n_velocities, bodies.n_velocities
        )
    if not np.isfinite(matrices).all() or not matrices.size:
        return SingularInertiaError()
    row = _unresisted_row(matrices)
    name = f"joint '{bodies.joint_names[row - n_base]}'" if row >= n_base else "the base"
    return SingularInertiaError(name)


def not_finite(bodies: Bodies, arrays: Mapping[str, Array]) -> ValueError:
    """Return the error for accelerations that are not finite.

    Args:
        arrays: The joint vectors that were given, by name, `q` among them.
    """
    with np.errstate(all="ignore"):
        matrices = joint_space_inertia(bodies, arrays["q"])
    finite = matrices[np.isfinite(matrices).all(axis=(-2, -1))]
    if (np.linalg.matrix_rank(finite) < bodies.n_velocities).any():
        return singular_inertia(bodies, arrays["q"])
    return too_large(arrays)


def too_large(names: Iterable[str]) -> ValueError:
    """Return the error for finite arguments that give nothing finite."""
    return ValueError(f"{', '.join(map(repr, names))}: the values are too large")


def _unresisted_row(matrices: Array) -> int:
    """Return the row that moves most in the motion with the least inertia of all matrices."""
    diagonals = np.abs(np.diagonal(matrices, axis1=1, axis2=2))
    largest = diagonals.max()
    lowest = diagonals.min(axis=0)
    if lowest.min() <= _NEGLIGIBLE * largest:
        return int(len(lowest) - 1 - lowest[::-1].argmin())
    values, motions = np.linalg.eigh(matrices)
    worst = int(np.abs(values).min(axis=1).argmin())
    least = int(np.abs(values[worst]).argmin())
    return int(np.abs(motions[worst][:, least]).argmax())
