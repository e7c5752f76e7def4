"""How large a mechanism is, and where its bodies reach to: what scales the picture."""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from kindsl.dynamics.bodies import Bodies
from kindsl.dynamics.forward_kinematics import body_poses
from kindsl.spatial.arrays import Array

# A body's radius is a share of the median segment, within shares of the whole robot.
RADIUS_PER_SEGMENT = 0.11
LEAST_RADIUS = 0.004
LARGEST_RADIUS = 0.020
# Radii go in steps, so that an edit of a digit does not make the whole robot breathe.
STEP = 1.1
NEGLIGIBLE = 1e-9


class Segment(NamedTuple):
    """A straight piece of a body, from its frame's origin to `end` (3,) in its frame, metres."""

    name: str
    end: Array


@dataclass(frozen=True, slots=True, eq=False)
class Extent:
    """The size of a mechanism at its zero configuration.

    Attributes:
        segments: Of each body, the base first.
        size: Diagonal of the box around all bodies, metres.
        center: That box's middle in the base's frame, shape (3,).
        ground: Height of the ground, metres.
        radius: Radius to draw bodies with, metres.
    """

    segments: tuple[tuple[Segment, ...], ...]
    size: float
    center: Array
    ground: float
    radius: float


def extent(bodies: Bodies) -> Extent:
    """Measure a mechanism."""
    segments = _segments(bodies)
    points = _points(bodies, segments)
    low, high = points.min(axis=0), points.max(axis=0)
    diagonal = float(np.linalg.norm(high - low))
    size = diagonal if diagonal > NEGLIGIBLE else 1.0
    radius = _radius(segments, size)
    ground = float(low[2]) - 0.5 * radius if bodies.is_floating else min(0.0, float(low[2]))
    return Extent(segments, size, 0.5 * (low + high), ground, radius)


def _segments(bodies: Bodies) -> tuple[tuple[Segment, ...], ...]:
    """Return each body's pieces: to its joints, else to its frames, else through its CoM."""
    ends: list[list[Segment]] = [[] for _ in range(bodies.n_links + 1)]
    for link, parent in bodies.links():
        ends[parent].append(Segment(bodies.joint_names[link - 1], bodies.p_r_j[link - 1]))
    leaves = [body for body, own in enumerate(ends) if not own]
    for frame in bodies.frames:
        if frame.body in leaves:
            ends[frame.body].append(Segment(frame.name, frame.body_r_frame))
    for body in leaves:
        if not _lengths(ends[body]):
            ends[body].append(Segment("com", 2.0 * bodies.coms[body]))
    return tuple(
        tuple(segment for segment in own if np.linalg.norm(segment.end) > NEGLIGIBLE)
        for own in ends
    )


def _lengths(segments: list[Segment] | tuple[Segment, ...]) -> list[float]:
    lengths = (float(np.linalg.norm(segment.end)) for segment in segments)
    return [length for length in lengths if length > NEGLIGIBLE]


def _points(bodies: Bodies, segments: tuple[tuple[Segment, ...], ...]) -> Array:
    points = [np.zeros(3)]
    for pose, own in zip(body_poses(bodies, np.zeros(bodies.n_links)), segments, strict=True):
        points.append(pose[:3, 3])
        points.extend(pose[:3, :3] @ segment.end + pose[:3, 3] for segment in own)
    return np.array(points)


def _radius(segments: tuple[tuple[Segment, ...], ...], size: float) -> float:
    lengths = [length for own in segments for length in _lengths(own)]
    typical = float(np.median(lengths)) if lengths else size
    wanted = RADIUS_PER_SEGMENT * typical
    radius = min(max(wanted, LEAST_RADIUS * size), LARGEST_RADIUS * size)
    return float(STEP ** round(math.log(radius, STEP)))
