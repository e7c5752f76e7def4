"""What is drawn of a mechanism, as pure data: messages by key.

Marks (joints, frames, centres of mass, bodies' thickness) have the unit size that the `model`
message tells, so another size of robot changes one message. Bodies hang under their link's node,
joints' marks under their joint's, and the page places these nodes by forward kinematics.
"""

from collections.abc import Iterator

import numpy as np

from kindsl.dynamics.bodies import Bodies
from kindsl.preview.scene.ellipsoids import InertiaEllipsoids, inertia_ellipsoids
from kindsl.preview.scene.marks import (
    base_mark,
    body_marks,
    column_major,
    frame_marks,
    joint_marks,
    link_marks,
    robot_com_marks,
)
from kindsl.preview.scene.messages import Message, Messages, keyed, path_of
from kindsl.preview.scene.size import Extent, Segment, extent
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
    names = _names(bodies)
    joints = ("", *bodies.joint_names)
    masses, coms = bodies.masses.tolist(), bodies.coms.tolist()
    inertias = ellipsoids.about_com.reshape(-1, 9).tolist()
    for body, name in enumerate(names):
        is_at_rest = body == 0 and not bodies.is_floating
        yield {
            "type": "link",
            "path": path_of(tree, "links", name),
            "name": name,
            "index": body,
            "joint": joints[body],
            "mass": masses[body],
            "com": coms[body],
            "inertia": inertias[body],
            "is_consistent": is_at_rest or ellipsoids.is_consistent[body],
            **_shape(size.segments[body]),
        }
    yield from _joints(tree, bodies, names)
    yield from _frames(tree, bodies, names)


def _joints(tree: str, bodies: Bodies, names: tuple[str, ...]) -> Iterator[Message]:
    placements = column_major(homogeneous(bodies.p_R_j, bodies.p_r_j))
    for link, parent in bodies.links():
        yield {
            "type": "joint",
            "path": path_of(tree, "joints", bodies.joint_names[link - 1]),
            "name": bodies.joint_names[link - 1],
            "index": link,
            "kind": bodies.joint_kinds[link - 1],
            "predecessor": names[parent],
            "successor": names[link],
            "placement": placements[link - 1],
        }


def _frames(tree: str, bodies: Bodies, names: tuple[str, ...]) -> Iterator[Message]:
    if not bodies.frames:
        return
    R = np.stack([frame.body_R_frame for frame in bodies.frames])
    r = np.stack([frame.body_r_frame for frame in bodies.frames])
    placements = column_major(homogeneous(R, r))
    for frame, placement in zip(bodies.frames, placements, strict=True):
        yield {
            "type": "frame",
            "path": path_of(tree, "frames", frame.name),
            "name": frame.name,
            "link": names[frame.body],
            "placement": placement,
        }


def _names(bodies: Bodies) -> tuple[str, ...]:
    return (bodies.base_name, *bodies.link_names)


def _shape(segments: tuple[Segment, ...]) -> dict[str, object]:
    """Return where a link reaches to, and where its name stands: half way along its segments."""
    ends = [segment.end for segment in segments]
    share = 0.5 / len(ends) if ends else 0.0
    anchor = [share * sum(end[axis] for end in ends) for axis in range(3)]
    return {"anchor": anchor, "ends": ends}
