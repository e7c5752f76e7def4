"""Axes of joints in XML that are unlike those of limbs which are alike in all else.

A file has axes beside frames, so that one that is wrong turns no frame.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from itertools import product as combinations

from kindsl.mechanics.rigid.pose import IDENTITY, Rotation, Vector3, dot, transposed, turned
from kindsl.robots.limbs.comparison import LimbComparison
from kindsl.robots.limbs.mounts import ALONG
from kindsl.robots.limbs.verdicts import ComparedLimbs
from kindsl.robots.limbs.weighing import LimbVerdict, MeantNumbers, Suspect

# How axes of peers are written: as seen in their frames or as they stand, in either sense.
_WAYS = tuple(combinations((True, False), (1.0, -1.0)))
# By the row: the axes that the first and the second limb would have by the other, if that is known.
_Unlike = dict[int, tuple[Vector3 | None, Vector3 | None]]


def odd_axes(limbs: ComparedLimbs, axes: Mapping[str, Vector3]) -> Iterator[LimbVerdict]:
    """Yield the one axis that keeps limbs from being alike; of a pair either may be wrong.

    Args:
        limbs: In the frames of the file.
        axes: Of the joints by what they carry, in their own frames.
    """
    read = {pair: _unlike(limb, axes) for pair, limb in limbs.pairs.items()}
    unlike = {pair: rows for pair, rows in read.items() if rows is not None}
    kin = frozenset(chain(*unlike))
    odd = [pair for pair, rows in unlike.items() if rows]
    is_whole = all(pair in unlike for pair in read if kin.issuperset(pair))
    if not is_whole or len({row for pair in odd for row in unlike[pair]}) != 1:
        return
    first = limbs.pairs[odd[0]]
    (row,) = unlike[odd[0]]
    sides = [side for side in odd[0] if odd == [pair for pair in unlike if side in pair]]
    if len(unlike) == 1 and first.how == "LR":
        both = zip(_suspects(first, row), unlike[odd[0]][row], strict=True)
        is_known = None not in unlike[odd[0]][row]
        found = [MeantNumbers(p, (axis,) if axis and is_known else ()) for p, axis in both][::-1]
        yield LimbVerdict(tuple(each.place for each in found), tuple(found), (), False)
    elif len(sides) == 1 and len(odd) > 1 and len(unlike) > len(odd):
        ways = [(pair, pair.index(sides[0])) for pair in odd]
        place = _suspects(first, row)[ways[0][1]]
        peers = tuple(_suspects(limbs.pairs[pair], row)[1 - which].link for pair, which in ways)
        meant = {unlike[pair][row][which] for pair, which in ways}
        known = [MeantNumbers(place, (axis,)) for axis in meant if axis and len(meant) == 1]
        yield LimbVerdict((place,), tuple(known), peers, True)


def _unlike(limb: LimbComparison, axes: Mapping[str, Vector3]) -> _Unlike | None:
    """Return the rows whose axes differ in the best way to read two limbs; None without one."""
    whole = (reading.conventions for reading in limb.readings() if reading.slip is None)
    return min((_unlike_in(limb, C, axes) for C in whole), key=len, default=None)


def _unlike_in(
    limb: LimbComparison, conventions: Mapping[int, Rotation], axes: Mapping[str, Vector3]
) -> _Unlike:
    both = {row: [axes.get(place.link) for place in _suspects(limb, row)] for row in conventions}
    known = {row: (a, b, conventions[row]) for row, (a, b) in both.items() if a and b}
    odd = {row: each for row, each in known.items() if not _are_parallel(*each)}
    alike = [each for row, each in known.items() if row not in odd]
    ways = [w for w in _WAYS if all(_are_same(a, _seen(w, b, C)) for a, b, C in alike)]
    return {
        row: (_agreed(ways, b, C), _agreed(ways, a, transposed(C)))
        for row, (a, b, C) in odd.items()
    }


def _agreed(ways: Sequence[tuple[bool, float]], peer: Vector3, C: Rotation) -> Vector3 | None:
    """Return the axis of a body by its peer's, None if its sense is not known."""
    seen = [_seen(way, peer, C) for way in ways]
    found = dict.fromkeys(each for each in seen if _are_parallel(each, peer, C))
    return next(iter(found)) if len(found) == 1 else None


def _seen(way: tuple[bool, float], axis: Vector3, C: Rotation) -> Vector3:
    is_turned, sense = way
    x, y, z = turned(C, axis) if is_turned else axis
    return 0.0 + sense * x, 0.0 + sense * y, 0.0 + sense * z


def _are_same(one: Vector3, other: Vector3) -> bool:
    return _are_parallel(one, other, IDENTITY.rotation) and dot(one, other) > 0.0


def _are_parallel(one: Vector3, other: Vector3, C: Rotation) -> bool:
    seen = turned(C, other)
    return dot(one, seen) ** 2 > ALONG**2 * dot(one, one) * dot(seen, seen)


def _suspects(limb: LimbComparison, row: int) -> tuple[Suspect, Suspect]:
    _, one, other = limb.rows[row]
    return Suspect(one.name, one.joint, "axis"), Suspect(other.name, other.joint, "axis")
