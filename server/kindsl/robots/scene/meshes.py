"""Triangle meshes that the viewer has no primitive for."""

from collections.abc import Sequence
from itertools import pairwise
from math import cos, pi, sin
from typing import NamedTuple

from kindsl.mechanics.rigid.pose import Vector3

SIDES = 14
AXIS_COLORS = ((0.80, 0.20, 0.20), (0.18, 0.58, 0.30), (0.18, 0.38, 0.82))

Triangle = tuple[int, int, int]


class Mesh(NamedTuple):
    """Triangles: positions of k corners, m triples of corners, and a colour a corner or None."""

    vertices: Sequence[Vector3]
    faces: Sequence[Triangle]
    colors: Sequence[Vector3] | None = None


def lathe(profile: Sequence[tuple[float, float]]) -> Mesh:
    """Return the surface that a profile of (radius, height) points sweeps about z.

    Each piece of the profile has vertices of its own, so its edges stay sharp when shaded.
    """
    angles = [2.0 * pi * side / SIDES for side in range(SIDES)]
    vertices: list[Vector3] = []
    faces: list[Triangle] = []
    for ends in pairwise(profile):
        faces += _band(len(vertices))
        for radius, height in ends:
            vertices += [(radius * cos(a), radius * sin(a), height) for a in angles]
    return Mesh(vertices, faces)


def triad(width: float, length: float) -> Mesh:
    """Return needles along x (red), y (green) and z (blue)."""
    w = width
    needle = ((0.0, w, w), (0.0, -w, w), (0.0, -w, -w), (0.0, w, -w), (length, 0.0, 0.0))
    sides = ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (0, 2, 1), (0, 3, 2))
    along_y = tuple((z, x, y) for x, y, z in needle)
    along_z = tuple((y, z, x) for x, y, z in needle)
    faces = [(a + 5 * axis, b + 5 * axis, c + 5 * axis) for axis in range(3) for a, b, c in sides]
    colors = [color for color in AXIS_COLORS for _ in needle]
    return Mesh((*needle, *along_y, *along_z), faces, colors)


def _band(first: int) -> list[Triangle]:
    """Return the triangles between two rings of corners; the lower ring begins at `first`."""
    lower, upper = [], []
    for side in range(SIDES):
        here, following = first + side, first + (side + 1) % SIDES
        lower.append((here, following, here + SIDES))
        upper.append((following, following + SIDES, here + SIDES))
    return lower + upper
