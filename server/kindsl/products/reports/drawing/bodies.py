"""Links on paper as bodies: the outlines of their solids, of bones and of joints' drums."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from math import copysign, hypot, inf, pi
from typing import NamedTuple

from kindsl.mechanics.rigid.pose import RigidPose, Vector3, dot, transposed, turned
from kindsl.products.reports.drawing.camera import Camera, across, depth
from kindsl.products.reports.drawing.shapes import Line, Polygon, Shape, Spot
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.scene.size import Segment, extent
from kindsl.robots.scene.solids import NO_DOUBTS, Doubts, LinkSolid, link_solids

BODY, SHADED, BASE = "93a6bc", "7389a3", "56697f"
JOINTS = {"revolute": "c8752f", "prismatic": "2f8a7c"}
JUDGED = {"doubtful": "b07400", "impossible": "bf2a1c"}
EDGE = "2b3540"
_CORNERS = 48
_DIRECTIONS = [across(2.0 * pi * i / _CORNERS) for i in range(_CORNERS)]
_EDGE, _STRIPE, _APART = 1.0, 1.6, 6.0  # pixels
_DRUM, _BLOCK = 1.25, 1.6  # of a drum's radius, half its length
_GLASS = 0.4

# The farthest point in a direction, both in the coordinates of what carries it, metres.
Support = Callable[[Vector3], Vector3]


class Deep(NamedTuple):
    """Shapes that cover each other in their order, with their distance out of the sheet."""

    depth: float
    shapes: tuple[Shape, ...]


def body_shapes(
    skeleton: Linkage,
    poses: Sequence[RigidPose],
    camera: Camera,
    colors: Mapping[str, str],
    doubts: Doubts = NO_DOUBTS,
    *,
    is_solid: bool,
) -> Iterator[Deep]:
    """Yield the bodies of a robot.

    Args:
        skeleton: The robot.
        poses: Of its bodies in the base's frame.
        camera: Where it is seen from.
        colors: Of links that are not drawn in the usual colour, `rrggbb`.
        doubts: What is doubtful about them, by their names.
        is_solid: Whether solids are drawn, or bones and joints alone.
    """
    size = extent(skeleton)
    solids = link_solids(skeleton, size, doubts)
    for body, (name, solid) in enumerate(zip(skeleton.body_names, solids, strict=True)):
        own = BASE if body == 0 else SHADED if solid.is_shaded else BODY
        color = colors.get(name, JUDGED.get(solid.look, own))
        solid = solid if is_solid else solid._replace(core=None)
        yield from _link(solid, size.segments[body], poses[body], camera, color)
    for link, parent in skeleton.links():
        pose = poses[parent].then(skeleton.placements[link - 1])
        kind = skeleton.joint_kinds[link - 1]
        color = colors.get(skeleton.body_names[link], JOINTS[kind])
        yield _drum(solids[link].drum, kind, pose, camera, color)


def reach(skeleton: Linkage, poses: Sequence[RigidPose]) -> Iterator[Vector3]:
    """Yield where the solids of a robot reach to on the sheet, in the base's frame."""
    for solid, pose in zip(link_solids(skeleton, extent(skeleton)), poses, strict=True):
        if solid.core is not None and not solid.is_oversized:
            for direction in _DIRECTIONS[:: _CORNERS // 8]:
                yield _farthest(solid.core.support, pose, direction)


def _link(
    solid: LinkSolid, segments: Sequence[Segment], pose: RigidPose, camera: Camera, color: str
) -> Iterator[Deep]:
    origin = (0.0, 0.0, 0.0)
    bones = [(origin, piece.end) for piece in segments]
    if solid.strut:
        bones.append((solid.strut[0], solid.strut[1]))
    core = None if solid.is_oversized else solid.core
    front = inf if core is None else depth(pose.point(core.center))
    for start, end in bones or [(origin, origin)]:
        middle = depth(pose.point(_between(start, end)))
        outline = _outline(_capsule(start, end, solid.bone), pose, camera)
        # A bone is in its solid for the most part.
        yield Deep(min(middle, front), (Polygon(outline, color, EDGE, _EDGE),))
    if core is not None:
        yield Deep(front, _faced(_outline(core.support, pose, camera), solid, color))


def _faced(outline: tuple[Spot, ...], solid: LinkSolid, color: str) -> tuple[Shape, ...]:
    """Return a solid by its diagnosis: full, translucent, or striped."""
    if solid.look not in JUDGED:
        opacity = _GLASS if solid.look == "glass" else 1.0
        return (Polygon(outline, color, EDGE, _EDGE, opacity),)
    stripe = JUDGED[solid.look]
    edge = Polygon(outline, "ffffff", stripe, 2.0 * _EDGE, 0.25)
    return (*(Line(*ends, _STRIPE, stripe) for ends in hatching(outline)), edge)


def hatching(outline: Sequence[Spot]) -> Iterator[tuple[Spot, Spot]]:
    """Yield lines across a convex polygon, from lower left to upper right."""
    heights = [x + y for x, y in outline]
    count = int((max(heights) - min(heights)) / _APART)
    for i in range(count):
        level = min(heights) + (i + 0.5) * _APART
        crossed = [
            (ax + (bx - ax) * share, ay + (by - ay) * share)
            for (ax, ay), (bx, by) in pairwise((*outline, outline[0]))
            if ((ax + ay) < level) != ((bx + by) < level)
            for share in [(level - ax - ay) / (bx + by - ax - ay)]
        ]
        yield min(crossed), max(crossed)


def _drum(radius: float, kind: str, pose: RigidPose, camera: Camera, color: str) -> Deep:
    support = _cylinder(radius) if kind == "revolute" else _block(radius)
    outline = _outline(support, pose, camera)
    return Deep(depth(pose.translation) + radius, (Polygon(outline, color, EDGE, _EDGE),))


def _outline(support: Support, pose: RigidPose, camera: Camera) -> tuple[Spot, ...]:
    return tuple(camera.spot(_farthest(support, pose, way)) for way in _DIRECTIONS)


def _farthest(support: Support, pose: RigidPose, direction: Vector3) -> Vector3:
    return pose.point(support(turned(transposed(pose.rotation), direction)))


def _capsule(start: Vector3, end: Vector3, radius: float) -> Support:
    def support(way: Vector3) -> Vector3:
        x, y, z = end if dot(way, end) > dot(way, start) else start
        return x + radius * way[0], y + radius * way[1], z + radius * way[2]

    return support


def _cylinder(radius: float) -> Support:
    def support(way: Vector3) -> Vector3:
        x, y, z = way
        share = radius / (hypot(x, y) or 1.0)
        return share * x, share * y, copysign(_DRUM * radius, z)

    return support


def _block(half: float) -> Support:
    def support(way: Vector3) -> Vector3:
        x, y, z = way
        return copysign(half, x), copysign(half, y), copysign(_BLOCK * half, z)

    return support


def _between(a: Vector3, b: Vector3) -> Vector3:
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2
