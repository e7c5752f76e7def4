"""The way from a limb to its twin, and the single triple of numbers that prevents it.

Frames of twins differ by a convention C, `x_one = C x_other`: a signed permutation that keeps the
joint's axis z up to its sign. Conventions are hidden, poses are seen. At the head a mount tells the
convention; below, a rotation hands the parent's on to the link, `C = R_one' C_parent R_other`, and
a translation agrees where it is `C_parent' p_one`. One triple may break this: behind a rotation
that is wrong any convention may follow.
"""

from collections.abc import Iterator, Sequence
from itertools import product as combinations
from typing import NamedTuple

from kindsl.limbs.limb import Body, LimbPart, Match, rows_of
from kindsl.limbs.mounts import ANY_WAY, Mount, Tolerance, Way, diagonal, is_proper, mounts
from kindsl.limbs.names import is_held
from kindsl.limbs.slips import SlipOfHand, angles_near, slip_between
from kindsl.rigid.body import Symmetric
from kindsl.rigid.pose import IDENTITY, Rotation, Vector3, product, transposed, turned

# Cost of a CoM or tensor that differs: it breaks ties, and many are less than a slip.
_OF_MASS, _NO_MASS = 0.004, 0.002
_NEAR = 0.35
_SEEN = 1e-3
_ALL: list[Rotation] = []
for _x, _y, _z in combinations((1.0, -1.0), repeat=3):
    _ALL += [diagonal(_x, _y, _z), ((0.0, _x, 0.0), (_y, 0.0, 0.0), (0.0, 0.0, _z))]
_KNOWN = frozenset(_ALL)
_ALIKE = {kind: [C for C in _ALL if is_proper(C) == kind] for kind in (True, False)}


class Suspect(NamedTuple):
    """Numbers of a limb, or what else may be wrong.

    Attributes:
        link: The name of the link.
        joint: The name of the joint that supports it.
        what: `translation` or `angles` of the joint, `kind` of it, `com` or `moments` of
            the link, `inertia` for both.
    """

    link: str
    joint: str
    what: str


class Accusation(NamedTuple):
    """A triple that, written otherwise, makes a limb like its twin.

    Attributes:
        place: Where it stands.
        twin: The link that says so.
        meant: What should be written.
        cost: Of what is odd besides.
        slip: What makes the written triple of the meant one.
        change: The greatest difference of a number.
        free_axis: Along which the twin can say nothing, if any.
    """

    place: Suspect
    twin: str
    meant: Vector3
    cost: float
    slip: SlipOfHand
    change: float
    free_axis: int | None


class Reading(NamedTuple):
    """A way to read a limb as its twin.

    Attributes:
        mount: What takes head to head.
        slip: The row and the triple (`translation`, `angles`) that is wrong then, if one is.
        cost: Of the mount, and of masses that differ.
        conventions: Of each row.
    """

    mount: Mount
    slip: tuple[int, str] | None
    cost: float
    conventions: dict[int, Rotation]


_Labels = tuple[float, dict[int, Rotation]]
_Slips = Iterator[tuple[tuple[int, str], _Labels]]


class LimbComparison:
    """Two limbs at a tolerance.

    Attributes:
        how: `LR`, `ROW` or `TURN`.
        tolerance: Within which numbers are equal.
        part: What is compared.
        rows: The pairs of bodies, the heads first.
        is_whole: Whether they match body by body to their ends.
        readings: All without a slip, or else all with one, the cheapest first.
    """

    def __init__(
        self,
        rows: Sequence[Match],
        how: str,
        tolerance: Tolerance,
        part: LimbPart = LimbPart.WHOLE,
        among: Sequence[Mount] = (),
    ) -> None:
        self.rows, self.how, self.tolerance, self.part = rows, how, tolerance, part
        self._below: list[list[int]] = [[] for _ in rows]
        for index, row in enumerate(rows[1:], 1):
            self._below[row.up].append(index)
        self._known: dict[tuple[int, Rotation], _Labels | None] = {}
        _, one, other = rows[0]
        is_held = part is LimbPart.HELD
        self._mounts = among or (ANY_WAY if is_held else mounts(how, one, other, tolerance))
        self.readings = self._readings()

    @property
    def n_slips(self) -> int:
        """The number of triples that differ: 0, 1, or 2 for more."""
        return min((int(reading.slip is not None) for reading in self.readings), default=2)

    @property
    def best(self) -> Reading:
        """The cheapest without a slip; there must be one."""
        return next(reading for reading in self.readings if reading.slip is None)

    @property
    def other_kinds(self) -> list[int]:
        """The rows whose joints are of different kinds."""
        return [i for i, row in enumerate(self.rows) if row.one.kind != row.other.kind]

    def keep_to(self, way: Way) -> None:
        """Read one limb as the other in one way, unless that is the cheapest, or none of theirs."""
        is_cheapest = bool(self.readings) and self.readings[0].mount.way == way
        mounts = [mount for mount in self._mounts if mount.way == way]
        if mounts and not is_cheapest:
            self._mounts = mounts
            self.readings = self._readings()

    def accusations(self) -> list[tuple[Accusation, Accusation]]:
        """Return the single triples that explain the difference, as of either limb."""
        if self.n_slips != 1:
            return []
        first = 1 + (len(self._below[0]) == 1) if self.part is LimbPart.HELD else 0
        found = [r for r in self.readings if r.slip is not None and r.slip[0] >= first]
        near = [r for r in found if r.cost <= found[0].cost + _NEAR]
        return [self._accused(reading) for reading in sorted(near, key=lambda r: r.slip or ())]

    def turnings(self) -> list[tuple[Accusation, Accusation]]:
        """Return the rotations that, written otherwise, make unlike masses alike."""
        found = self._with_a_slip() if self.differing_masses() else []
        turns = [r for r in found if r.slip is not None and r.slip[1] == "angles"]
        return [self._accused(r) for r in turns if r.cost - r.mount.extra < _NO_MASS]

    def differing_masses(self) -> list[tuple[int, str]]:
        """Return rows with `com` or `moments` where these are not alike."""
        found = sorted(self.best.conventions.items())
        return [(i, what) for i, C in found for what in self._differing(self.rows[i], C)]

    def is_seen_below(self, joint: str) -> bool:
        """Return whether offsets beyond a joint tell how its frame lies; a tool may lie anyhow."""
        at = next(i for i, row in enumerate(self.rows) if joint in (row.one.joint, row.other.joint))
        below = list(self._below[at])
        for index in below:
            below += self._below[index]
        return any(max(map(abs, self.rows[i].one.translation)) > _SEEN for i in below)

    def _readings(self) -> list[Reading]:
        found = [
            Reading(mount, None, labels[0] + mount.extra, labels[1])
            for mount in self._mounts
            for is_placed, to, _ in self._at_head(mount)
            if is_placed and to is not None and (labels := self._plain(0, to)) is not None
        ]
        return sorted(found, key=lambda reading: reading.cost) or self._with_a_slip()

    def _with_a_slip(self) -> list[Reading]:
        """Return for each mount and slip the cheapest reading."""
        found: dict[object, Reading] = {}
        for order, mount in enumerate(self._mounts):
            for head in self._at_head(mount):
                for slip, (cost, labels) in self._at(0, *head):
                    reading = Reading(mount, slip, cost + mount.extra, labels)
                    if reading.cost < found.setdefault((order, slip), reading).cost:
                        found[order, slip] = reading
        return sorted(found.values(), key=lambda reading: reading.cost)

    def _at_head(self, mount: Mount) -> Iterator[tuple[bool, Rotation | None, bool]]:
        """Yield what `_at` is to be told of the head; of a free mount, any convention."""
        _, one, other = self.rows[0]
        if mount.map is None:
            for C in _ALIKE[mount.is_copy]:
                yield True, C, mount.is_copy
            return
        turn = product(transposed(one.rotation), transposed(mount.map))
        to = self._convention(product(turn, other.rotation))
        if mount.is_copy and to is not None:
            to = IDENTITY.rotation
        there, is_same = other.translation, self.tolerance.is_same
        is_moved = self.how != "ROW" or not is_same(there, one.translation)
        is_alike = mount.is_copy or is_proper(mount.map)
        yield is_moved and is_same(there, mount.place), to, is_alike

    def _at(self, index: int, is_placed: bool, to: Rotation | None, is_alike: bool) -> _Slips:
        """Yield the slips at a row and below it.

        Args:
            index: Of the row.
            is_placed: Whether its translation agrees.
            to: The convention that its rotation makes, None where it makes none.
            is_alike: Whether conventions are rotations.
        """
        if to is not None and is_placed:
            yield from self._below_row(index, to)
        what = "angles" if is_placed else "translation"
        for C in _ALIKE[is_alike]:
            labels = self._plain(index, C) if (to == C) != is_placed else None
            if labels is not None:
                yield (index, what), labels

    def _below_row(self, index: int, C: Rotation) -> _Slips:
        """Yield the slips below a row of a convention."""
        for child in self._below[index]:
            rest = self._children([other for other in self._below[index] if other != child], C)
            if rest is not None:
                for slip, labels in self._at(child, *self._handed(child, C), is_proper(C)):
                    yield slip, self._joined(index, C, [labels, *rest])

    def _plain(self, index: int, C: Rotation) -> _Labels | None:
        """Return conventions of a row and all below it, None where something differs."""
        if (index, C) not in self._known:
            below = self._children(self._below[index], C)
            self._known[index, C] = None if below is None else self._joined(index, C, below)
        return self._known[index, C]

    def _children(self, children: Sequence[int], C: Rotation) -> list[_Labels] | None:
        """Return the same of some children of a row, None where something differs in one."""
        found = []
        for child in children:
            is_placed, to = self._handed(child, C)
            labels = self._plain(child, to) if is_placed and to is not None else None
            if labels is None:
                return None
            found.append(labels)
        return found

    def _handed(self, child: int, C: Rotation) -> tuple[bool, Rotation | None]:
        """Return whether a child's translation agrees, and the convention its rotation makes."""
        _, one, other = self.rows[child]
        expected = turned(transposed(C), one.translation)
        turn = product(product(transposed(one.rotation), C), other.rotation)
        return self.tolerance.is_same(other.translation, expected), self._convention(turn)

    def _joined(self, index: int, C: Rotation, below: Sequence[_Labels]) -> _Labels:
        cost = _OF_MASS * len(self._differing(self.rows[index], C)) + sum(c for c, _ in below)
        return cost, {index: C} | {i: own for _, labels in below for i, own in labels.items()}

    def _accused(self, reading: Reading) -> tuple[Accusation, Accusation]:
        mount, slip, cost, conventions = reading
        assert slip is not None
        (index, what), (up, one, other) = slip, self.rows[slip[0]]
        forth = transposed(conventions[up]) if up >= 0 else mount.map or IDENTITY.rotation
        back, here = transposed(forth), turned(forth, one.translation)
        there = mount.place if up < 0 else here
        pairs = zip(other.translation, here, there, strict=True)
        x, y, z = (place + own - moved for place, own, moved in pairs)
        forward = product(product(forth, one.rotation), conventions[index])
        backward = product(product(back, other.rotation), transposed(conventions[index]))
        free_axis = mount.free_axis if index == 0 and what == "translation" else None
        return (
            _accusation((one, other), what, turned(back, (x, y, z)), backward, cost, free_axis),
            _accusation((other, one), what, there, forward, cost, free_axis),
        )

    def _differing(self, row: Match, C: Rotation) -> list[str]:
        """Return `com` and `moments` where they differ under a convention."""
        (_, one, other), found = row, []
        expected = turned(transposed(C), one.com) if one.com else None
        if expected and other.com and not self.tolerance.is_same(other.com, expected):
            found.append("com")
        if one.moments and other.moments:
            moments = seen_by(one.moments, C)
            allowed = max(1e-7, self.tolerance.share * max(map(abs, moments)))
            if any(abs(x - y) > allowed for x, y in zip(moments, other.moments, strict=True)):
                found.append("moments")
        return found

    def _convention(self, matrix: Rotation) -> Rotation | None:
        """Return the convention that a matrix is, None if none."""
        rows = []
        for a, b, c in matrix:
            x, y, z = float(round(a)), float(round(b)), float(round(c))
            if max(abs(a - x), abs(b - y), abs(c - z)) > self.tolerance.angle:
                return None
            rows.append((x, y, z))
        found = rows[0], rows[1], rows[2]
        return found if found in _KNOWN else None


def seen_by(moments: Symmetric, C: Rotation) -> Symmetric:
    """Return the moments of a body as they are in the frame of its twin."""
    (a, b, _), (c, d, _), (_, _, e) = C
    xx, yy, zz, xy, xz, yz = moments
    if a:
        return xx, yy, zz, a * d * xy, a * e * xz, d * e * yz
    return yy, xx, zz, b * c * xy, c * e * yz, b * e * xz


def compared(one: Body, other: Body, how: str, tolerance: Tolerance) -> LimbComparison | None:
    """Return two limbs compared, None where they do not match body by body.

    Where something differs, they are compared without what they hold in their hands.
    """
    rows, is_whole = rows_of(one, other, LimbPart.WHOLE)
    whole = LimbComparison(rows, how, tolerance) if is_whole else None
    if (whole is None or whole.n_slips > 0) and not is_held(one.name, one.joint):
        bare, is_bare_whole = rows_of(one, other, LimbPart.BARE)
        if len(bare) < len(rows):
            return LimbComparison(bare, how, tolerance, LimbPart.BARE) if is_bare_whole else None
    return whole


def held_parts(comparison: LimbComparison) -> Iterator[LimbComparison]:
    """Yield what two limbs hold, each compared in itself: how it is mounted is not."""
    for _, one, other in comparison.rows if comparison.part is LimbPart.BARE else ():
        is_hand = any(is_held(child.name, child.joint) for child in one.children)
        rows, is_whole = rows_of(one, other, LimbPart.HELD)
        if is_hand and is_whole and not is_held(one.name, one.joint):
            yield LimbComparison(rows, comparison.how, comparison.tolerance, LimbPart.HELD)


def _accusation(
    bodies: tuple[Body, Body],
    what: str,
    place: Vector3,
    rotation: Rotation,
    cost: float,
    free_axis: int | None,
) -> Accusation:
    body, twin = bodies
    written, meant = body.translation, place
    if what == "angles":
        written, meant = body.angles, angles_near(rotation, body.angles, twin.angles)
    change = max(abs(x - y) for x, y in zip(written, meant, strict=True))
    suspect, slip = Suspect(body.name, body.joint, what), slip_between(written, meant, what)
    return Accusation(suspect, twin.name, meant, cost, slip, change, free_axis)
