"""Two limbs compared: what takes one to the other, and which single triple prevents it."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from kindsl.limbs.conventions import Freed, Labelling, Matching, Mount, Tolerance, Way
from kindsl.limbs.limb import Body, LimbPart, rows_of
from kindsl.limbs.mounts import ANY_WAY, mounts
from kindsl.limbs.names import is_held
from kindsl.limbs.slips import SlipOfHand, angles_near, slip_between
from kindsl.rigid.pose import RigidPose, Vector3

_NEAR = 0.35
_WORST = 99.0
_SEEN = 1e-3
_NO_MASS = 0.002


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
        pose: The joint's pose then, to be compared with what other twins say.
        cost: Of the comparison then.
        slip: What makes the written triple of the meant one.
        change: The greatest difference of a number.
        free_axis: Along which the twin can say nothing, if any.
    """

    place: Suspect
    twin: str
    meant: Vector3
    pose: RigidPose
    cost: float
    slip: SlipOfHand
    change: float
    free_axis: int | None


class LimbComparison:
    """Two limbs at a tolerance.

    Attributes:
        one: The head of the first.
        other: The head of its twin.
        how: `LR`, `ROW` or `TURN`.
        part: What is compared.
        rows: The pairs of bodies, the heads first.
        is_whole: Whether they match body by body to their ends.
        matching: The rows at the tolerance.
        best: The cheapest labelling.
        way: In which it takes the one limb to the other.
    """

    def __init__(
        self,
        one: Body,
        other: Body,
        how: str,
        tolerance: Tolerance,
        part: LimbPart = LimbPart.WHOLE,
    ) -> None:
        self.one, self.other, self.how, self.part = one, other, how, part
        self.rows, self.is_whole = rows_of(one, other, part)
        self.matching = Matching(self.rows, tolerance)
        is_held_only = part is LimbPart.HELD
        self._mounts = list(ANY_WAY) if is_held_only else mounts(how, one, other, tolerance)
        self._accusations: list[tuple[Accusation, Accusation]] | None = None
        self._choose()

    def keep_to(self, way: Way) -> None:
        """Compare again, the one limb being taken to the other in one way, if that can be."""
        self._mounts = [mount for mount in self._mounts if mount.way == way] or self._mounts
        self._choose()

    def _choose(self) -> None:
        self.best, self.way = Labelling(_WORST, []), self._mounts[0].way
        for mount in self._mounts:
            # What costs more from the start cannot win.
            if self.is_whole and mount.extra < self.best.cost:
                found = self._labelling(mount)
                if found.cost < self.best.cost:
                    self.best, self.way = found, mount.way

    @property
    def n_slips(self) -> int:
        """How many triples differ."""
        return _whole(self.best.cost)

    @property
    def other_kinds(self) -> list[int]:
        """The rows whose joints are of different kinds."""
        return [i for i, row in enumerate(self.rows) if row.one.kind != row.other.kind]

    def accusations(self) -> list[tuple[Accusation, Accusation]]:
        """Return the single triples that explain the difference, as of either limb."""
        if self._accusations is None:
            found = list(self._explaining()) if self.n_slips == 1 else []
            least = min((one.cost for one, _ in found), default=0.0)
            self._accusations = [both for both in found if both[0].cost <= least + _NEAR]
        return self._accusations

    def turnings(self) -> list[tuple[Accusation, Accusation]]:
        """Return the rotations that, written otherwise, make unlike masses alike."""
        ways = [(mount, row) for mount in self._mounts for row in range(len(self.rows))]
        found = ((m, row, self._labelling(m, Freed(row, "angles"))) for m, row in ways)
        return [
            self._accused(mount, labelling, row, "angles")
            for mount, row, labelling in (found if self.differing_masses() else ())
            if labelling.cost - mount.extra < _NO_MASS
        ]

    def _labelling(self, mount: Mount, freed: Freed | None = None) -> Labelling:
        """Return the cheapest conventions for a mount, its own cost included."""
        station, tolerance = 0.0, self.matching.tolerance
        if mount.map is not None:
            here, there = self.one.translation, self.other.translation
            at_one_place = self.how == "ROW" and tolerance.is_same(there, here)
            station = float(at_one_place or not tolerance.is_same(there, mount.place))
        found = self.matching.labelling(mount, station, freed)
        return Labelling(found.cost + mount.extra, found.conventions)

    def _explaining(self) -> Iterator[tuple[Accusation, Accusation]]:
        first = 0
        if self.part is LimbPart.HELD:
            first = 1 + (len(self.matching.below[0]) == 1)
        for mount in self._mounts:
            if self._labelling(mount).cost >= self.best.cost + 0.9:
                continue
            for row in range(first, len(self.rows)):
                for what in ("translation", "angles"):
                    found = self._labelling(mount, Freed(row, what))
                    if _whole(found.cost) == 0:
                        yield self._accused(mount, found, row, what)

    def _accused(
        self, mount: Mount, found: Labelling, index: int, what: str
    ) -> tuple[Accusation, Accusation]:
        _, one, other = self.rows[index]
        free_axis = mount.free_axis if index == 0 and what == "translation" else None
        backward = self.matching.expected_back(mount, found.conventions, index)
        forward = self.matching.expected(mount, found.conventions, index)
        sides = ((one, other, backward), (other, one, forward))
        here, there = (
            _accusation(body, twin, what, pose, found.cost, free_axis) for body, twin, pose in sides
        )
        return here, there

    def differing_masses(self) -> list[tuple[int, str]]:
        """Return rows with `com` or `moments` where these are not alike."""
        found = zip(self.rows, self.best.conventions, strict=True)
        return [
            (index, what)
            for index, (row, convention) in enumerate(found)
            for what in self.matching.differing_masses(row, convention)
        ]

    def is_seen_below(self, joint: str) -> bool:
        """Return whether offsets beyond a joint tell how its frame lies; a tool may lie anyhow."""
        names = [(row.one.joint, row.other.joint) for row in self.rows]
        at = next(i for i, both in enumerate(names) if joint in both)
        below = list(self.matching.below[at])
        for index in below:
            below += self.matching.below[index]
        return any(max(map(abs, self.rows[i].one.translation)) > _SEEN for i in below)


def compared(one: Body, other: Body, how: str, tolerance: Tolerance) -> LimbComparison:
    """Compare two limbs; where something differs, without what they hold in their hands."""
    whole = LimbComparison(one, other, how, tolerance)
    if (whole.is_whole and whole.n_slips == 0) or _holds(one):
        return whole
    bare = LimbComparison(one, other, how, tolerance, LimbPart.BARE)
    return bare if len(bare.rows) < len(whole.rows) else whole


def held_parts(comparison: LimbComparison) -> Iterable[LimbComparison]:
    """Yield what two limbs hold, each compared in itself: how it is mounted is not."""
    for row in comparison.rows if comparison.part is LimbPart.BARE else ():
        if any(map(_holds, row.one.children)) and not _holds(row.one):
            tolerance = comparison.matching.tolerance
            part = LimbComparison(row.one, row.other, comparison.how, tolerance, LimbPart.HELD)
            if part.is_whole:
                yield part


def _accusation(
    body: Body, twin: Body, what: str, pose: RigidPose, cost: float, free_axis: int | None
) -> Accusation:
    if what == "translation":
        written, meant = body.translation, pose.translation
    else:
        written, meant = body.angles, angles_near(pose.rotation, body.angles, twin.angles)
    change = max(abs(x - y) for x, y in zip(written, meant, strict=True))
    slip = slip_between(written, meant, what)
    place = Suspect(body.name, body.joint, what)
    return Accusation(place, twin.name, meant, pose, cost, slip, change, free_axis)


def _whole(cost: float) -> int:
    return int(cost + _NEAR)


def _holds(body: Body) -> bool:
    return is_held(body.name, body.joint)
