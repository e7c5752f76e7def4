"""Numbers of a robot's limbs that do not fit their twins, and the numbers that were meant."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from math import inf
from typing import NamedTuple

from kindsl.limbs.comparison import LOOSE, TIGHT, LimbComparison, Tolerance
from kindsl.limbs.limb import Limbs, Match, Side, held_by, matched
from kindsl.limbs.slips import n_retyped
from kindsl.limbs.weighing import Accusation, Masses, Suspect, WeighedComparison, seen_by
from kindsl.rigid.pose import IDENTITY, Rotation, pose_from, transposed

# Bodies of a pair of which a number may be typed anew; of fewer it is a sign, an order, a unit.
_SMALLEST = {"LR": 3, "HELD": 2}
_SAME_PLACE, _SAME_TURN = 1e-3, 0.02
_Pair = tuple[Side, Side]
_ByTwin = Sequence[Sequence[Accusation]]
_Weighed = Mapping[_Pair, WeighedComparison]
_Conventions = Mapping[_Pair, Mapping[int, Rotation]]
_Differing = Mapping[_Pair, set[tuple[int, str]]]


class MeantNumbers(NamedTuple):
    """A place with the numbers that its twins have there, at each assignment of parameters."""

    place: Suspect
    meant: tuple[tuple[float, ...], ...]


class LimbVerdict(NamedTuple):
    """The misfits of a limb.

    Attributes:
        places: Where: the one that is odd, or those among which nobody can choose.
        repairs: What to write, one for each way to put it right; none where that is not known.
        twins: Names of links that agree with each other; none for a pair.
        is_convicted: Whether the twins outvote one limb; of a pair either may be wrong.
    """

    places: tuple[Suspect, ...]
    repairs: tuple[MeantNumbers, ...]
    twins: tuple[str, ...]
    is_convicted: bool


class ComparedLimbs:
    """A group of limbs compared in pairs, their masses left aside.

    Attributes:
        held: What a left and a right limb of them hold: groups of their own.
        links: The names of the links that are compared.
    """

    def __init__(self, limbs: Limbs) -> None:
        heads = dict(limbs.heads)
        self.held: list[ComparedLimbs] = []
        self._pairs: dict[_Pair, tuple[str, list[Match]]] = {}
        self._compared: dict[Tolerance, dict[_Pair, LimbComparison]] = {}
        for one, other, how in limbs.pairs():
            rows = matched(heads[one], heads[other], limbs.are_held)
            if rows is not None:
                self._pairs[one, other] = how, rows
                for hands in held_by(rows) if how == "LR" else ():
                    sides = zip((one, other), hands, strict=True)
                    self.held.append(ComparedLimbs(Limbs(tuple(sides), True, True)))
        bodies = (body for _, rows in self._pairs.values() for _, *both in rows for body in both)
        self.links = list(dict.fromkeys(body.name for body in bodies))

    def at(self, tolerance: Tolerance) -> dict[_Pair, LimbComparison]:
        """Return the pairs, compared at a tolerance."""
        if tolerance not in self._compared:
            self._compared[tolerance] = {
                pair: LimbComparison(rows, how, tolerance)
                for pair, (how, rows) in self._pairs.items()
            }
        return self._compared[tolerance]


def verdicts(limbs: ComparedLimbs, masses: Masses) -> list[LimbVerdict]:
    """Return what does not fit in a group of limbs, nothing where more than a slip or two does."""
    for tolerance in (TIGHT, LOOSE) if limbs.links else ():
        edges = limbs.at(tolerance)
        weighed = _in_one_way({pair: WeighedComparison(c, masses) for pair, c in edges.items()})
        if any(c.other_kinds for c in edges.values()):
            found = list(_other_kinds(weighed))
        elif all(c.limbs.n_slips == 0 for c in weighed.values()):
            return list(_odd_masses(weighed))
        else:
            outvoted = _outvoted(weighed)
            found = _convicted(outvoted)
            for pair, each in weighed.items() if not outvoted else ():
                if limbs.at(LOOSE)[pair].n_slips:
                    found += _of_pair(each)
        if found:
            return found
    return []


def agreed(found: Sequence[Sequence[LimbVerdict]]) -> list[LimbVerdict]:
    """Return what is found at every assignment of parameters, with what is meant at each."""
    made = []
    for verdict in found[0]:
        key = verdict.places, verdict.is_convicted
        same = [[v for v in each if (v.places, v.is_convicted) == key][:1] for each in found]
        if all(same):
            together = zip(*(each[0].repairs for each in same), strict=False)
            repairs = tuple(
                MeantNumbers(each[0].place, tuple(repair.meant[0] for repair in each))
                for each in together
            )
            made.append(verdict._replace(repairs=repairs))
    return made


def _in_one_way(edges: _Weighed) -> _Weighed:
    """Return all pairs of a sort read in the way in which one of them agrees best."""
    found = dict(edges)
    for how in ("LR", "ROW"):
        alike = {pair: c for pair, c in edges.items() if c.limbs.how == how}
        whole = [c for c in alike.values() if c.limbs.n_slips == 0]
        if whole:
            way = min(whole, key=lambda c: c.cost).best.mount.way
            found |= {pair: c.in_way(way) for pair, c in alike.items()}
    return found


def _outvoted(edges: _Weighed) -> list[_ByTwin]:
    """Return what two twins or more say of the one limb that they accuse, agreeing themselves."""
    cases: dict[tuple[Side, Suspect], dict[_Pair, list[Accusation]]] = {}
    for pair, comparison in edges.items():
        for both in comparison.accusations if len(comparison.limbs.rows) > 1 else ():
            for label, said in zip(pair, both, strict=True):
                cases.setdefault((label, said.place), {}).setdefault(pair, []).append(said)
    found = []
    for (label, _), by_pair in cases.items():
        others = [c for pair, c in edges.items() if label not in pair]
        if len(by_pair) > 1 and others and all(c.limbs.n_slips == 0 for c in others):
            found.append(list(by_pair.values()))
    most = max(map(len, found), default=0)
    return [by_twin for by_twin in found if len(by_twin) == most]


def _convicted(outvoted: Sequence[_ByTwin]) -> list[LimbVerdict]:
    """Return the verdict on one limb; it names one place where that is the cheapest alone."""
    ranked: list[tuple[tuple[float, int], Accusation, _ByTwin]] = []
    for by_twin in outvoted:
        meant = _agreed(by_twin)
        if meant is not None:
            least = [min(said.cost for said in each) for each in by_twin]
            ranked.append(((round(sum(least) / len(least), 2), meant.n_retyped), meant, by_twin))
    likeliest = [each for each in ranked if each[0] == min(ranked, key=lambda r: r[0])[0]]
    if not likeliest:
        return []
    _, meant, by_twin = likeliest[0]
    places = tuple(each.place for _, each, _ in likeliest)
    repairs = (MeantNumbers(meant.place, (meant.meant,)),) if len(likeliest) == 1 else ()
    return [LimbVerdict(places, repairs, tuple(each[0].twin for each in by_twin), True)]


def _agreed(by_twin: _ByTwin) -> Accusation | None:
    """Return that on which the most twins agree, two at least; None where they do not."""
    ranked = []
    for order, each in enumerate(said for options in by_twin for said in options):
        n_agreeing = sum(any(_agree(each, other) for other in options) for options in by_twin)
        likelihood = each.free_axis is not None, round(each.cost, 3), each.n_retyped, each.change
        ranked.append(((-n_agreeing, *likelihood, order), each))
    (n_agreeing, *_), meant = min(ranked)
    return meant if -n_agreeing > 1 else None


def _agree(one: Accusation, other: Accusation) -> bool:
    if one.place.what == "translation":
        pairs = enumerate(zip(one.meant, other.meant, strict=True))
        free = one.free_axis, other.free_axis
        return all(i in free or abs(x - y) < _SAME_PLACE for i, (x, y) in pairs)
    here, there = (pose_from((0.0, 0.0, 0.0), said.meant).numbers for said in (one, other))
    return all(abs(x - y) < _SAME_TURN for x, y in zip(here, there, strict=True))


def _of_pair(c: WeighedComparison) -> Iterator[LimbVerdict]:
    """Yield what differs between a left and a right limb by one slip; either may be wrong."""
    limbs = c.limbs
    if limbs.n_slips != 1 or limbs.how not in _SMALLEST:
        return
    most = 1 if len(limbs.rows) >= _SMALLEST[limbs.how] else 0
    ranked = [
        ((round(one.cost, 2), min(one.n_retyped, other.n_retyped)), other.change, (one, other))
        for one, other in c.accusations
        if one.place.what == "translation" or limbs.is_seen_below(one.place.joint)
    ]
    ranked.sort(key=lambda each: each[:2])
    if ranked and ranked[0][0][1] <= most:
        tied = [both for likelihood, _, both in ranked if likelihood == ranked[0][0]]
        places = dict.fromkeys(said.place for both in tied for said in both)
        repairs = tuple(MeantNumbers(said.place, (said.meant,)) for said in tied[0][::-1])
        yield LimbVerdict(tuple(places), repairs, (), False)


def _other_kinds(edges: _Weighed) -> Iterator[LimbVerdict]:
    """Yield the joint that is prismatic where its twins are revolute, or the reverse."""
    compared = [c.limbs for c in edges.values()]
    if any(len(c.other_kinds) > 1 or c.n_slips > 0 for c in compared):
        return
    rows = [c.rows[index] for c in compared for index in c.other_kinds]
    votes = Counter(Suspect(b.name, b.joint, "kind") for row in rows for b in (row.one, row.other))
    most = max(votes.values())
    odd = tuple(place for place, n in votes.items() if n == most)
    twins = tuple(place.link for place, n in votes.items() if n < most)
    is_pair_of_sides = len(odd) == 2 and all(c.how in _SMALLEST for c in compared)
    if len(odd) == 1 or is_pair_of_sides:
        yield LimbVerdict(odd, (), twins, len(odd) == 1)


def _odd_masses(edges: _Weighed) -> Iterator[LimbVerdict]:
    """Yield each mass, CoM and moments that only one limb has so, where all joints agree.

    Twins may be mirrored as the limbs are, or all have the same numbers.
    """
    mirrored = {pair: c.best.conventions for pair, c in edges.items()}
    differing = {pair: set(c.differing(mirrored[pair])) for pair, c in edges.items()}
    if not any(differing.values()):
        return
    if len(edges) == 1:
        yield from _odd_com(edges, mirrored)
    rows = {index for found in differing.values() for index, _ in found}
    copied = dict.fromkeys(edges, dict.fromkeys(rows, IDENTITY.rotation))
    as_copies = {pair: set(c.differing(copied[pair])) for pair, c in edges.items()}
    labels = dict.fromkeys(label for pair in edges for label in pair)
    for index in sorted(rows):
        # In one way for all limbs, that in which they agree most: two ways would accuse two limbs.
        here, C = min(
            (
                (_in_row(index, found), C)
                for found, C in ((differing, mirrored), (as_copies, copied))
            ),
            key=lambda way: sum(map(len, way[0].values())),
        )
        for label in labels:
            words = _only_in(label, here)
            if words:
                yield _odd_mass(label, index, words, edges, C)


def _in_row(index: int, differing: _Differing) -> dict[_Pair, set[str]]:
    return {pair: {w for row, w in found if row == index} for pair, found in differing.items()}


def _odd_com(edges: _Weighed, conventions: _Conventions) -> Iterator[LimbVerdict]:
    """Yield the one CoM that a sign or an order keeps from being that of the other side."""
    ((pair, c),) = edges.items()
    differing = c.differing(conventions[pair])
    coms = [index for index, what in differing if what == "com"]
    if len(c.limbs.rows) < _SMALLEST.get(c.limbs.how, inf) or len(coms) != 1:
        return
    alone, as_copies = [(coms[0], "com")], c.differing({coms[0]: IDENTITY.rotation})
    one, other = (_odd_mass(label, coms[0], ["com"], edges, conventions) for label in pair)
    x, y, z = one.repairs[0].meant[0]
    is_slip = n_retyped(c.masses[one.places[0].link].com, (x, y, z)) == 0
    if is_slip and [each for each in differing if each[0] == coms[0]] == alone == as_copies:
        yield LimbVerdict(other.places + one.places, other.repairs + one.repairs, (), False)


def _only_in(label: Side, differing: Mapping[_Pair, set[str]]) -> list[str]:
    """Return what differs between one limb and all its twins, and not between any others."""
    mine = [found for pair, found in differing.items() if label in pair]
    others = [found for pair, found in differing.items() if label not in pair]
    if len(mine) < 2 or not others:
        return []
    return sorted(set.intersection(*mine).difference(*others))


def _odd_mass(
    label: Side,
    index: int,
    words: Sequence[str],
    edges: _Weighed,
    conventions: _Conventions,
) -> LimbVerdict:
    mine = [pair for pair in edges if label in pair]
    rows = [edges[pair].limbs.rows[index][1:][:: 1 if pair[0] == label else -1] for pair in mine]
    (body, twin), C = rows[0], conventions[mine[0]][index]
    what = words[0] if len(words) == 1 else "inertia"
    meant = seen_by(edges[mine[0]].masses[twin.name], C if mine[0][1] == label else transposed(C))
    numbers = {"mass": (meant.mass,), "com": meant.com, "moments": meant.moments}
    place = Suspect(body.name, body.joint, what)
    repair = MeantNumbers(place, (numbers.get(what, (meant.mass, *meant.com, *meant.moments)),))
    return LimbVerdict((place,), (repair,), tuple(twin.name for _, twin in rows), True)
