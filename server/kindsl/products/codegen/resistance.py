"""Singular mechanisms: a motion without inertia makes generated code useless."""

from collections.abc import Iterable

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.singular import singular_inertia
from kindsl.mechanics.dynamics.joint_space_inertia import joint_space_inertia
from kindsl.mechanics.dynamics.quantities import ACCELERATING
from kindsl.mechanics.spatial.arrays import Array
from kindsl.products.codegen.library import undefined

# With every variable in units of its own inertia, a worse condition is that of rounding errors.
_SINGULAR = 1e15


def refuse_unresisted(
    quantities: Iterable[str], bodies: Bodies, q: Array, *, are_chosen: bool = True
) -> None:
    """Check that all motions that quantities solve for meet some inertia.

    Args:
        quantities: Their names.
        bodies: The mechanism, with values for all parameters.
        q: Joint positions of an ordinary configuration, shape (n,).
        are_chosen: Whether others can be chosen.

    Raises:
        GenerationError: One does not; the joint, or the base, is named.
    """
    with np.errstate(all="ignore"):
        M = joint_space_inertia(bodies, q)
    if not np.isfinite(M).all():
        return
    for name in quantities:
        if magnification(name, M, bodies.n_links) > _SINGULAR:
            is_base = ACCELERATING[name] == "base"
            moving = "the base" if is_base else singular_inertia(bodies, q).moving
            raise undefined(name, f"nothing resists motion of {moving}", are_chosen=are_chosen)


def magnification(quantity: str, M: Array, n_links: int) -> float:
    """Return what a quantity magnifies rounding errors by: the condition of what it solves.

    Args:
        quantity: Its name.
        M: The joint-space inertia, a floating base's six rows and columns first.
        n_links: The number of joints.
    """
    n_base, solved = len(M) - n_links, ACCELERATING.get(quantity)
    if solved == "base":
        return _condition(M[:n_base, :n_base])
    return _condition(M) if solved else 1.0


def _condition(M: Array) -> float:
    """Return the condition of a symmetric matrix, each variable in units of its own inertia."""
    units = np.sqrt(np.abs(np.diagonal(M)))
    if not units.all():
        return np.inf
    return float(np.linalg.cond(M / np.outer(units, units))) if len(M) else 1.0
