"""Mounts of a limb's head and its peer's, at the body that carries both."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import product as combinations
from math import atan2, dist, hypot
from typing import NamedTuple

from kindsl.mechanics.rigid.pose import (
    Rotation,
    Vector3,
    cross,
    dot,
    pose_from,
    product,
    transposed,
    turned,
)
from kindsl.robots.limbs.limb import AT_ORIGIN, Body
from kindsl.robots.limbs.names import is_held

# Points that are nearer are at the same place, m: designs are written in millimetres. With half of
# it two slips of 111 that were planted are not found, with twice of it as many as with it.
SAME_PLACE = 1e-3
# The cosine of no angle between the axis of a turn and another, as far as numbers are rounded.
ALONG = 1.0 - 1e-6
# The plainest explanation first: what costs more must explain a slip more.
_TURNED, _LIKE = 0.1, 0.3

# What pairs of one robot share: a map of directions, and whether limbs are copies.
Way = tuple[Rotation, bool]


class Mount(NamedTuple):
    """A map from the head of a limb to that of its peer.

    Attributes:
        map: Of directions at the carrier.
        place: The peer's place that follows, in the carrier's frame.
        extra: Cost beforehand; the plainer the less.
        free_axis: Along which the peer may be moved, if any.
        is_copy: Whether the limb itself is not mirrored though its mount is.
    """

    map: Rotation
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
MIRRORS = (diagonal(-1.0, 1.0, 1.0), diagonal(1.0, -1.0, 1.0), diagonal(1.0, 1.0, -1.0))
_HALF_TURNS = (diagonal(1.0, -1.0, -1.0), diagonal(-1.0, 1.0, -1.0), diagonal(-1.0, -1.0, 1.0))
# How frames of peers may differ: signed permutations that keep the joint's axis up to its sign.
CONVENTIONS: list[Rotation] = []
for _x, _y, _z in combinations((1.0, -1.0), repeat=3):
    CONVENTIONS += [diagonal(_x, _y, _z), ((0.0, _x, 0.0), (_y, 0.0, 0.0), (0.0, 0.0, _z))]
REFLECTIONS = CONVENTIONS[::2]
_PROPER = [C for C in CONVENTIONS if is_proper(C)]


def mounts(how: str, one: Body, other: Body, base: Vector3 = AT_ORIGIN) -> Iterator[Mount]:
    """Yield what may take a head to its peer.

    Args:
        how: `LR` for a left and a right limb, `ROW` for two of one side, `TURN` for numbered ones,
            `HELD` for what limbs hold: it is mounted in any way, mirrored or alike.
        one: The first head.
        other: Its peer.
        base: Where the base's origin is: a left and a right limb may be mirrored there.
    """
    here, there = one.translation, other.translation
    if how == "HELD":
        yield from (Mount(turn, there, 0.0) for turn in _turns_of(one, other, CONVENTIONS))
        return
    if how == "TURN" and here == there:
        yield Mount(product(other.rotation, transposed(one.rotation)), there, 0.0)
    is_sliding = one.kind == other.kind == "prismatic"
    apart = [abs(x - y) > SAME_PLACE for x, y in zip(here, there, strict=True)]
    # Limbs of two sides that begin at one place lie in each other, but for what moves away.
    is_within = how == "LR" and not (any(apart) or is_sliding or is_held(one.name, other.name))
    for axis, mirror in enumerate(MIRRORS):
        j, k = (axis + 1) % 3, (axis + 2) % 3
        place, along = turned(mirror, here), moved(here, there, axis)
        about_base = moved(place, [2.0 * b + p for b, p in zip(base, place, strict=True)], axis)
        if dist(about_base, there) < SAME_PLACE:
            place = about_base
        if how == "ROW":
            if apart[axis] or not any(apart):
                yield from (Mount(matrix, along, 0.0, axis) for matrix in (mirror, _SAME))
            continue
        yield Mount(mirror, place, _LIKE if is_within and dist(place, there) < SAME_PLACE else 0.0)
        if how == "LR" and (is_sliding or here == there):
            # The fingers of a gripper begin at one place, and open away from each other.
            yield Mount(_HALF_TURNS[axis], here, 0.0 if is_sliding else _TURNED)
        if how == "LR" and apart[axis]:
            # The same limb at the mirrored place, on a like, a mirrored or a turned mount.
            yield Mount(mirror, place, _LIKE, is_copy=True)
            yield from (Mount(turn, place, _LIKE) for turn in (_SAME, *_HALF_TURNS))
        if how == "LR" and min(abs(here[j]), abs(here[k])) > SAME_PLACE:
            yield Mount(_HALF_TURNS[axis], turned(_HALF_TURNS[axis], here), _TURNED)
        if how == "TURN" and min(hypot(p[j], p[k]) for p in (here, there)) > SAME_PLACE:
            turn = _turn(axis, atan2(there[k], there[j]) - atan2(here[k], here[j]))
            yield Mount(turn, turned(turn, here), 0.0)
            # The place may be wrong that tells the angle, but the rotation right.
            for turn in _turns_of(one, other, _PROPER):
                place = turned(turn, here)
                if turn[axis][axis] > ALONG and dist(place, there) > SAME_PLACE:
                    yield Mount(turn, place, 0.0)


def moved(here: Sequence[float], there: Sequence[float], axis: int) -> Vector3:
    """Return a place moved to another along an axis."""
    x, y, z = (there[i] if i == axis else here[i] for i in range(3))
    return x, y, z


def _turns_of(one: Body, other: Body, conventions: Iterable[Rotation]) -> Iterator[Rotation]:
    """Yield the maps of a head's axes to its peer's, one for each convention."""
    for C in conventions:
        yield product(product(other.rotation, transposed(C)), transposed(one.rotation))


def _turn(axis: int, angle: float) -> Rotation:
    """Return a rotation about an axis."""
    x, y, z = (angle if i == axis else 0.0 for i in range(3))
    return pose_from((0.0, 0.0, 0.0), (x, y, z)).rotation
