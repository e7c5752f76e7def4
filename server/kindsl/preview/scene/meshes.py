"""Triangle meshes that meshcat has no primitive for."""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from kindsl.spatial.arrays import Array

SIDES = 14
AXIS_COLORS = ((0.80, 0.20, 0.20), (0.18, 0.58, 0.30), (0.18, 0.38, 0.82))


class Mesh(NamedTuple):
    """Triangles: positions (k, 3), indices of corners (m, 3), and colours (k, 3) or None."""

    vertices: Array
    faces: Array
    colors: Array | None = None


def lathe(profile: Sequence[tuple[float, float]]) -> Mesh:
    """Return the surface that a profile of (radius, height) points sweeps about z.

    Each piece of the profile has vertices of its own, so its edges stay sharp when shaded.
    """
    angles = np.linspace(0.0, 2.0 * np.pi, SIDES, endpoint=False)
    circle = np.column_stack((np.cos(angles), np.sin(angles)))
    rings, faces = [], []
    for piece, ends in enumerate(pairwise(profile)):
        for radius, height in ends:
            rings.append(np.column_stack((radius * circle, np.full(SIDES, height))))
        faces.append(_band(2 * SIDES * piece))
    return Mesh(np.concatenate(rings), np.concatenate(faces))


def triad(width: float, length: float) -> Mesh:
    """Return needles along x (red), y (green) and z (blue)."""
    base = width * np.array([[0, 1, 1], [0, -1, 1], [0, -1, -1], [0, 1, -1]], dtype=float)
    needle = np.vstack((base, [[length, 0.0, 0.0]]))
    sides = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [0, 2, 1], [0, 3, 2]])
    axes = [np.roll(needle, axis, axis=1) for axis in range(3)]
    faces = [sides + 5 * axis for axis in range(3)]
    colors = np.repeat(np.array(AXIS_COLORS), len(needle), axis=0)
    return Mesh(np.vstack(axes), np.vstack(faces), colors)


def _band(first: int) -> Array:
    here = first + np.arange(SIDES)
    following = first + (np.arange(SIDES) + 1) % SIDES
    lower = np.column_stack((here, following, here + SIDES))
    upper = np.column_stack((following, following + SIDES, here + SIDES))
    return np.vstack((lower, upper))
