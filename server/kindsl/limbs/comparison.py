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

from kindsl.limbs.limb import Body, Match
from kindsl.limbs.mounts import CONVENTIONS, Mount, is_proper, mounts
from kindsl.limbs.slips import angles_near, n_retyped
from kindsl.rigid.body import MassDistribution
from kindsl.rigid.pose import IDENTITY, Rotation, Vector3, product, transposed, turned

# Cost of a CoM or tensor that differs: it breaks ties, and many are less than a slip.
_OF_MASS = 0.004
_NEAR = 0.35
_SEEN = 1e-3
_KNOWN = frozenset(CONVENTIONS)
_ALIKE = {kind: [C for C in CONVENTIONS if is_proper(C) == kind] for kind in (True, False)}


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
        n_retyped: How many of its numbers no sign, order or unit explains.
        change: The greatest difference of a number.
        free_axis: Along which the twin can say nothing, if any.
    """

    place: Suspect
    twin: str
    meant: Vector3
    cost: float
    n_retyped: int
    change: float
    free_axis: int | None


class Reading(NamedTuple):
    """A way to read a limb, or what is below one of its joints, as its twin.

    Attributes:
        cost: Of the mount, and of masses that differ.
        conventions: Of each row.
        slip: The row and the triple (`translation`, `angles`) that is wrong then, if one is.
        mount: What takes head to head.
    """

    cost: float
    conventions: dict[int, Rotation]
    slip: tuple[int, str] | None = None
    mount: Mount = Mount(IDENTITY.rotation, IDENTITY.translation, 0.0)

    def joined(self, other: "Reading") -> "Reading":
        """Return both of two branches."""
        conventions = self.conventions | other.conventions
        return Reading(self.cost + other.cost, conventions, self.slip or other.slip)


class LimbComparison:
    """Two limbs at a tolerance.

    Attributes:
        how: `LR`, `ROW`, `TURN` or `HELD`.
        tolerance: Within which numbers are equal.
        rows: The pairs of bodies, the heads first.
        readings: All without a slip, or else all with one, the cheapest first.
    """

    def __init__(
        self, rows: Sequence[Match], how: str, tolerance: Tolerance, among: Sequence[Mount] = ()
    ) -> None:
        self.rows, self.how, self.tolerance = rows, how, tolerance
        self._below: list[list[int]] = [[] for _ in rows]
        for index, row in enumerate(rows[1:], 1):
            self._below[row.up].append(index)
        self._known: dict[tuple[int, Rotation, bool], list[Reading]] = {}
        self._read(list(among or mounts(how, rows[0].one, rows[0].other)))

    @property
    def n_slips(self) -> int:
        """The number of triples that differ: 0, 1, or 2 for more."""
        return min((int(reading.slip is not None) for reading in self.readings), default=2)

    @property
    def best(self) -> Reading:
        """The cheapest reading; there must be one."""
        return self.readings[0]

    @property
    def other_kinds(self) -> list[int]:
        """The rows whose joints are of different kinds."""
        return [i for i, row in enumerate(self.rows) if row.one.kind != row.other.kind]

    def keep_to(self, way: tuple[Rotation, bool]) -> None:
        """Read one limb as the other in one way, unless that is the cheapest, or none of theirs."""
        is_cheapest = bool(self.readings) and self.best.mount.way == way
        mounts = [mount for mount in self._mounts if mount.way == way]
        if mounts and not is_cheapest:
            self._read(mounts)

    def accusations(self) -> list[tuple[Accusation, Accusation]]:
        """Return the single triples that explain the difference, as of either limb."""
        if self.n_slips != 1:
            return []
        near = [r for r in self.readings if r.cost <= self.best.cost + _NEAR]
        return [self._accused(reading) for reading in sorted(near, key=lambda r: r.slip or ())]

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

    def _read(self, among: list[Mount]) -> None:
        self._mounts = among
        for may_slip in (False, True):
            found = [reading for mount in among for reading in self._mounted(mount, may_slip)]
            self.readings = sorted(found, key=lambda reading: reading.cost)
            if found:
                return

    def _mounted(self, mount: Mount, may_slip: bool) -> Iterator[Reading]:
        is_placed, to = self._handed(0, transposed(mount.map), mount.place)
        if self.how == "ROW" and self.tolerance.is_same(*(b.translation for b in self.rows[0][1:])):
            is_placed = False  # Two limbs at one place.
        if mount.is_copy and to is not None:
            to = IDENTITY.rotation
        is_alike = mount.is_copy or is_proper(mount.map)
        for reading in self._joined_to(0, is_placed, to, is_alike, may_slip):
            yield reading._replace(cost=reading.cost + mount.extra, mount=mount)

    def _joined_to(
        self, index: int, is_placed: bool, to: Rotation | None, is_alike: bool, may_slip: bool
    ) -> list[Reading]:
        """Return the readings from a joint on, for each slip the cheapest.

        Args:
            index: Of the row.
            is_placed: Whether its translation agrees.
            to: The convention that its rotation makes, None where it makes none.
            is_alike: Whether conventions are rotations.
            may_slip: Whether one triple may differ.
        """
        found = list(self._below_row(index, to, may_slip)) if is_placed and to is not None else []
        what = "angles" if is_placed else "translation"
        others = [C for C in _ALIKE[is_alike] if (to == C) != is_placed] if may_slip else ()
        ways = [way for C in others for way in self._below_row(index, C, False)]
        if ways:
            found.append(min(ways, key=lambda way: way.cost)._replace(slip=(index, what)))
        return found

    def _below_row(self, index: int, C: Rotation, may_slip: bool) -> list[Reading]:
        """Return the readings of a row and all below it, where the row has a convention."""
        known = self._known.get((index, C, may_slip))
        if known is None:
            known = [Reading(_OF_MASS * len(self._differing(self.rows[index], C)), {index: C})]
            for child in self._below[index]:
                joint = self._handed(
                    child, C, turned(transposed(C), self.rows[child].one.translation)
                )
                ways = self._joined_to(child, *joint, is_proper(C), may_slip)
                known = [a.joined(b) for a in known for b in ways if not (a.slip and b.slip)]
            self._known[index, C, may_slip] = known
        return known

    def _handed(self, index: int, C: Rotation, place: Vector3) -> tuple[bool, Rotation | None]:
        """Return whether a row is at a place, and the convention that its rotation makes of C."""
        _, one, other = self.rows[index]
        turn = product(product(transposed(one.rotation), C), other.rotation)
        return self.tolerance.is_same(other.translation, place), self._convention(turn)

    def _accused(self, reading: Reading) -> tuple[Accusation, Accusation]:
        cost, conventions, slip, mount = reading
        assert slip is not None
        (index, what), (up, one, other) = slip, self.rows[slip[0]]
        back = conventions[up] if up >= 0 else transposed(mount.map)
        forth, here = transposed(back), turned(transposed(back), one.translation)
        there = here if up >= 0 else mount.place
        pairs = zip(other.translation, here, there, strict=True)
        x, y, z = (own + seen - place for own, seen, place in pairs)
        forward = product(product(forth, one.rotation), conventions[index])
        backward = product(product(back, other.rotation), transposed(conventions[index]))
        free_axis = mount.free_axis if index == 0 and what == "translation" else None
        return (
            _accusation((one, other), what, turned(back, (x, y, z)), backward, cost, free_axis),
            _accusation((other, one), what, there, forward, cost, free_axis),
        )

    def _differing(self, row: Match, C: Rotation) -> list[str]:
        """Return `com` and `moments` where they differ under a convention."""
        here, there = row.one.inertia, row.other.inertia
        if here is None or there is None:
            return []
        _, com, moments = seen_by(here, C)
        found = [] if self.tolerance.is_same(there.com, com) else ["com"]
        allowed = max(1e-7, self.tolerance.share * max(map(abs, moments)))
        if any(abs(x - y) > allowed for x, y in zip(moments, there.moments, strict=True)):
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


def seen_by(body: MassDistribution, C: Rotation) -> MassDistribution:
    """Return a body as it is in the frame of its twin."""
    (a, b, _), (c, d, _), (_, _, e) = C
    xx, yy, zz, xy, xz, yz = body.moments
    moments = (xx, yy, zz, a * d * xy, a * e * xz, d * e * yz)
    if not a:
        moments = (yy, xx, zz, b * c * xy, c * e * yz, b * e * xz)
    return body._replace(com=turned(transposed(C), body.com), moments=moments)


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
    suspect = Suspect(body.name, body.joint, what)
    return Accusation(suspect, twin.name, meant, cost, n_retyped(written, meant), change, free_axis)
