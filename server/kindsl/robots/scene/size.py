"""The size of a mechanism and the reach of its bodies, which scale the picture."""

import math
from dataclasses import dataclass
from statistics import median
from typing import Annotated, NamedTuple

from kindsl.mechanics.rigid.pose import Vector3
from kindsl.robots.mechanism.linkage import Linkage

# A body's radius is a share of the median segment, within shares of the whole robot.
RADIUS_PER_SEGMENT = 0.11
LEAST_RADIUS = 0.004
LARGEST_RADIUS = 0.020
# Radii go in steps, so that an edit of a digit does not make the whole robot breathe.
STEP = 1.1
NEGLIGIBLE = 1e-9


class Segment(NamedTuple):
    """A straight piece of a body, from its frame's origin."""

    name: Annotated[str, "the joint or frame that it goes to, else `com`"]
    end: Annotated[Vector3, "in the body's frame, metres"]

    @property
    def length(self) -> float:
        """Metres."""
        return math.hypot(*self.end)


@dataclass(frozen=True, slots=True, eq=False)
class Extent:
    """The size of a mechanism at its zero configuration.

    Attributes:
        segments: Of each body, the base first.
        size: Diagonal of the box around all bodies, metres.
        center: That box's middle in the base's frame, metres.
        ground: Height of the ground, metres.
        radius: Radius to draw bodies with, metres.
    """

    segments: tuple[tuple[Segment, ...], ...]
    size: float
    center: Vector3
    ground: float
    radius: float


def extent(skeleton: Linkage) -> Extent:
    """Measure a mechanism."""
    segments = _segments(skeleton)
    xs, ys, zs = zip(*_points(skeleton, segments), strict=True)
    low, high = (min(xs), min(ys), min(zs)), (max(xs), max(ys), max(zs))
    diagonal = math.dist(low, high)
    size = diagonal if diagonal > NEGLIGIBLE else 1.0
    radius = _radius(segments, size)
    ground = low[2] - 0.5 * radius if skeleton.is_floating else min(0.0, low[2])
    x, y, z = (0.5 * (a + b) for a, b in zip(low, high, strict=True))
    return Extent(segments, size, (x, y, z), ground, radius)


def _segments(skeleton: Linkage) -> tuple[tuple[Segment, ...], ...]:
    """Return each body's pieces: to its joints, else to its frames, else through its CoM."""
    ends: list[list[Segment]] = [[] for _ in skeleton.body_names]
    for link, parent in skeleton.links():
        place = skeleton.placements[link - 1].translation
        ends[parent].append(Segment(skeleton.joint_names[link - 1], place))
    is_leaf = [not own for own in ends]
    for frame in skeleton.frames:
        if is_leaf[frame.body]:
            ends[frame.body].append(Segment(frame.name, frame.pose.translation))
    drawn = [tuple(piece for piece in own if piece.length > NEGLIGIBLE) for own in ends]
    for body, is_bare in enumerate(is_leaf):
        x, y, z = skeleton.masses[body].com
        through = Segment("com", (2.0 * x, 2.0 * y, 2.0 * z))
        if is_bare and not drawn[body] and through.length > NEGLIGIBLE:
            drawn[body] = (through,)
    return tuple(drawn)


def _points(skeleton: Linkage, segments: tuple[tuple[Segment, ...], ...]) -> list[Vector3]:
    """Return where bodies begin and end at the zero configuration, in the base's frame."""
    poses = skeleton.zero_poses
    ends = [pose.point(s.end) for pose, own in zip(poses, segments, strict=True) for s in own]
    return [*(pose.translation for pose in poses), *ends]


def _radius(segments: tuple[tuple[Segment, ...], ...], size: float) -> float:
    lengths = [piece.length for own in segments for piece in own]
    typical = median(lengths) if lengths else size
    wanted = RADIUS_PER_SEGMENT * typical
    radius = min(max(wanted, LEAST_RADIUS * size), LARGEST_RADIUS * size)
    return float(STEP ** round(math.log(radius, STEP)))
