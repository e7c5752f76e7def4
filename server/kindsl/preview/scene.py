"""What is drawn of a mechanism, as pure data: messages by key.

Marks (joints, frames, centres of mass, bodies' thickness) have the unit size that the `model`
message tells, so another size of robot changes one message. Bodies hang under their link's node,
joints' marks under their joint's, and the page places these nodes by forward kinematics.
"""

from collections.abc import Iterator

import numpy as np

from kindsl.dynamics.bodies import Bodies, Frame
from kindsl.preview.inertia import InertiaEllipsoids, inertia_ellipsoids
from kindsl.preview.marks import (
    base_mark,
    body_marks,
    column_major,
    frame_marks,
    joint_marks,
    link_marks,
    robot_com_marks,
)
from kindsl.preview.size import Extent, Segment, extent
from kindsl.preview.wire import Message, Messages, keyed, path_of
from kindsl.spatial.transforms import homogeneous


def robot_messages(name: str, bodies: Bodies) -> Messages:
    """Return everything that is drawn of a mechanism, and the numbers the page places it by."""
    size = extent(bodies)
    ellipsoids = inertia_ellipsoids(bodies)
    messages = [_model(name, bodies, size)]
    messages.extend(_numbers("robot", bodies, size, ellipsoids))
    messages.extend(_robot_marks(bodies, size, ellipsoids))
    return keyed(messages)


def ghost_messages(bodies: Bodies) -> Messages:
    """Return the bodies of a former version, to stand behind the present one."""
    size = extent(bodies)
    messages = list(_numbers("ghost", bodies, size, inertia_ellipsoids(bodies)))
    for link, segments in zip(_names(bodies), size.segments, strict=True):
        messages.extend(body_marks("ghost", link, segments, "body"))
    return keyed(messages)


def _model(name: str, bodies: Bodies, size: Extent) -> Message:
    return {
        "type": "model",
        "path": path_of("model"),
        "name": name,
        "is_floating": bodies.is_floating,
        "size": size.size,
        "center": size.center.tolist(),
        "ground": size.ground,
        "unit": size.radius,
    }


def _robot_marks(bodies: Bodies, size: Extent, ellipsoids: InertiaEllipsoids) -> Iterator[Message]:
    for body, link in enumerate(_names(bodies)):
        yield from body_marks("robot", link, size.segments[body], "body" if body else "base")
        yield from link_marks(link, bodies.coms[body], ellipsoids, body)
    if not bodies.is_floating:
        yield from base_mark(bodies.base_name)
    for joint, kind in zip(bodies.joint_names, bodies.joint_kinds, strict=True):
        yield from joint_marks(joint, kind)
    for frame in bodies.frames:
        yield from frame_marks(frame.name)
    yield from robot_com_marks()


def _numbers(
    tree: str, bodies: Bodies, size: Extent, ellipsoids: InertiaEllipsoids
) -> Iterator[Message]:
    """Yield what the page needs for kinematics, gravity torques and its panel."""
    for body in range(bodies.n_links + 1):
        yield _link(tree, bodies, body, size.segments[body], ellipsoids)
    for link, parent in bodies.links():
        yield _joint(tree, bodies, link, parent)
    for frame in bodies.frames:
        yield _frame(tree, frame, _names(bodies)[frame.body])


def _link(
    tree: str,
    bodies: Bodies,
    body: int,
    segments: tuple[Segment, ...],
    ellipsoids: InertiaEllipsoids,
) -> Message:
    name = _names(bodies)[body]
    is_at_rest = body == 0 and not bodies.is_floating
    return {
        "type": "link",
        "path": path_of(tree, "links", name),
        "name": name,
        "index": body,
        "joint": bodies.joint_names[body - 1] if body else "",
        "mass": float(bodies.masses[body]),
        "com": bodies.coms[body].tolist(),
        "inertia": ellipsoids.about_com[body].ravel().tolist(),
        "is_consistent": is_at_rest or ellipsoids.is_consistent[body],
        "anchor": _anchor(segments),
        "ends": [segment.end.tolist() for segment in segments],
    }


def _joint(tree: str, bodies: Bodies, link: int, parent: int) -> Message:
    name = bodies.joint_names[link - 1]
    return {
        "type": "joint",
        "path": path_of(tree, "joints", name),
        "name": name,
        "index": link,
        "kind": bodies.joint_kinds[link - 1],
        "predecessor": _names(bodies)[parent],
        "successor": _names(bodies)[link],
        "placement": column_major(homogeneous(bodies.p_R_j[link - 1], bodies.p_r_j[link - 1])),
    }


def _frame(tree: str, frame: Frame, link: str) -> Message:
    return {
        "type": "frame",
        "path": path_of(tree, "frames", frame.name),
        "name": frame.name,
        "link": link,
        "placement": column_major(homogeneous(frame.body_R_frame, frame.body_r_frame)),
    }


def _names(bodies: Bodies) -> tuple[str, ...]:
    return (bodies.base_name, *bodies.link_names)


def _anchor(segments: tuple[Segment, ...]) -> list[float]:
    """Return where a link's name stands, in its frame: half way along its segments."""
    if not segments:
        return [0.0, 0.0, 0.0]
    anchor: list[float] = (0.5 * np.mean([segment.end for segment in segments], axis=0)).tolist()
    return anchor
