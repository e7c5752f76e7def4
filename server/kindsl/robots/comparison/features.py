"""Frames that a body's lines and points define, whatever its link frame is."""

from collections.abc import Iterator
from itertools import pairwise
from math import hypot, sqrt
from typing import NamedTuple

from kindsl.mechanics.rigid.body import (
    MassDistribution,
    eigensystem,
    second_moments_about_com,
    seen_from,
)
from kindsl.mechanics.rigid.pose import (
    IDENTITY,
    RigidPose,
    Vector3,
    cross,
    dot,
    minus,
    scaled,
    transposed,
)

_PARALLEL = 0.05
_ALIKE = 0.01
HALF_TURNS = (
    IDENTITY,
    RigidPose(((1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0)), (0.0, 0.0, 0.0)),
    RigidPose(((-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, -1.0)), (0.0, 0.0, 0.0)),
    RigidPose(((-1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0)), (0.0, 0.0, 0.0)),
)


class AxisLine(NamedTuple):
    """An axis through a point; of a sliding joint (`is_free`) only the direction counts."""

    point: Vector3
    direction: Vector3
    is_free: bool = False

    def seen_from(self, pose: RigidPose) -> "AxisLine":
        """Return the line in frame A, `pose` being its own frame in A."""
        return AxisLine(pose.point(self.point), pose.turn(self.direction), self.is_free)


def axis_of(joint_kind: str, pose: RigidPose) -> AxisLine:
    """Return the axis of a joint whose frame is at a pose."""
    x, y, z = (row[2] for row in pose.rotation)
    return AxisLine(pose.translation, (x, y, z), joint_kind == "prismatic")


class Features(NamedTuple):
    """A body's joint axes, mass, and centres of mass that it carries, in a shared order."""

    lines: tuple[AxisLine, ...]
    mass: MassDistribution
    points: tuple[Vector3, ...] = ()


def frames_of(features: Features) -> Iterator[RigidPose | None]:
    """Yield frames that the features define up to half turns; None where one is not defined.

    The order is the same for all bodies with the same number of lines.
    """
    lines, mass, points = features
    for index, line in enumerate(lines):
        yield _frame_of_line_and_point(line, mass.com) if mass.mass else None
        for other in lines[index + 1 :]:
            yield _frame_of_lines(line, other)
    yield _frame_of_mass(mass)
    for line in lines:
        yield _frame(mass.com, _principal_axis(mass), line.direction) if mass.mass else None
    for line, other in pairwise(lines):
        yield _frame(mass.com, line.direction, other.direction) if mass.mass else None
        for point in points:
            yield _frame(point, line.direction, other.direction)
    for line, point in zip(lines, points, strict=False):
        yield _frame_of_line_and_point(line, point)
    for line in lines:
        for point, second in pairwise(points):
            yield _frame(point, line.direction, minus(second, point))
        for point in points:
            if not mass.mass:
                yield from (None, None)
                continue
            yield _frame(mass.com, line.direction, minus(point, mass.com))
            yield _frame(point, _principal_axis(mass), line.direction)


def seen_features(features: Features, pose: RigidPose) -> Features:
    """Return features in frame A, `pose` being their own frame in A."""
    lines = tuple(line.seen_from(pose) for line in features.lines)
    return Features(lines, seen_from(features.mass, pose), tuple(map(pose.point, features.points)))


def _frame_of_line_and_point(line: AxisLine, point: Vector3) -> RigidPose | None:
    if line.is_free:
        return None
    foot = nearest_on(line, point)
    return _frame(foot, line.direction, minus(point, foot))


def _frame_of_lines(line: AxisLine, other: AxisLine) -> RigidPose | None:
    if line.is_free or other.is_free:
        return None
    normal = cross(line.direction, other.direction)
    between = minus(other.point, line.point)
    sine = dot(normal, normal)
    if sine < _PARALLEL**2:
        return None
    along = dot(cross(between, other.direction), normal) / sine
    return _frame(_moved(line.point, line.direction, along), line.direction, normal)


def _frame_of_mass(mass: MassDistribution) -> RigidPose | None:
    a, b, c = eigensystem(second_moments_about_com(mass))
    if not mass.mass or min(b.value - a.value, c.value - b.value) < _ALIKE * abs(c.value):
        return None
    return _frame(mass.com, c.axis, b.axis)


def _principal_axis(mass: MassDistribution) -> Vector3:
    a, b, c = eigensystem(second_moments_about_com(mass))
    return c.axis if c.value - b.value > b.value - a.value else a.axis


def _frame(origin: Vector3, along: Vector3, beside: Vector3) -> RigidPose | None:
    """Return the frame with z along one direction and x as near to another as can be."""
    across = minus(beside, scaled(along, dot(beside, along)))
    length, size = hypot(*across), hypot(*beside)
    if length <= _PARALLEL * size or length < 1e-9:
        return None
    x = scaled(across, 1.0 / length)
    return RigidPose(transposed((x, cross(along, x), along)), origin)


def nearest_on(line: AxisLine, point: Vector3) -> Vector3:
    """Return the point of a line that is nearest to another point."""
    return _moved(line.point, line.direction, dot(minus(point, line.point), line.direction))


def lines_apart(line: AxisLine, other: AxisLine) -> tuple[float, float]:
    """Return the sine of the angle between lines, and the distance of the other's point, metres."""
    sine = hypot(*cross(line.direction, other.direction))
    if line.is_free:
        return sine, 0.0
    foot = nearest_on(line, other.point)
    return sine, hypot(*minus(other.point, foot))


def second_moment_gap(one: MassDistribution, other: MassDistribution) -> float:
    """Return the greatest difference of the second moments about the centres, beside the least."""
    a, b = second_moments_about_com(one), second_moments_about_com(other)
    size = sqrt(sum(x * x for x in a)) or 1.0
    return max(abs(x - y) for x, y in zip(a, b, strict=True)) / size


def _moved(point: Vector3, direction: Vector3, way: float) -> Vector3:
    return tuple(p + way * d for p, d in zip(point, direction, strict=True))  # type: ignore[return-value]
