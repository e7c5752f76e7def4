"""The way from a limb to its twin, and the single triple of numbers that prevents it.

Frames of twins differ by a convention C, `x_one = C x_other`: a signed permutation that keeps the
joint's axis z up to its sign. Conventions are hidden, poses are seen. At the head a mount tells the
convention; below, a rotation hands the parent's on to the link, `C = R_one' C_parent R_other`, and
a translation agrees where it is `C_parent' p_one`. One triple may break this: behind a rotation
that is wrong any convention may follow.
"""

from collections.abc import Iterator, Sequence
from math import hypot
from typing import NamedTuple

from kindsl.limbs.limb import Match
from kindsl.limbs.mounts import CONVENTIONS, Mount, is_proper, mounts
from kindsl.rigid.pose import IDENTITY, Rotation, Vector3, product, transposed, turned

_SEEN = 1e-3
_KNOWN = frozenset(CONVENTIONS)
_ALIKE = {kind: [C for C in CONVENTIONS if is_proper(C) == kind] for kind in (True, False)}
# The row and the triple (`translation`, `angles`) that is wrong, if one is.
_Slip = tuple[int, str] | None
_Way = tuple[dict[int, Rotation], _Slip]


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


class Reading(NamedTuple):
    """A way to read a limb as its twin.

    Attributes:
        mount: What takes head to head.
        conventions: Of each row.
        slip: The row and the triple (`translation`, `angles`) that is wrong then, if one is.
    """

    mount: Mount
    conventions: dict[int, Rotation]
    slip: _Slip


class LimbComparison:
    """Two limbs at a tolerance, their masses left aside.

    Attributes:
        how: `LR`, `ROW`, `TURN` or `HELD`.
        tolerance: Within which numbers are equal.
        rows: The pairs of bodies, the heads first.
        readings: All without a slip, or else all with one; the plainest mounts first.
    """

    def __init__(
        self, rows: Sequence[Match], how: str, tolerance: Tolerance, among: Sequence[Mount] = ()
    ) -> None:
        self.rows, self.how, self.tolerance = rows, how, tolerance
        self._below: list[list[int]] = [[] for _ in rows]
        for index, row in enumerate(rows[1:], 1):
            self._below[row.up].append(index)
        self._known: dict[tuple[int, Rotation, bool], list[_Way]] = {}
        self._mounts = among or list(mounts(how, rows[0].one, rows[0].other))
        found = (self._readings(may_slip) for may_slip in (False, True))
        self.readings = next((readings for readings in found if readings), [])

    @property
    def n_slips(self) -> int:
        """The number of triples that differ: 0, 1, or 2 for more."""
        return min((int(reading.slip is not None) for reading in self.readings), default=2)

    @property
    def other_kinds(self) -> list[int]:
        """The rows whose joints are of different kinds."""
        return [i for i, row in enumerate(self.rows) if row.one.kind != row.other.kind]

    def in_way(self, way: tuple[Rotation, bool]) -> "LimbComparison":
        """Return the limbs read in one way, in any if it is none of theirs."""
        among = [mount for mount in self._mounts if mount.way == way]
        return LimbComparison(self.rows, self.how, self.tolerance, among) if among else self

    def is_seen_below(self, joint: str) -> bool:
        """Return whether offsets beyond a joint tell how its frame lies; a tool may lie anyhow."""
        at = next(i for i, row in enumerate(self.rows) if joint in (row.one.joint, row.other.joint))
        below = list(self._below[at])
        for index in below:
            below += self._below[index]
        return any(max(map(abs, self.rows[i].one.translation)) > _SEEN for i in below)

    def _readings(self, may_slip: bool) -> list[Reading]:
        found = (Reading(m, *way) for m in self._mounts for way in self._mounted(m, may_slip))
        return sorted(found, key=lambda reading: reading.mount.extra)

    def _mounted(self, mount: Mount, may_slip: bool) -> Iterator[_Way]:
        here, there = self.rows[0].one.translation, self.rows[0].other.translation
        is_placed = self.tolerance.is_same(there, mount.place)
        if self.how == "ROW" and self.tolerance.is_same(here, there):
            is_placed = False  # Two limbs at one place.
        is_alike = mount.is_copy or is_proper(mount.map)
        if is_placed or may_slip:
            to = self._handed(0, transposed(mount.map))
            if mount.is_copy and to is not None:
                to = IDENTITY.rotation
            yield from self._joined_to(0, is_placed, to, is_alike, may_slip)

    def _joined_to(
        self, index: int, is_placed: bool, to: Rotation | None, is_alike: bool, may_slip: bool
    ) -> Iterator[_Way]:
        """Yield the ways to read a limb from a joint on.

        Args:
            index: Of the row.
            is_placed: Whether its translation agrees.
            to: The convention that its rotation makes, None where it makes none.
            is_alike: Whether conventions are rotations.
            may_slip: Whether one triple may differ.
        """
        if is_placed and to is not None:
            yield from self._below_row(index, to, may_slip)
        what = "angles" if is_placed else "translation"
        for C in _ALIKE[is_alike] if may_slip else ():
            if (to == C) != is_placed:
                ways = self._below_row(index, C, may_slip=False)
                yield from ((conventions, (index, what)) for conventions, _ in ways)

    def _below_row(self, index: int, C: Rotation, may_slip: bool) -> list[_Way]:
        """Return the ways to read a row and all below it, where the row has a convention."""
        known = self._known.get((index, C, may_slip))
        if known is None:
            known = [({index: C}, None)]
            for child in self._below[index] if known else ():
                _, one, other = self.rows[child]
                place = turned(transposed(C), one.translation)
                is_placed = self.tolerance.is_same(other.translation, place)
                if not (is_placed or may_slip):
                    known = []
                    break
                to = self._handed(child, C)
                ways = list(self._joined_to(child, is_placed, to, is_proper(C), may_slip))
                known = [(a | b, s or t) for a, s in known for b, t in ways if not (s and t)]
            self._known[index, C, may_slip] = known
        return known

    def _handed(self, index: int, C: Rotation) -> Rotation | None:
        """Return the convention that a row's rotation makes of its parent's, None if none."""
        _, one, other = self.rows[index]
        rows = []
        for a, b, c in product(product(transposed(one.rotation), C), other.rotation):
            x, y, z = float(round(a)), float(round(b)), float(round(c))
            if max(abs(a - x), abs(b - y), abs(c - z)) > self.tolerance.angle:
                return None
            rows.append((x, y, z))
        found = rows[0], rows[1], rows[2]
        return found if found in _KNOWN else None
