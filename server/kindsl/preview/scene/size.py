"""How large a mechanism is, and where its bodies reach to: what scales the picture."""

import math
from dataclasses import dataclass
from statistics import median
from typing import NamedTuple, TypeAlias

import numpy as np

from kindsl.dynamics.bodies import Bodies
from kindsl.spatial.arrays import Array

# A body's radius is a share of the median segment, within shares of the whole robot.
RADIUS_PER_SEGMENT = 0.11
LEAST_RADIUS = 0.004
LARGEST_RADIUS = 0.020
# Radii go in steps, so that an edit of a digit does not make the whole robot breathe.
STEP = 1.1
NEGLIGIBLE = 1e-9


Point: TypeAlias = tuple[float, float, float]


class Segment(NamedTuple):
    """A straight piece of a body, from its frame's origin to `end` in its frame, metres."""

    name: str
    end: Point

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
    places = bodies.p_r_j.tolist()
    for link, parent in bodies.links():
        ends[parent].append(Segment(bodies.joint_names[link - 1], tuple(places[link - 1])))
    is_leaf = [not own for own in ends]
    for frame in bodies.frames:
        if is_leaf[frame.body]:
            ends[frame.body].append(Segment(frame.name, tuple(frame.body_r_frame.tolist())))
    drawn = [tuple(piece for piece in own if piece.length > NEGLIGIBLE) for own in ends]
    for body, is_bare in enumerate(is_leaf):
        through = Segment("com", tuple((2.0 * bodies.coms[body]).tolist()))
        if is_bare and not drawn[body] and through.length > NEGLIGIBLE:
            drawn[body] = (through,)
    return tuple(drawn)


def _points(bodies: Bodies, segments: tuple[tuple[Segment, ...], ...]) -> Array:
    """Return where bodies begin and end at the zero configuration, in the base's frame."""
    R, r = [np.eye(3)], [np.zeros(3)]
    for link, parent in bodies.links():
        R.append(R[parent] @ bodies.p_R_j[link - 1])
        r.append(R[parent] @ bodies.p_r_j[link - 1] + r[parent])
    owners = [body for body, own in enumerate(segments) for _ in own]
    if not owners:
        return np.stack(r)
    ends = np.array([piece.end for own in segments for piece in own])
    rotated = np.einsum("kij,kj->ki", np.stack(R)[owners], ends)
    return np.concatenate((np.stack(r), rotated + np.stack(r)[owners]))


def _radius(segments: tuple[tuple[Segment, ...], ...], size: float) -> float:
    lengths = [piece.length for own in segments for piece in own]
    typical = median(lengths) if lengths else size
    wanted = RADIUS_PER_SEGMENT * typical
    radius = min(max(wanted, LEAST_RADIUS * size), LARGEST_RADIUS * size)
    return float(STEP ** round(math.log(radius, STEP)))
