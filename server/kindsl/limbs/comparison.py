"""Two limbs compared: what takes one to the other, and which single triple prevents it."""

from collections.abc import Iterable
from typing import NamedTuple

from kindsl.limbs.conventions import (
    Freed,
    Labelling,
    Matching,
    Mount,
    Tolerance,
)
from kindsl.limbs.limb import Body, Part, Row, rows_of
from kindsl.limbs.mounts import ANY_WAY, mounts
from kindsl.limbs.names import is_held
from kindsl.rigid.pose import RigidPose, Rotation

_NEAR = 0.35
_WORST = 99.0
_SEEN = 1e-3


class Single(NamedTuple):
    """One triple that, written otherwise, makes two limbs alike."""

    cost: float
    row: int
    what: str
    mount: Mount
    conventions: list[Rotation]


class Comparison:
    """Two limbs at a tolerance.

    Attributes:
        one: The head of the first.
        other: The head of its twin.
        how: `LR`, `ROW` or `TURN`.
        part: What is compared.
        is_whole: Whether they match body by body to their ends.
        matching: Their rows.
        mounts: What may take head to head.
        best: The cheapest labelling.
    """

    def __init__(
        self, one: Body, other: Body, how: str, tolerance: Tolerance, part: Part = Part.WHOLE
    ) -> None:
        self.one, self.other, self.how, self.part = one, other, how, part
        rows, self.is_whole = rows_of(one, other, part)
        self.matching = Matching(rows, tolerance)
        held = part is Part.HELD
        self.mounts = list(ANY_WAY) if held else mounts(how, one, other, tolerance)
        self.best = Labelling(_WORST, [])
        self._singles: list[Single] | None = None
        for mount in self.mounts:
            # What costs more from the start cannot win.
            if mount.extra < self.best.cost:
                self.best = min(self.best, self.labelling(mount), key=lambda found: found.cost)

    @property
    def rows(self) -> list[Row]:
        """The pairs of bodies, the heads first."""
        return list(self.matching.rows)

    @property
    def n_slips(self) -> int:
        """How many triples differ."""
        return _whole(self.best.cost)

    @property
    def other_kinds(self) -> list[int]:
        """The rows whose joints are of different kinds."""
        return [i for i, row in enumerate(self.rows) if row.one.kind != row.other.kind]

    def labelling(self, mount: Mount, freed: Freed | None = None) -> Labelling:
        """Return the cheapest conventions for a mount, its own cost included."""
        station, tolerance = 0.0, self.matching.tolerance
        if mount.map is not None:
            here, there = self.one.translation, self.other.translation
            at_one_place = self.how == "ROW" and tolerance.is_same(there, here)
            station = float(at_one_place or not tolerance.is_same(there, mount.place))
        found = self.matching.labelling(mount, station, freed)
        return Labelling(found.cost + mount.extra, found.conventions)

    def singles(self) -> list[Single]:
        """Return the single triples that explain the difference, where one does."""
        if self._singles is None:
            found = list(self._explaining()) if self.n_slips == 1 else []
            least = min((single.cost for single in found), default=0.0)
            self._singles = [s for s in found if s.cost <= least + _NEAR]
        return self._singles

    def least_cost_of(self, row: int, what: str) -> float:
        """Return the least cost with a triple freed."""
        return min(s.cost for s in self.singles() if (s.row, s.what) == (row, what))

    def _explaining(self) -> Iterable[Single]:
        first = 0
        if self.part is Part.HELD:
            first = 1 + (len(self.matching.below[0]) == 1)
        for mount in self.mounts:
            if self.labelling(mount).cost >= self.best.cost + 0.9:
                continue
            for row in range(first, len(self.rows)):
                for what in ("translation", "angles"):
                    cost, conventions = self.labelling(mount, Freed(row, what))
                    if _whole(cost) == 0:
                        yield Single(cost, row, what, mount, conventions)

    def expected(self, single: Single) -> RigidPose:
        """Return the pose of the twin's body as the first limb has it."""
        return self.matching.expected(single.mount, single.conventions, single.row)

    def expected_back(self, single: Single) -> RigidPose:
        """Return the pose of the first limb's body as its twin has it."""
        return self.matching.expected_back(single.mount, single.conventions, single.row)

    def differing_masses(self) -> list[tuple[int, str]]:
        """Return rows with `com` or `moments` where these are not alike."""
        found = zip(self.rows, self.best.conventions, strict=True)
        return [
            (index, what)
            for index, (row, convention) in enumerate(found)
            for what in self.matching.differing_masses(row, convention)
        ]

    def turned_joints(self) -> set[int]:
        """Return the rows whose rotation, if it were another, would make all masses alike."""
        return {
            row
            for row in range(len(self.rows))
            for mount in self.mounts
            if self.labelling(mount, Freed(row, "angles")).cost - mount.extra < 0.002
        }

    def is_seen_below(self, row: int) -> bool:
        """Return whether offsets beyond a joint tell how its frame lies; a tool may lie anyhow."""
        waiting = list(self.matching.below[row])
        while waiting:
            index = waiting.pop()
            if max(map(abs, self.rows[index].one.translation)) > _SEEN:
                return True
            waiting += self.matching.below[index]
        return False


def compared(one: Body, other: Body, how: str, tolerance: Tolerance) -> Comparison:
    """Compare two limbs; where something differs, without what they hold in their hands."""
    whole = Comparison(one, other, how, tolerance)
    if (whole.n_slips == 0 and whole.is_whole) or _holds(one):
        return whole
    bare = Comparison(one, other, how, tolerance, Part.BARE)
    return bare if len(bare.rows) < len(whole.rows) else whole


def held_parts(comparison: Comparison) -> Iterable[Comparison]:
    """Yield what two limbs hold, each compared in itself: how it is mounted is not."""
    for row in comparison.rows if comparison.part is Part.BARE else ():
        if any(map(_holds, row.one.children)) and not _holds(row.one):
            tolerance = comparison.matching.tolerance
            part = Comparison(row.one, row.other, comparison.how, tolerance, Part.HELD)
            if part.is_whole:
                yield part


def _whole(cost: float) -> int:
    return int(cost + _NEAR)


def _holds(body: Body) -> bool:
    return is_held(body.name, body.joint)
