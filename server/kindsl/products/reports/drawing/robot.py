"""A robot on paper at zero: bodies, joints with their axes, centres of mass, frames, names."""

from collections.abc import Iterator, Mapping, Sequence

from kindsl.mechanics.rigid.pose import RigidPose, Vector3
from kindsl.products.reports.drawing.bodies import Deep, body_shapes, reach
from kindsl.products.reports.drawing.camera import HEIGHT, WIDTH, Camera, camera_for, depth
from kindsl.products.reports.drawing.shapes import Disc, Drawing, Label, Line, Spot
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.scene.size import extent
from kindsl.robots.scene.solids import NO_DOUBTS, Doubts

AXIS, COM, FRAME, NAME = "2b4562", "b8860b", "3f9a52", "33404d"
_AXIS_WIDTH, _COM_RADIUS, _FRAME_RADIUS = 1.6, 2.6, 3.0
_AXIS_LENGTH = 0.05  # of the robot's size
_FONT = 12.0
NO_COLORS: Mapping[str, str] = {}
# Parts of a picture by the name of what it is to show; bones and joints are in every one.
PRESETS = {
    "bodies": frozenset(("solids", "axes", "frames", "coms")),
    "kinematics": frozenset(("axes", "frames")),
    "inertia": frozenset(("solids", "coms")),
    "frames": frozenset(("frames",)),
    "all": frozenset(("solids", "axes", "frames", "coms")),
}


def points_of(skeleton: Linkage) -> list[Vector3]:
    """Return what a picture must show, in the base's frame."""
    poses = skeleton.zero_poses
    ends = zip(poses, extent(skeleton).segments, strict=True)
    segments = [pose.point(piece.end) for pose, own in ends for piece in own]
    frames = [poses[f.body].point(f.pose.translation) for f in skeleton.frames]
    origins = (pose.translation for pose in poses)
    return [*origins, *segments, *frames, *reach(skeleton, poses)]


def robot_drawing(
    skeleton: Linkage,
    camera: Camera | None = None,
    colors: Mapping[str, str] = NO_COLORS,
    preset: str = "bodies",
    doubts: Doubts = NO_DOUBTS,
) -> Drawing:
    """Return the picture of a robot.

    Args:
        skeleton: Its bodies.
        camera: Where it is seen from; None for one that shows all of it.
        colors: Of links and frames that are not drawn in the usual colour, `rrggbb`.
        preset: The name of what it is to show, one of `PRESETS`.
        doubts: What is doubtful about its bodies, by their names.
    """
    parts = PRESETS[preset]
    camera = camera or camera_for(points_of(skeleton))
    poses = skeleton.zero_poses
    deep = sorted(
        [
            *body_shapes(skeleton, poses, camera, colors, doubts, is_solid="solids" in parts),
            *(mark for part, mark in _marks(skeleton, poses, camera, colors) if part in parts),
        ],
        key=lambda thing: thing.depth,
    )
    labels = _labels(skeleton, poses, camera, colors)
    return Drawing(WIDTH, HEIGHT, (*(shape for thing in deep for shape in thing.shapes), *labels))


def _marks(
    skeleton: Linkage, poses: Sequence[RigidPose], camera: Camera, colors: Mapping[str, str]
) -> Iterator[tuple[str, Deep]]:
    length = _AXIS_LENGTH * extent(skeleton).size
    for link, _ in skeleton.links():
        pose = poses[link]
        tip = pose.point((0.0, 0.0, length))
        color = colors.get(skeleton.body_names[link], AXIS)
        spots = camera.spot(pose.translation), camera.spot(tip)
        yield "axes", Deep(depth(tip) + length, (Line(*spots, _AXIS_WIDTH, color),))
    for frame in skeleton.frames:
        place = poses[frame.body].point(frame.pose.translation)
        color = colors.get(frame.name, FRAME)
        disc = Disc(camera.spot(place), _FRAME_RADIUS, color)
        yield "frames", Deep(depth(place) + length, (disc,))
    first = 0 if skeleton.is_floating else 1
    for pose, body in list(zip(poses, skeleton.masses, strict=True))[first:]:
        if body.mass:
            com = pose.point(body.com)
            yield "coms", Deep(depth(com) + length, (Disc(camera.spot(com), _COM_RADIUS, COM),))


def _labels(
    skeleton: Linkage, poses: Sequence[RigidPose], camera: Camera, colors: Mapping[str, str]
) -> Iterator[Label]:
    """Yield names beside their bodies; one that would cover another is left out."""
    boxes: list[tuple[float, float, float, float]] = []
    named = [(n, pose.translation) for n, pose in zip(skeleton.body_names, poses, strict=True)]
    named += [(f.name, poses[f.body].point(f.pose.translation)) for f in skeleton.frames]
    for name, point in sorted(named, key=lambda entry: entry[0] not in colors):
        place = _beside(camera.spot(point), name)
        box = (place[0], place[1] - _FONT, place[0] + 0.6 * _FONT * len(name), place[1] + 2.0)
        if not any(_overlap(box, other) for other in boxes):
            boxes.append(box)
            yield Label(place, name, _FONT, colors.get(name, NAME))


def _beside(spot: Spot, name: str) -> Spot:
    x, y = spot
    width = 0.6 * _FONT * len(name)
    return (x + 9.0 if x + 9.0 + width < WIDTH else x - 9.0 - width), y - 6.0


def _overlap(a: tuple[float, float, float, float], b: tuple[float, float, float, float]) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
