"""Poses in plain numbers, for the rules about geometry."""

from collections.abc import Iterator, Mapping
from math import cos, isfinite, sin
from typing import NamedTuple

from kindsl.rigid.body import Vector3
from kindsl.semantics.declarations import Declarations, Frame, Joint, Pose, Vector
from kindsl.semantics.lowering import declarations
from kindsl.semantics.parameters import island_symbols


class Placement(NamedTuple):
    """A pose in numbers: metres, and radians about x, the new y, the newer z."""

    translation: Vector3
    rotation: Vector3

    def z_axis(self) -> Vector3:
        """Return the new z axis in the old coordinates, the third column of Rx Ry Rz."""
        rx, ry, _ = self.rotation
        return sin(ry), -sin(rx) * cos(ry), cos(rx) * cos(ry)

    def applied_to(self, point: Vector3) -> Vector3:
        """Return a point of the new frame in the old coordinates."""
        rx, ry, rz = self.rotation
        x, y, z = point
        x, y = cos(rz) * x - sin(rz) * y, sin(rz) * x + cos(rz) * y
        x, z = cos(ry) * x + sin(ry) * z, -sin(ry) * x + cos(ry) * z
        y, z = cos(rx) * y - sin(rx) * z, sin(rx) * y + cos(rx) * z
        tx, ty, tz = self.translation
        return x + tx, y + ty, z + tz


def placement(pose: Pose, values: Mapping[str, float]) -> Placement | None:
    """Return a pose in numbers, None where one is missing, unbound or infinite.

    It is computed once in the life of an island that has no parameters and constants.
    """
    if pose.translation is None or pose.rotation is None:
        return None
    island = pose.translation.island
    key = "placement", pose.translation.start
    known = island.facts.get(key)
    if isinstance(known, Placement):
        return known
    translation = vector3(pose.translation, values)
    rotation = vector3(pose.rotation, values)
    if translation is None or rotation is None:
        return None
    placed = Placement(translation, rotation)
    if not any(island_symbols(island, declarations(island))):
        island.facts[key] = placed
    return placed


def vector3(vector: Vector | None, values: Mapping[str, float]) -> Vector3 | None:
    """Return three components in numbers, None where one is missing, unbound or infinite."""
    if vector is None or len(vector.components) != 3:
        return None
    first, second, third = vector.components
    x, y, z = first.value(values), second.value(values), third.value(values)
    if x is None or y is None or z is None or not isfinite(x * 0.0 + y * 0.0 + z * 0.0):
        return None
    return x, y, z


def posed(declared: Declarations) -> Iterator[Frame | Joint]:
    """Yield everything in an island that has a pose."""
    for body in declared.bodies():
        yield from body.frames
    yield from declared.joints


def rotations(declared: Declarations) -> Iterator[Vector]:
    """Yield the rotations in an island."""
    for thing in posed(declared):
        if thing.pose.rotation is not None:
            yield thing.pose.rotation


def lengths(declared: Declarations) -> Iterator[Vector]:
    """Yield the translations and centres of mass in an island."""
    for thing in posed(declared):
        if thing.pose.translation is not None:
            yield thing.pose.translation
    for body in declared.bodies():
        if body.inertia is not None and body.inertia.com is not None:
            yield body.inertia.com
