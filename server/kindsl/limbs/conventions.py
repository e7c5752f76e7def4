"""The fewest slips that explain how a limb differs from its twin.

Frames of twins differ by a convention C, `x_one = C x_other`: a signed permutation that keeps the
joint's axis z up to its sign. Conventions are hidden, poses are seen; a least-cost labelling of the
tree (Sankoff) finds the conventions under which the fewest written triples differ.
"""

from collections.abc import Sequence
from itertools import product as combinations
from math import hypot
from typing import NamedTuple

from kindsl.limbs.limb import Match
from kindsl.rigid.body import Symmetric
from kindsl.rigid.pose import RigidPose, Rotation, Vector3, product, transposed, turned

# Cost of a CoM or tensor that differs, beside 1 of a translation or rotation: it breaks ties.
_OF_MASS = 0.004


class Tolerance(NamedTuple):
    """How far equal numbers may be apart: metres, a share of the number, radians."""

    length: float
    share: float
    angle: float

    def is_same(self, here: Vector3, there: Vector3) -> bool:
        """Return whether a vector is the same as another."""
        apart = max(abs(here[0] - there[0]), abs(here[1] - there[1]), abs(here[2] - there[2]))
        return apart <= self.length or apart <= self.share * hypot(*there)


TIGHT, LOOSE = Tolerance(2e-6, 1e-5, 1e-5), Tolerance(5e-4, 0.01, 0.01)


def plus(one: Vector3, other: Vector3) -> Vector3:
    """Return a sum."""
    return one[0] + other[0], one[1] + other[1], one[2] + other[2]


def minus(one: Vector3, other: Vector3) -> Vector3:
    """Return a difference."""
    return one[0] - other[0], one[1] - other[1], one[2] - other[2]


def diagonal(x: float, y: float, z: float) -> Rotation:
    """Return a diagonal matrix."""
    return (x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z)


IDENTITY = diagonal(1.0, 1.0, 1.0)
ORIGIN: Vector3 = (0.0, 0.0, 0.0)


def is_proper(matrix: Rotation) -> bool:
    """Return whether an orthogonal matrix is a rotation, no reflection."""
    (a, b, c), (d, e, f), (g, h, i) = matrix
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) > 0.0


_ALL: list[Rotation] = []
for _x, _y, _z in combinations((1.0, -1.0), repeat=3):
    _ALL.append(diagonal(_x, _y, _z))
    _ALL.append(((0.0, _x, 0.0), (_y, 0.0, 0.0), (0.0, 0.0, _z)))
_CONVENTIONS = {kind: [C for C in _ALL if is_proper(C) == kind] for kind in (True, False)}
_N = len(_CONVENTIONS[True])
_INDEX = {C: index for found in _CONVENTIONS.values() for index, C in enumerate(found)}


Way = tuple[Rotation | None, bool]


class Mount(NamedTuple):
    """What may take the head of a limb to that of its twin.

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
        """What pairs of one robot have in common: how directions and the limb itself go over."""
        return self.map, self.is_copy


class Freed(NamedTuple):
    """A triple that may be anything: `translation` or `angles` of a row."""

    row: int
    what: str


class Labelling(NamedTuple):
    """Conventions of the rows, and how many triples differ under them (with parts of one)."""

    cost: float
    conventions: list[Rotation]


class _Costs(NamedTuple):
    """What a row costs: by its parent's convention, and by its own.

    Attributes:
        translation: 1 where it differs, by the parent's convention.
        leads_to: The convention that the rotation makes of the parent's, None where it makes none.
        masses: Of the CoM and tensor, by its own convention.
    """

    translation: list[float]
    leads_to: list[int | None]
    masses: list[float]


class Matching:
    """Two limbs, row by row, at a tolerance."""

    def __init__(self, rows: Sequence[Match], tolerance: Tolerance) -> None:
        self.rows, self.tolerance = rows, tolerance
        self.below: list[list[int]] = [[] for _ in rows]
        for index, row in enumerate(rows):
            if row.up >= 0:
                self.below[row.up].append(index)
        self._tables: dict[bool, list[_Costs]] = {}

    def labelling(self, mount: Mount, station: float, freed: Freed | None) -> Labelling:
        """Return the cheapest conventions for a mount.

        Args:
            mount: What takes head to head.
            station: Cost of the twin's place.
            freed: A triple that costs nothing.
        """
        proper = mount.is_copy or (mount.map is not None and is_proper(mount.map))
        costs, choices = self._costs_upwards(self._table(proper), freed)
        least = min(range(_N), key=costs.__getitem__)
        if mount.map is None:
            return self._labelled(costs[least], least, choices, proper)
        first = self.rows[0]
        turn = product(transposed(first.one.rotation), transposed(mount.map))
        at = self._convention(product(turn, first.other.rotation))
        if mount.is_copy and at is not None:
            at = _INDEX[IDENTITY]
        cost = costs[least] + (freed != (0, "angles"))
        if at is not None and costs[at] <= cost:
            cost, least = costs[at], at
        cost += 0.0 if freed == (0, "translation") else station
        return self._labelled(cost, least, choices, proper)

    def expected(self, mount: Mount, conventions: Sequence[Rotation], index: int) -> RigidPose:
        """Return the pose of the twin's body as the first limb has it; of a free head its own."""
        row = self.rows[index]
        if row.up >= 0:
            before = transposed(conventions[row.up])
            place = turned(before, row.one.translation)
        elif mount.map is None:
            return RigidPose(row.other.rotation, row.other.translation)
        else:
            before, place = mount.map, mount.place
        return RigidPose(product(product(before, row.one.rotation), conventions[index]), place)

    def expected_back(self, mount: Mount, conventions: Sequence[Rotation], index: int) -> RigidPose:
        """Return the pose of the first limb's body as its twin has it."""
        row = self.rows[index]
        if row.up >= 0:
            before = conventions[row.up]
            place = turned(before, row.other.translation)
        else:
            forth = mount.map or IDENTITY
            before = transposed(forth)
            here = turned(forth, row.one.translation)
            place = turned(before, plus(row.other.translation, minus(here, mount.place)))
        back = transposed(conventions[index])
        return RigidPose(product(product(before, row.other.rotation), back), place)

    def _costs_upwards(
        self, table: Sequence[_Costs], freed: Freed | None
    ) -> tuple[list[float], list[list[int]]]:
        """Return the head's cost by convention, and each row's best one by its parent's."""
        costs: list[list[float]] = [[]] * len(self.rows)
        choices: list[list[int]] = [[]] * len(self.rows)
        for index in range(len(self.rows) - 1, -1, -1):
            costs[index] = list(table[index].masses)
            for child in self.below[index]:
                mine, theirs = costs[index], costs[child]
                least = min(range(_N), key=theirs.__getitem__)
                other = theirs[least] + (freed != (child, "angles"))
                is_free = freed == (child, "translation")
                choices[child] = [least] * _N
                for c in range(_N):
                    best, to = other, table[child].leads_to[c]
                    if to is not None and theirs[to] <= best:
                        best, choices[child][c] = theirs[to], to
                    mine[c] += best + (0.0 if is_free else table[child].translation[c])
        return costs[0], choices

    def _labelled(
        self, cost: float, head: int, choices: Sequence[Sequence[int]], proper: bool
    ) -> Labelling:
        labels = [head]
        for index, row in enumerate(self.rows[1:], 1):
            labels.append(choices[index][labels[row.up]])
        return Labelling(cost, [_CONVENTIONS[proper][label] for label in labels])

    def _table(self, proper: bool) -> list[_Costs]:
        if proper not in self._tables:
            self._tables[proper] = [self._row_costs(row, _CONVENTIONS[proper]) for row in self.rows]
        return self._tables[proper]

    def _row_costs(self, row: Match, conventions: Sequence[Rotation]) -> _Costs:
        translation, leads_to = [], []
        for C in conventions if row.up >= 0 else ():
            expected = _turned_back(C, row.one.translation)
            translation.append(float(not self.tolerance.is_same(row.other.translation, expected)))
            leads_to.append(self._convention_between(row.one.rotation, C, row.other.rotation))
        masses = [_OF_MASS * len(self.differing_masses(row, C)) for C in conventions]
        return _Costs(translation, leads_to, masses)

    def differing_masses(self, row: Match, convention: Rotation) -> list[str]:
        """Return `com` and `moments` where they differ under a convention."""
        (_, one, other), differing = row, []
        if one.com and other.com:
            expected = _turned_back(convention, one.com)
            if not self.tolerance.is_same(other.com, expected):
                differing.append("com")
        if one.moments and other.moments:
            moments = _moments_turned_back(convention, one.moments)
            if not self._are_same_moments(other.moments, moments):
                differing.append("moments")
        return differing

    def _are_same_moments(self, here: Symmetric, there: Symmetric) -> bool:
        allowed = max(1e-7, self.tolerance.share * max(map(abs, there)))
        return all(abs(x - y) <= allowed for x, y in zip(here, there, strict=True))

    def _convention_between(self, one: Rotation, C: Rotation, other: Rotation) -> int | None:
        """Return the index of `transposed(one) C other`, None where that is no convention."""
        x, y, z = _turned_back(transposed(C), (other[0][2], other[1][2], other[2][2]))
        along = one[0][2] * x + one[1][2] * y + one[2][2] * z
        if 1.0 - abs(along) > self.tolerance.angle:
            return None
        return self._convention(product(product(transposed(one), C), other))

    def _convention(self, matrix: Rotation) -> int | None:
        """Return the index of the convention that a matrix is, None if none."""
        rows = []
        for row in matrix:
            whole = [float(round(x)) for x in row]
            if any(abs(x - y) > self.tolerance.angle for x, y in zip(row, whole, strict=True)):
                return None
            rows.append((whole[0], whole[1], whole[2]))
        return _INDEX.get((rows[0], rows[1], rows[2]))


def _turned_back(convention: Rotation, vector: Vector3) -> Vector3:
    """Return a vector of the one limb as its twin has it."""
    (a, b, _), (c, d, _), (_, _, e) = convention
    x, y, z = vector
    return (a * x, d * y, e * z) if a else (c * y, b * x, e * z)


def _moments_turned_back(convention: Rotation, moments: Symmetric) -> Symmetric:
    """Return moments and products of the one limb as its twin has them."""
    (a, b, _), (c, d, _), (_, _, e) = convention
    xx, yy, zz, xy, xz, yz = moments
    if a:
        return xx, yy, zz, a * d * xy, a * e * xz, d * e * yz
    return yy, xx, zz, b * c * xy, c * e * yz, b * e * xz
