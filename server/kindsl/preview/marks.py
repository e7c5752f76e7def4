"""The marks of links, joints and frames: which shape, which colour, where."""

from collections.abc import Iterator

import numpy as np

from kindsl.preview.geometry import Form, Shape
from kindsl.preview.inertia import InertiaEllipsoids
from kindsl.preview.size import Segment
from kindsl.preview.wire import Message, path_of, set_object, set_transform
from kindsl.spatial.arrays import Array

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

JOINT_FORMS = {"revolute": Form.DRUM, "prismatic": Form.BLOCK}
# Turns meshcat's cylinders, which lie along y, to z.
Y_TO_Z = (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)


def column_major(T: Array) -> tuple[float, ...]:
    """Return a homogeneous matrix (4, 4) as 16 numbers, column by column."""
    return tuple(T.ravel(order="F").tolist())


def body_marks(
    tree: str, link: str, segments: tuple[Segment, ...], category: str
) -> Iterator[Message]:
    """Yield a body: a ball at its frame's origin and a capsule along each of its segments."""
    color = GHOST if tree == "ghost" else {"base": BASE, "body": LINK}[category]
    place = (tree, "links", link, category)
    yield set_object(path_of(*place, "ball"), Shape(Form.BALL, color))
    for segment in segments:
        rod = path_of(*place, f"segment-{segment.name}")
        end = path_of(*place, f"end-{segment.name}")
        yield set_object(rod, Shape(Form.CYLINDER, color))
        yield set_transform(rod, _along(segment.end))
        yield set_object(end, Shape(Form.BALL, color))
        yield set_transform(end, _at(segment.end))


def base_mark(link: str) -> Iterator[Message]:
    """Yield the slab under a fixed base."""
    yield set_object(path_of("robot", "links", link, "base", "slab"), Shape(Form.SLAB, BASE))


def link_marks(
    link: str, com: Array, ellipsoids: InertiaEllipsoids, body: int
) -> Iterator[Message]:
    """Yield a link's frame, and if it has mass its centre of mass and inertia ellipsoid."""
    place = ("robot", "links", link)
    yield set_object(path_of(*place, "link-frame", "triad"), Shape(Form.TRIAD, WHITE))
    semi_axes = ellipsoids.semi_axes[body]
    if not semi_axes.any():
        return
    ball = path_of(*place, "com", "ball")
    yield set_object(ball, Shape(Form.POINT, COM, on_top=True))
    yield set_transform(ball, _at(com))
    ellipsoid = path_of(*place, "inertia", "ellipsoid")
    color = INERTIA if ellipsoids.is_consistent[body] else BAD_INERTIA
    yield set_object(ellipsoid, Shape(Form.BALL, color))
    yield set_transform(ellipsoid, _matrix(ellipsoids.rotations[body] * semi_axes, com))


def joint_marks(joint: str, kind: str) -> Iterator[Message]:
    """Yield a joint: its body, its axis, its frame and the arrow of its gravity torque."""
    place = ("robot", "joints", joint)
    mark = path_of(*place, kind, "mark")
    yield set_object(mark, Shape(JOINT_FORMS[kind], JOINT_COLORS[kind]))
    if kind == "revolute":
        yield set_transform(mark, Y_TO_Z)
    yield set_object(path_of(*place, "axis", "arrow"), Shape(Form.ARROW, AXIS))
    yield set_object(path_of(*place, "joint-frame", "triad"), Shape(Form.SHORT_TRIAD, WHITE))
    yield set_object(path_of(*place, "torque", "force"), Shape(Form.FORCE, TORQUE))


def frame_marks(frame: str) -> Iterator[Message]:
    """Yield an optional frame's triad."""
    path = path_of("robot", "frames", frame, "optional-frame", "triad")
    yield set_object(path, Shape(Form.TRIAD, WHITE))


def robot_com_marks() -> Iterator[Message]:
    """Yield the mark of the whole robot's centre of mass, which the page places."""
    path = path_of("robot", "total", "robot", "robot-com", "ball")
    yield set_object(path, Shape(Form.BALL, ROBOT_COM, on_top=True))


def _at(position: Array) -> tuple[float, ...]:
    return _matrix(np.eye(3), position)


def _along(end: Array) -> tuple[float, ...]:
    """Return the transform that stretches a unit cylinder, along y, from the origin to `end`."""
    length = float(np.linalg.norm(end))
    y = end / length
    helper = np.zeros(3)
    helper[int(np.argmin(np.abs(y)))] = 1.0
    x = np.cross(y, helper)
    x /= np.linalg.norm(x)
    return _matrix(np.column_stack((x, end, np.cross(x, y))), 0.5 * end)


def _matrix(columns: Array, position: Array) -> tuple[float, ...]:
    x, y, z = columns.T.tolist()
    return (*x, 0.0, *y, 0.0, *z, 0.0, *position.tolist(), 1.0)
