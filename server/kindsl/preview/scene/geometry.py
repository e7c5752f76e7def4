"""Shapes of the scene, and their form in meshcat's geometry classes.

`meshcat/__init__` starts a visualizer's worth of imports (IPython, ZMQ: 300 ms, 50 MB) that a
preview does not need, so the geometry module is loaded as part of a package of our own name.
"""

import importlib
import importlib.machinery
import importlib.util
import sys
from enum import Enum
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from kindsl.preview.scene.meshes import Mesh, lathe, triad

_ALIAS = "_kindsl_meshcat"

# A joint's mark and its axis stand out of the bodies, whose radius is 1.
ARROW_PROFILE = ((0.0, -3.0), (0.2, -3.0), (0.2, 5.0), (0.62, 5.0), (0.0, 7.0))
FORCE_PROFILE = ((0.0, 0.0), (0.55, 0.0), (0.55, 0.8), (1.3, 0.8), (0.0, 1.0))


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


class PreviewUnavailableError(RuntimeError):
    """Something that the preview needs is not installed; the message says what."""


@cache
def lowered(shape: Shape) -> dict[str, Any]:
    """Return a shape as an object of meshcat's wire protocol.

    Raises:
        PreviewUnavailableError: If meshcat is not installed.
    """
    g = _geometry_module()
    is_triad = shape.form in (Form.TRIAD, Form.SHORT_TRIAD)
    material = g.MeshBasicMaterial if is_triad else g.MeshLambertMaterial
    look = material(color=shape.color, vertexColors=is_triad, depthTest=not shape.on_top)
    result: dict[str, Any] = g.Mesh(_meshcat_geometry(g, shape.form), look).lower()
    return result


@cache
def viewer_script() -> Path:
    """Return the file of meshcat's viewer, without importing meshcat.

    Raises:
        PreviewUnavailableError: If meshcat is not installed.
    """
    return _meshcat_folder() / "viewer" / "dist" / "main.min.js"


def _meshcat_geometry(g: ModuleType, form: Form) -> Any:
    primitives = {
        Form.BALL: lambda: g.Sphere(1.0),
        Form.POINT: lambda: g.Sphere(0.62),
        Form.CYLINDER: lambda: g.Cylinder(1.0, 1.0),
        Form.DRUM: lambda: g.Cylinder(2.8, 1.42),
        Form.BLOCK: lambda: g.Box([2.2, 2.2, 4.4]),
        Form.SLAB: lambda: g.Box([7.0, 7.0, 1.0]),
    }
    if form in primitives:
        return primitives[form]()
    mesh = _mesh(form)
    return g.TriangularMeshGeometry(mesh.vertices, mesh.faces, mesh.colors)


def _mesh(form: Form) -> Mesh:
    if form is Form.ARROW:
        return lathe(ARROW_PROFILE)
    if form is Form.FORCE:
        return lathe(FORCE_PROFILE)
    return triad(0.24, 5.0) if form is Form.TRIAD else triad(0.18, 3.6)


@cache
def _geometry_module() -> ModuleType:
    spec = importlib.machinery.ModuleSpec(_ALIAS, None, is_package=True)
    spec.submodule_search_locations = [str(_meshcat_folder())]
    sys.modules[_ALIAS] = importlib.util.module_from_spec(spec)
    return importlib.import_module(f"{_ALIAS}.geometry")


def _meshcat_folder() -> Path:
    spec = importlib.util.find_spec("meshcat")
    if spec is None or not spec.submodule_search_locations:
        raise PreviewUnavailableError(
            "the preview needs the package 'meshcat': pip install 'kindsl[preview]'"
        )
    return Path(next(iter(spec.submodule_search_locations)))
