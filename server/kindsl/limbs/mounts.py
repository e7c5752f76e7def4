"""Mounts of a limb's head and its twin's, at the body that carries both."""

from collections.abc import Iterator, Sequence
from math import atan2, cos, hypot, sin
from typing import NamedTuple

from kindsl.limbs.limb import Body
from kindsl.rigid.pose import Rotation, Vector3, cross, dot, turned

_APART = 1e-3
# The plainest explanation first: what costs more must explain a slip more.
_MOVED_ROW, _TURNED, _MOVED, _LIKE = 0.02, 0.1, 0.1, 0.3


class Tolerance(NamedTuple):
    """The distances of equal numbers: metres, a share of the number, radians."""

    length: float
    share: float
    angle: float

    def is_same(self, here: Vector3, there: Vector3) -> bool:
        """Return whether a vector is the same as another."""
        apart = max(abs(here[0] - there[0]), abs(here[1] - there[1]), abs(here[2] - there[2]))
        return apart <= self.length or apart <= self.share * hypot(*there)


TIGHT, LOOSE = Tolerance(2e-6, 1e-5, 1e-5), Tolerance(5e-4, 0.01, 0.01)
Way = tuple[Rotation | None, bool]


class Mount(NamedTuple):
    """A map from the head of a limb to that of its twin.

    Attributes:
        map: Of directions at the carrier, None where the mounting may be any.
        place: The twin's place that follows, in the carrier's frame.
        extra: Cost beforehand; the plainer the less.
        free_axis: Along which the twin may be moved, if any.
        is_copy: Whether the limb itself is not mirrored though its mount is.
    """

    map: Rotation | None
    place: Vector3
    extra: float
    free_axis: int | None = None
    is_copy: bool = False

    @property
    def way(self) -> Way:
        """The properties that pairs of one robot share: the map, and whether it is a copy."""
        return self.map, self.is_copy


def diagonal(x: float, y: float, z: float) -> Rotation:
    """Return a diagonal matrix."""
    return (x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z)


def is_proper(matrix: Rotation) -> bool:
    """Return whether an orthogonal matrix is a rotation, no reflection."""
    return dot(matrix[0], cross(matrix[1], matrix[2])) > 0.0


_SAME = diagonal(1.0, 1.0, 1.0)
_MIRRORS = (diagonal(-1.0, 1.0, 1.0), diagonal(1.0, -1.0, 1.0), diagonal(1.0, 1.0, -1.0))
_HALF_TURNS = (diagonal(1.0, -1.0, -1.0), diagonal(-1.0, 1.0, -1.0), diagonal(-1.0, -1.0, 1.0))
# Two limbs in their holders' hands: mounted in any way, mirrored or alike.
ANY_WAY = [Mount(None, (0.0, 0.0, 0.0), 0.0, None, is_copy) for is_copy in (False, True)]


def mounts(how: str, one: Body, other: Body, tolerance: Tolerance) -> Sequence[Mount]:
    """Return what may take a head to its twin.

    Args:
        how: `LR` for a left and a right limb, `ROW` for two of one side, `TURN` for numbered ones.
        one: The first head.
        other: Its twin.
        tolerance: Of a row that is mirrored rather than moved.
    """
    here, there = one.translation, other.translation
    apart = [abs(here[axis] - there[axis]) > _APART for axis in range(3)]
    if how == "LR":
        return list(_sides(here, apart))
    if how == "ROW":
        return list(_rows(here, there, apart, tolerance))
    return list(_numbered(here, there, apart))


def _sides(here: Vector3, apart: Sequence[bool]) -> Iterator[Mount]:
    for axis, mirror in enumerate(_MIRRORS):
        place = turned(mirror, here)
        yield Mount(mirror, place, 0.0)
        if apart[axis]:
            # The same limb at the mirrored place, on a like, a mirrored or a turned mount.
            yield Mount(mirror, place, _LIKE, is_copy=True)
            for turn in (_SAME, *_HALF_TURNS):
                yield Mount(turn, place, _LIKE)
    for axis, turn in enumerate(_HALF_TURNS):
        if all(abs(here[i]) > _APART for i in range(3) if i != axis):
            yield Mount(turn, turned(turn, here), _TURNED)


def _rows(
    here: Vector3, there: Vector3, apart: Sequence[bool], tolerance: Tolerance
) -> Iterator[Mount]:
    for axis, mirror in enumerate(_MIRRORS):
        if apart[axis] or not any(apart):
            is_mirrored = tolerance.is_same((-here[axis], 0.0, 0.0), (there[axis], 0.0, 0.0))
            for matrix in (mirror, _SAME):
                extra = 0.0 if is_mirrored else _MOVED_ROW
                yield Mount(matrix, moved(here, there, axis), extra, axis)


def _numbered(here: Vector3, there: Vector3, apart: Sequence[bool]) -> Iterator[Mount]:
    for axis, mirror in enumerate(_MIRRORS):
        j, k = (axis + 1) % 3, (axis + 2) % 3
        yield Mount(mirror, turned(mirror, here), 0.0)
        if hypot(here[j], here[k]) > _APART and hypot(there[j], there[k]) > _APART:
            turn = _turn(axis, atan2(there[k], there[j]) - atan2(here[k], here[j]))
            yield Mount(turn, turned(turn, here), 0.0)
        if apart[axis]:
            yield Mount(_SAME, moved(here, there, axis), _MOVED, axis)


def moved(here: Vector3, there: Vector3, axis: int) -> Vector3:
    """Return a place moved to another along an axis."""
    x, y, z = (there[i] if i == axis else here[i] for i in range(3))
    return x, y, z


def _turn(axis: int, angle: float) -> Rotation:
    """Return a rotation about an axis."""
    c, s = cos(angle), sin(angle)
    return (
        ((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c)),
        ((c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c)),
        ((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)),
    )[axis]
