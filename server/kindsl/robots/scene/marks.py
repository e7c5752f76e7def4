"""The marks of links, joints and frames: which shape, which colour, where."""

import math
from functools import lru_cache

from kindsl.mechanics.rigid.pose import RigidPose, Vector3, transposed
from kindsl.robots.scene.ellipsoids import InertiaEllipsoid
from kindsl.robots.scene.geometry import Form, Shape
from kindsl.robots.scene.messages import Part, SetObject, SetTransform, path_of
from kindsl.robots.scene.size import Segment

LINK = 0x8EA3BA
BASE = 0x56667A
JOINT_COLORS = {"revolute": 0xD68A34, "prismatic": 0x2F9488}
AXIS = 0x3B4450
COM = 0x2B2F36
ROBOT_COM = 0xC2334D
INERTIA = 0x7D62B8
BAD_INERTIA = 0xC0392B
TORQUE = 0xB0408F
GHOST = 0x5B7BD5
WHITE = 0xFFFFFF

SLAB, FRAME = Shape(Form.SLAB, BASE), Shape(Form.TRIAD, WHITE)
ROBOT_BALL = Shape(Form.BALL, ROBOT_COM, on_top=True)
JOINT_FORMS = {"revolute": Form.DRUM, "prismatic": Form.BLOCK}
_X, _Y, _Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
# Turns meshcat's cylinders, which lie along y, to z; blocks lie there already.
_Y_TO_Z = (*_X, 0.0, *_Z, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
JOINT_TURNS = {"revolute": _Y_TO_Z, "prismatic": (*_X, 0.0, *_Y, 0.0, *_Z, 0.0, 0.0, 0.0, 0.0, 1.0)}
# What is the same at each keystroke is made once.
_MOST_KNOWN = 1 << 12


def column_major(pose: RigidPose) -> tuple[float, ...]:
    """Return a pose as the 16 numbers of its homogeneous matrix, column by column."""
    x, y, z = transposed(pose.rotation)
    return (*x, 0.0, *y, 0.0, *z, 0.0, *pose.translation, 1.0)


@lru_cache(maxsize=_MOST_KNOWN)
def body_marks(
    tree: str, link: str, segments: tuple[Segment, ...], category: str
) -> tuple[Part, ...]:
    """Return a body: a ball at its frame's origin and a capsule along each of its segments."""
    color = GHOST if tree == "ghost" else {"base": BASE, "body": LINK}[category]
    place = (tree, "links", link, category)
    marks: list[Part] = [SetObject(path_of(*place, "ball"), Shape(Form.BALL, color))]
    for segment in segments:
        rod = path_of(*place, f"segment-{segment.name}")
        end = path_of(*place, f"end-{segment.name}")
        marks.append(SetObject(rod, Shape(Form.CYLINDER, color)))
        marks.append(SetTransform(rod, _along(segment.end)))
        marks.append(SetObject(end, Shape(Form.BALL, color)))
        marks.append(SetTransform(end, _at(segment.end)))
    return tuple(marks)


@lru_cache(maxsize=_MOST_KNOWN)
def mark(shape: Shape, *place: str) -> Part:
    """Return one shape of a robot: a frame, the slab under a fixed base, the robot's CoM."""
    return SetObject(path_of("robot", *place), shape)


@lru_cache(maxsize=_MOST_KNOWN)
def mass_marks(link: str, com: Vector3, ellipsoid: InertiaEllipsoid) -> tuple[Part, ...]:
    """Return a link's centre of mass and inertia ellipsoid, nothing without mass or extent."""
    place = ("robot", "links", link)
    if ellipsoid.semi_axes is None:
        return ()
    ball = path_of(*place, "com", "ball")
    mark = path_of(*place, "inertia", "ellipsoid")
    color = INERTIA if ellipsoid.is_consistent else BAD_INERTIA
    x, y, z = ellipsoid.semi_axes
    return (
        SetObject(ball, Shape(Form.POINT, COM, on_top=True)),
        SetTransform(ball, _at(com)),
        SetObject(mark, Shape(Form.BALL, color)),
        SetTransform(mark, (*x, 0.0, *y, 0.0, *z, 0.0, *com, 1.0)),
    )


@lru_cache(maxsize=_MOST_KNOWN)
def joint_marks(joint: str, kind: str) -> tuple[Part, ...]:
    """Return a joint: its body, its axis, its frame and the arrow of its gravity torque."""
    place = ("robot", "joints", joint)
    mark, rail = path_of(*place, kind, "mark"), path_of(*place, kind, "rail")
    marks: list[Part] = [
        SetObject(mark, Shape(JOINT_FORMS[kind], JOINT_COLORS[kind])),
        SetTransform(mark, JOINT_TURNS[kind]),
        SetObject(path_of(*place, "axis", "arrow"), Shape(Form.ARROW, AXIS)),
        SetObject(path_of(*place, "joint-frame", "triad"), Shape(Form.SHORT_TRIAD, WHITE)),
        SetObject(path_of(*place, "torque", "force"), Shape(Form.FORCE, TORQUE)),
    ]
    if kind == "prismatic":
        # The page stretches it from the joint to the link.
        marks.append(SetObject(rail, Shape(Form.CYLINDER, JOINT_COLORS[kind])))
        marks.append(SetTransform(rail, _Y_TO_Z))
    return tuple(marks)


def _at(position: Vector3) -> tuple[float, ...]:
    return (*_X, 0.0, *_Y, 0.0, *_Z, 0.0, *position, 1.0)


def _along(end: Vector3) -> tuple[float, ...]:
    """Return the transform that stretches a unit cylinder, along y, from the origin to `end`.

    In plain floats, because there is one for each body at each keystroke.
    """
    x, y, z = end
    length = math.sqrt(x * x + y * y + z * z)
    # A normal of the end: its cross product with an axis that it is not mostly along.
    normal = (-z, 0.0, x) if abs(x) > max(abs(y), abs(z)) else (0.0, z, -y)
    scale = 1.0 / math.sqrt(sum(component * component for component in normal))
    a, b, c = (scale * component for component in normal)
    third = ((b * z - c * y) / length, (c * x - a * z) / length, (a * y - b * x) / length)
    middle = (0.5 * x, 0.5 * y, 0.5 * z)
    return (a, b, c, 0.0, x, y, z, 0.0, *third, 0.0, *middle, 1.0)
