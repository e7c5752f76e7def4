"""Shapes of the scene, and their form in meshcat's protocol, which is three.js's JSON.

The viewer's script comes with the package meshcat; its Python side starts a visualizer's worth of
imports (IPython, ZMQ, NumPy) that a picture does not need, so the few objects are written here.
"""

from array import array
from collections.abc import Sequence
from enum import Enum
from functools import cache
from itertools import chain, pairwise
from math import cos, pi, sin
from typing import Any, NamedTuple

from kindsl.mechanics.rigid.pose import Vector3

# A joint's mark and its axis stand out of the bodies, whose radius is 1.
ARROW_PROFILE = ((0.0, -3.0), (0.2, -3.0), (0.2, 5.0), (0.62, 5.0), (0.0, 7.0))
FORCE_PROFILE = ((0.0, 0.0), (0.55, 0.0), (0.55, 0.8), (1.3, 0.8), (0.0, 1.0))
SIDES = 14
AXIS_COLORS = ((0.80, 0.20, 0.20), (0.18, 0.58, 0.30), (0.18, 0.38, 0.82))
Triangle = tuple[int, int, int]


class Form(Enum):
    """The forms. Lengths are in radii of the bodies unless said otherwise."""

    BALL = "a sphere of radius 1"
    POINT = "a centre of mass: a smaller sphere"
    CYLINDER = "a cylinder along y, radius 1, height 1"
    DRUM = "a revolute joint: a cylinder along y"
    BLOCK = "a prismatic joint: a cuboid along z"
    ARROW = "a joint's axis: an arrow along z, through the origin"
    FORCE = "an arrow along z, from 0 to 1"
    TRIAD = "a frame: needles along x, y and z"
    SHORT_TRIAD = "a frame of less importance"
    SLAB = "a fixed base: a flat cuboid under the origin"


class Shape(NamedTuple):
    """A form in a colour, 0xRRGGBB. What is `on_top` is seen through other things."""

    form: Form
    color: int
    on_top: bool = False


class Mesh(NamedTuple):
    """Triangles: positions of k corners, m triples of corners, and a colour a corner or None."""

    vertices: Sequence[Vector3]
    faces: Sequence[Triangle]
    colors: Sequence[Vector3] | None = None


@cache
def lowered(shape: Shape) -> dict[str, Any]:
    """Return a shape as an object of meshcat's protocol, its numbers in typed arrays."""
    is_triad = shape.form in (Form.TRIAD, Form.SHORT_TRIAD)
    name = f"{shape.form.name}-{shape.color:06x}"
    return {
        "metadata": {"version": 4.5, "type": "Object"},
        "geometries": [{"uuid": f"{name}-geometry", **_geometry(shape.form)}],
        "materials": [
            {
                "uuid": f"{name}-material",
                "type": "MeshBasicMaterial" if is_triad else "MeshLambertMaterial",
                "color": shape.color,
                **_LOOK,
                "vertexColors": 2 if is_triad else 0,
                "depthTest": not shape.on_top,
            }
        ],
        "object": {
            "uuid": name,
            "type": "Mesh",
            "geometry": f"{name}-geometry",
            "material": f"{name}-material",
            "matrix": _IDENTITY,
        },
    }


_IDENTITY = [float(row == column) for row in range(4) for column in range(4)]
_LOOK = {
    "reflectivity": 0.5, "side": 2, "transparent": False, "opacity": 1.0, "linewidth": 1.0,
    "wireframe": False, "wireframeLinewidth": 1.0,
}  # fmt: skip


def _sphere(radius: float) -> dict[str, Any]:
    return {"type": "SphereGeometry", "radius": radius, "widthSegments": 20, "heightSegments": 20}


def _cylinder(radius: float, height: float) -> dict[str, Any]:
    size = {"radiusTop": radius, "radiusBottom": radius, "height": height}
    return {"type": "CylinderGeometry", **size, "radialSegments": 50}


def _box(width: float, height: float, depth: float) -> dict[str, Any]:
    return {"type": "BoxGeometry", "width": width, "height": height, "depth": depth}


_PRIMITIVES = {
    Form.BALL: _sphere(1.0),
    Form.POINT: _sphere(0.62),
    Form.CYLINDER: _cylinder(1.0, 1.0),
    Form.DRUM: _cylinder(1.42, 2.8),
    Form.BLOCK: _box(2.2, 2.2, 4.4),
    Form.SLAB: _box(7.0, 7.0, 1.0),
}


def _geometry(form: Form) -> dict[str, Any]:
    if form in _PRIMITIVES:
        return _PRIMITIVES[form]
    mesh = _mesh(form)
    attributes = {"position": _floats(mesh.vertices)}
    if mesh.colors is not None:
        attributes["color"] = _floats(mesh.colors)
    index = _buffer("Uint32Array", array("I", chain.from_iterable(mesh.faces)))
    return {"type": "BufferGeometry", "data": {"attributes": attributes, "index": index}}


def _floats(rows: Sequence[Vector3]) -> dict[str, Any]:
    return _buffer("Float32Array", array("f", chain.from_iterable(rows)))


def _buffer(kind: str, data: "array[Any]") -> dict[str, Any]:
    return {"itemSize": 3, "type": kind, "array": data, "normalized": False}


def _mesh(form: Form) -> Mesh:
    if form is Form.ARROW:
        return lathe(ARROW_PROFILE)
    if form is Form.FORCE:
        return lathe(FORCE_PROFILE)
    return triad(0.24, 5.0) if form is Form.TRIAD else triad(0.18, 3.6)


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
