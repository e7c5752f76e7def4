"""The ways to read a limb as its peer with the masses of both, the likeliest first."""

from collections.abc import Mapping
from math import dist, inf
from operator import sub
from typing import NamedTuple

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import Rotation, Vector3, product, transposed, turned
from kindsl.robots.limbs.comparison import LOOSE, LimbComparison, Reading, Tolerance
from kindsl.robots.limbs.limb import Body
from kindsl.robots.limbs.mounts import Way
from kindsl.robots.limbs.slips import angles_near, is_near, n_retyped, n_slips

# Cost of a mass, CoM or tensor that differs: it breaks ties, and many are less than a slip. Half
# and twice of it change nothing in 111 planted slips.
_OF_MASS = 0.004

# In the link frames, of the links of which they are known.
Masses = Mapping[str, MassDistribution]


class Suspect(NamedTuple):
    """Numbers of a limb, or what else may be wrong.

    Attributes:
        link: The name of the link.
        joint: The name of the joint that supports it.
        what: `translation` or `angles` of the joint, `kind` or `axis` of it, `mass`, `com` or
            `moments` of the link, `inertia` for several of them.
    """

    link: str
    joint: str
    what: str


class Accusation(NamedTuple):
    """A place that, written otherwise, makes a limb like its peer.

    Attributes:
        place: Where it stands.
        peer: The link that says so.
        meant: The numbers that it should have; none of a kind of joint.
        cost: Of what is odd besides.
        n_retyped: How many of the numbers that stand in the text no sign, order or unit explains.
        n_slips: How many slips make these of those meant.
        n_unlike: How many of those meant are not the peer's, but for signs.
        change: The greatest difference of a number.
        free_axis: Along which the peer can say nothing, if any.
    """

    place: Suspect
    peer: str
    meant: tuple[float, ...] = ()
    cost: float = 0.0
    n_retyped: int = 0
    n_slips: int = 0
    n_unlike: int = 0
    change: float = 0.0
    free_axis: int | None = None


class MeantNumbers(NamedTuple):
    """A place with the numbers that its peers have there, at each assignment of parameters.

    Without numbers where these cannot be written by themselves.
    """

    place: Suspect
    meant: tuple[tuple[float, ...], ...]


class LimbVerdict(NamedTuple):
    """The misfits of a limb.

    Attributes:
        places: Where: the one that is odd, or those among which nobody can choose.
        repairs: What to write, one for each way to put it right; none where that is not known.
        peers: Names of links that agree with each other; none for a pair.
        is_convicted: Whether the peers outvote one limb; of a pair either may be wrong.
        may_be_zero: Whether both are alike if the zero of a joint is half a turn away.
    """

    places: tuple[Suspect, ...]
    repairs: tuple[MeantNumbers, ...]
    peers: tuple[str, ...]
    is_convicted: bool
    may_be_zero: bool = False


class WeighedComparison:
    """Two limbs, their masses compared too.

    Attributes:
        limbs: The limbs.
        masses: Of their links.
        ranked: The readings with their costs, for each mount, slip and convention the cheapest one.
        n_slips: The number of triples and kinds that differ: 0, 1, or 2 for more.
    """

    def __init__(self, limbs: LimbComparison, masses: Masses, way: Way | None = None) -> None:
        self.limbs, self.masses = limbs, masses
        self._known: dict[tuple[int, Rotation], list[str]] = {}
        readings = limbs.readings(way)
        is_whole = any(reading.slip is None for reading in readings)
        n_slips = len(limbs.other_kinds) + (not is_whole)
        self.n_slips = min(n_slips, 2) if readings else 2
        # No mass can make a reading with a costlier mount the cheapest, where none has a slip.
        most = 3 * _OF_MASS * len(limbs.rows) if is_whole else inf
        ranked: dict[object, tuple[float, Reading]] = {}
        for reading in readings:
            if reading.mount.extra > readings[0].mount.extra + most:
                break
            n_differing = len(self.differing(reading.conventions))
            cost = reading.mount.extra + _OF_MASS * n_differing
            C = reading.conventions[reading.slip[0]] if reading.slip is not None else None
            key = reading.mount, reading.slip, C
            if key not in ranked or cost < ranked[key][0]:
                ranked[key] = cost, reading
        self.ranked = sorted(ranked.values(), key=lambda each: each[0])

    @property
    def best(self) -> tuple[float, Reading]:
        """The cheapest reading, there must be one, and its cost."""
        return self.ranked[0]

    def in_way(self, way: Way) -> "WeighedComparison":
        """Return the limbs read in one way, unless that is the cheapest, or none of theirs."""
        if self.ranked and self.best[1].mount.way == way:
            return self
        return WeighedComparison(self.limbs, self.masses, way)

    def differing(self, conventions: Mapping[int, Rotation]) -> list[tuple[int, str]]:
        """Return rows with `mass`, `com` or `moments` where these are not alike."""
        found = []
        for index, C in conventions.items():
            known = self._known.get((index, C))
            if known is None:
                _, one, other = self.limbs.rows[index]
                here, there = self.masses.get(one.name), self.masses.get(other.name)
                known = differing(seen_by(here, C), there) if here and there else []
                self._known[index, C] = known
            found += [(index, what) for what in known]
        return found

    @property
    def is_of_one_place(self) -> bool:
        """True if all joints, and some mass, of one limb are where those of the other are."""
        return any(one.name in self.masses for _, one, _ in self.limbs.rows) and all(
            LOOSE.is_same(one.translation, other.translation)
            and max(map(dist, one.rotation, other.rotation)) < LOOSE.angle
            for _, one, other in self.limbs.rows
        )

    def accusations(self, usual: float = 0.0) -> list[tuple[Accusation, Accusation]]:
        """Return the places that alone explain the difference at the least cost, as of either limb.

        Each is given with all numbers that it may have been meant to have, at any cost.

        Args:
            usual: The cost of limbs that agree: what costs no more explains as well.
        """
        if self.n_slips != 1:
            return []
        for _, one, other in (self.limbs.rows[index] for index in self.limbs.other_kinds):
            here, there = (
                Suspect(one.name, one.joint, "kind"),
                Suspect(other.name, other.joint, "kind"),
            )
            return [(Accusation(here, other.name), Accusation(there, one.name))]
        most = max(self.best[0], usual)
        cheapest = {reading.slip or () for cost, reading in self.ranked if cost <= most}
        ranked = sorted(self.ranked, key=lambda each: each[1].slip or ())
        return [self._accused(*each) for each in ranked if each[1].slip in cheapest]

    def _accused(self, cost: float, reading: Reading) -> tuple[Accusation, Accusation]:
        mount, conventions, slip = reading
        assert slip is not None
        (index, what), (up, one, other) = slip, self.limbs.rows[slip[0]]
        back = conventions[up] if up >= 0 else transposed(mount.map)
        forth, here = transposed(back), turned(transposed(back), one.translation)
        there = here if up >= 0 else mount.place
        pairs = zip(other.translation, here, there, strict=True)
        x, y, z = (own + seen - place for own, seen, place in pairs)
        forward = product(product(forth, one.rotation), conventions[index])
        backward = product(product(back, other.rotation), transposed(conventions[index]))
        free_axis = mount.free_axis if index == 0 and what == "translation" else None

        def accusation(body: Body, peer: Body, place: Vector3, rotation: Rotation) -> Accusation:
            own, meant = body.translation, place
            if what == "angles":
                own, meant = body.angles, angles_near(rotation, body.angles, peer.angles)
            change = max(abs(x - y) for x, y in zip(own, meant, strict=True))
            typed = body.as_written(what), body.to_write(what, meant)
            n_new, n_all = (n(*typed, are_angles=what == "angles") for n in (n_retyped, n_slips))
            theirs = zip(typed[1], peer.as_written(what), strict=True)
            n_unlike = sum(not is_near(abs(x), abs(y)) for x, y in theirs)
            counts = n_new, n_all, n_unlike
            suspect = Suspect(body.name, body.joint, what)
            return Accusation(suspect, peer.name, meant, cost, *counts, change, free_axis)

        return accusation(one, other, turned(back, (x, y, z)), backward), accusation(
            other, one, there, forward
        )


def differing(
    here: MassDistribution, there: MassDistribution, within: Tolerance = LOOSE
) -> list[str]:
    """Return `mass`, `com` and `moments` where two bodies in one frame differ."""
    if here == there:
        return []
    found = [] if abs(there.mass - here.mass) <= within.share * abs(here.mass) else ["mass"]
    if not within.is_same(there.com, here.com):
        found.append("com")
    if here.moments != there.moments:
        allowed = max(1e-7, within.share * max(map(abs, here.moments)))
        if max(map(abs, map(sub, here.moments, there.moments))) > allowed:
            found.append("moments")
    return found


def seen_by(body: MassDistribution, C: Rotation) -> MassDistribution:
    """Return a body as it is in the frame of its peer."""
    (a, b, _), (c, d, _), (_, _, e) = C
    xx, yy, zz, xy, xz, yz = body.moments
    moments = (xx, yy, zz, a * d * xy, a * e * xz, d * e * yz)
    if not a:
        moments = (yy, xx, zz, b * c * xy, c * e * yz, b * e * xz)
    return MassDistribution(body.mass, turned(transposed(C), body.com), moments)
