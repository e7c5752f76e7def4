"""What may take the head of a limb to that of its twin, at the body that carries both."""

from collections.abc import Iterator
from math import atan2, cos, hypot, sin

from kindsl.limbs.conventions import IDENTITY, ORIGIN, Mount, Tolerance, diagonal
from kindsl.limbs.limb import Body
from kindsl.rigid.pose import Rotation, Vector3, turned

# Two limbs in their holders' hands: mounted in any way, mirrored or alike.
ANY_WAY = (
    Mount(None, ORIGIN, 0.0),
    Mount(None, ORIGIN, 0.0, is_copy=True),
)

_MIRRORS = (diagonal(-1.0, 1.0, 1.0), diagonal(1.0, -1.0, 1.0), diagonal(1.0, 1.0, -1.0))
_HALF_TURNS = (diagonal(1.0, -1.0, -1.0), diagonal(-1.0, 1.0, -1.0), diagonal(-1.0, -1.0, 1.0))
_APART = 1e-3
# The plainest explanation first: what costs more must explain a slip more.
_MOVED_ROW, _TURNED, _MOVED, _LIKE = 0.02, 0.1, 0.1, 0.3


def mounts(how: str, one: Body, other: Body, tolerance: Tolerance) -> list[Mount]:
    """Return what may take a head to its twin, the plainest first.

    Args:
        how: `LR` for a left and a right limb, `ROW` for two of one side, `TURN` for numbered ones.
        one: The first head.
        other: Its twin.
        tolerance: Of a row that is mirrored rather than moved.
    """
    if how == "LR":
        found = _sides(one, other)
    else:
        found = _rows(one, other, tolerance) if how == "ROW" else _numbered(one, other)
    return sorted(found, key=lambda mount: mount.extra)


def _sides(one: Body, other: Body) -> Iterator[Mount]:
    here = one.translation
    for axis, mirror in enumerate(_MIRRORS):
        place = turned(mirror, here)
        yield Mount(mirror, place, 0.0)
        if _is_apart(one, other, axis):
            # The same limb at the mirrored place, on a like, a mirrored or a turned mount.
            yield Mount(IDENTITY, place, _LIKE)
            yield Mount(mirror, place, _LIKE, is_copy=True)
            for turn in _HALF_TURNS:
                yield Mount(turn, place, _LIKE)
    for axis, turn in enumerate(_HALF_TURNS):
        if all(abs(here[i]) > _APART for i in range(3) if i != axis):
            yield Mount(turn, turned(turn, here), _TURNED)


def _rows(one: Body, other: Body, tolerance: Tolerance) -> Iterator[Mount]:
    here, there = one.translation, other.translation
    is_anywhere_apart = any(_is_apart(one, other, axis) for axis in range(3))
    for axis, mirror in enumerate(_MIRRORS):
        if _is_apart(one, other, axis) or not is_anywhere_apart:
            is_mirrored = tolerance.is_same((-here[axis], 0.0, 0.0), (there[axis], 0.0, 0.0))
            extra = 0.0 if is_mirrored else _MOVED_ROW
            place = _moved(here, there, axis)
            yield Mount(mirror, place, extra, axis)
            yield Mount(IDENTITY, place, extra, axis)


def _numbered(one: Body, other: Body) -> Iterator[Mount]:
    here, there = one.translation, other.translation
    for mirror in _MIRRORS:
        yield Mount(mirror, turned(mirror, here), 0.0)
    for axis in range(3):
        j, k = (axis + 1) % 3, (axis + 2) % 3
        if hypot(here[j], here[k]) > _APART and hypot(there[j], there[k]) > _APART:
            turn = _turn(axis, atan2(there[k], there[j]) - atan2(here[k], here[j]))
            yield Mount(turn, turned(turn, here), 0.0)
        if _is_apart(one, other, axis):
            place = _moved(here, there, axis)
            yield Mount(IDENTITY, place, _MOVED, axis)


def _is_apart(one: Body, other: Body, axis: int) -> bool:
    return abs(one.translation[axis] - other.translation[axis]) > _APART


def _moved(here: Vector3, there: Vector3, axis: int) -> Vector3:
    x, y, z = (there[i] if i == axis else here[i] for i in range(3))
    return x, y, z


def _turn(axis: int, angle: float) -> Rotation:
    rows = [[0.0] * 3 for _ in range(3)]
    j, k = (axis + 1) % 3, (axis + 2) % 3
    rows[axis][axis] = 1.0
    rows[j][j] = rows[k][k] = cos(angle)
    rows[j][k], rows[k][j] = -sin(angle), sin(angle)
    (a, b, c), (d, e, f), (g, h, i) = rows
    return (a, b, c), (d, e, f), (g, h, i)
