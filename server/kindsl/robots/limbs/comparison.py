"""The ways to read a limb as its peer, and the single triple of numbers that prevents it.

Frames of peers differ by a convention C, `x_one = C x_other`: a signed permutation that keeps the
joint's axis z up to its sign. Conventions are hidden, poses are seen. At the head a mount tells the
convention; below, a rotation hands the parent's on to the link, `C = R_one' C_parent R_other`, and
a translation agrees where it is `C_parent' p_one`. One triple may break this: behind a rotation
that is wrong any convention may follow.
"""

from collections.abc import Iterator, Sequence
from math import hypot
from typing import NamedTuple

from kindsl.mechanics.rigid.pose import IDENTITY, Rotation, Vector3, product, transposed, turned
from kindsl.robots.limbs.limb import AT_ORIGIN, Match
from kindsl.robots.limbs.mounts import CONVENTIONS, SAME_PLACE, Mount, Way, is_proper, mounts

_KNOWN = frozenset(CONVENTIONS)
_ALIKE = {kind: [C for C in CONVENTIONS if is_proper(C) == kind] for kind in (True, False)}
# The row and the triple (`translation`, `angles`) that is wrong.
_Slip = tuple[int, str]
_Labelled = tuple[dict[int, Rotation], _Slip | None]


class Tolerance(NamedTuple):
    """The distances of equal numbers: metres, a share of the number, radians."""

    length: float
    share: float
    angle: float

    def is_same(self, here: Vector3, there: Vector3) -> bool:
        """Return whether a vector is the same as another."""
        apart = max(abs(here[0] - there[0]), abs(here[1] - there[1]), abs(here[2] - there[2]))
        return apart <= self.length or apart <= self.share * min(hypot(*here), hypot(*there))


LOOSE = Tolerance(5e-4, 0.01, 0.01)
_OF_PLACES = Tolerance(5e-4, 0.003, 0.01)


class Reading(NamedTuple):
    """A way to read a limb as its peer.

    Attributes:
        mount: What takes head to head.
        conventions: Of each row.
        slip: The row and the triple (`translation`, `angles`) that is wrong then, if one is.
    """

    mount: Mount
    conventions: dict[int, Rotation]
    slip: _Slip | None


class LimbComparison:
    """Two limbs, their masses left aside.

    Attributes:
        rows: The pairs of bodies, the heads first.
        how: `LR`, `ROW`, `TURN` or `HELD`.
    """

    def __init__(
        self,
        rows: Sequence[Match],
        how: str,
        among: Sequence[Mount] = (),
        tolerance: Tolerance = _OF_PLACES,
        base: Vector3 = AT_ORIGIN,
    ) -> None:
        self.rows, self.how = rows, how
        found = among or mounts(how, *rows[0][1:], base)
        self._mounts = sorted(found, key=lambda mount: mount.extra)
        self._tolerance = tolerance
        self._below: list[list[int]] = [[] for _ in rows]
        for index, row in enumerate(rows[1:], 1):
            self._below[row.up].append(index)
        self._labelled: dict[tuple[int, Rotation, bool], list[_Labelled]] = {}
        self._readings: dict[Way | None, list[Reading]] = {}

    def readings(self, way: Way | None = None) -> list[Reading]:
        """Return all readings without a slip, or else all with one; the plainest mounts first.

        Args:
            way: Of the mounts that are tried, unless none is such.
        """
        if way not in self._readings:
            among = [mount for mount in self._mounts if mount.way == way] or self._mounts
            # Numbered limbs that no mount explains may be mounted in any way, as fingers are.
            anyhow = mounts("HELD", *self.rows[0][1:]) if self.how == "TURN" else ()
            found = (
                [*self._read(tried, may_slip)]
                for tried in (among, list(anyhow))
                for may_slip in (False, True)
            )
            self._readings[way] = next(filter(None, found), [])
        return self._readings[way]

    @property
    def other_kinds(self) -> list[int]:
        """The rows whose joints are of different kinds."""
        return [i for i, row in enumerate(self.rows) if row.one.kind != row.other.kind]

    def is_seen_below(self, joint: str) -> bool:
        """Return whether offsets beyond a joint tell how its frame lies; a tool may lie anyhow."""
        at = next(i for i, row in enumerate(self.rows) if joint in (row.one.joint, row.other.joint))
        below = list(self._below[at])
        for index in below:
            below += self._below[index]
        return any(max(map(abs, self.rows[i].one.translation)) > SAME_PLACE for i in below)

    def _read(self, among: Sequence[Mount], may_slip: bool) -> Iterator[Reading]:
        here, there = self.rows[0].one.translation, self.rows[0].other.translation
        is_one_place = self.how == "ROW" and self._tolerance.is_same(here, there)
        for mount in among:
            is_placed = not is_one_place and self._tolerance.is_same(there, mount.place)
            to = self._handed(0, transposed(mount.map)) if is_placed or may_slip else None
            if mount.is_copy and to is not None:
                to = IDENTITY.rotation
            is_alike = mount.is_copy or is_proper(mount.map)
            for labelled in self._joined(0, is_placed, to, is_alike, may_slip):
                yield Reading(mount, *labelled)

    def _joined(
        self, index: int, is_placed: bool, to: Rotation | None, is_alike: bool, may_slip: bool
    ) -> Iterator[_Labelled]:
        """Yield the conventions of a body and of all below it.

        Args:
            index: Of its row.
            is_placed: Whether its translation agrees.
            to: The convention that its rotation makes, None where it makes none.
            is_alike: Whether conventions are rotations.
            may_slip: Whether one triple may differ.
        """
        if is_placed and to is not None:
            yield from self._with(index, to, may_slip)
        if not may_slip:
            return
        slip = index, "angles" if is_placed else "translation"
        for C in _ALIKE[is_alike]:
            if (to == C) != is_placed:
                for conventions, _ in self._with(index, C, may_slip=False):
                    yield conventions, slip

    def _with(self, index: int, C: Rotation, may_slip: bool) -> list[_Labelled]:
        """Return the conventions of a row, which has this one, and of all below it."""
        known = self._labelled.get((index, C, may_slip))
        if known is None:
            known = [({index: C}, None)]
            for child in self._below[index]:
                _, one, other = self.rows[child]
                place = turned(transposed(C), one.translation)
                is_placed = self._tolerance.is_same(other.translation, place)
                to = self._handed(child, C) if is_placed or may_slip else None
                ways = list(self._joined(child, is_placed, to, is_proper(C), may_slip))
                known = [(a | b, s or t) for a, s in known for b, t in ways if not (s and t)]
                if not known:
                    break
            self._labelled[index, C, may_slip] = known
        return known

    def _handed(self, index: int, C: Rotation) -> Rotation | None:
        """Return the convention that a row's rotation makes of its parent's, None if none."""
        _, one, other = self.rows[index]
        rows = []
        for a, b, c in product(product(transposed(one.rotation), C), other.rotation):
            x, y, z = float(round(a)), float(round(b)), float(round(c))
            if max(abs(a - x), abs(b - y), abs(c - z)) > self._tolerance.angle:
                return None
            rows.append((x, y, z))
        found = rows[0], rows[1], rows[2]
        return found if found in _KNOWN else None
