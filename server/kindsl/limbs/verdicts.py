"""Numbers of a robot's limbs that do not fit their twins, and the numbers that were meant."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from kindsl.limbs.comparison import LOOSE, TIGHT, Accusation, LimbComparison, Suspect, Tolerance
from kindsl.limbs.limb import Limbs, Side, held_by, matched
from kindsl.rigid.pose import Vector3, pose_from, transposed, turned

# Bodies of a pair of which a number may be typed anew; of fewer it is a sign, an order, a unit.
_SMALLEST = {"LR": 3, "HELD": 2}
_SAME_PLACE, _SAME_TURN = 1e-3, 0.02
_ByTwin = Sequence[Sequence[Accusation]]
_Edges = Mapping[tuple[Side, Side], LimbComparison]


class MeantNumbers(NamedTuple):
    """A place with the numbers that its twins have there, at each assignment of parameters."""

    place: Suspect
    meant: tuple[Vector3, ...]


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


def verdicts(limbs: Limbs) -> list[LimbVerdict]:
    """Return what does not fit in a group of limbs, nothing where more than a slip or two does."""
    found = _verdicts_at(limbs, TIGHT)
    return _verdicts_at(limbs, LOOSE) or [] if found is None else found


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


def _verdicts_at(limbs: Limbs, tolerance: Tolerance) -> list[LimbVerdict] | None:
    """Return the verdicts at a tolerance, None where a wider one may tell more."""
    heads, edges, found = dict(limbs.heads), {}, []
    for one, other, how in limbs.pairs():
        rows = matched(heads[one], heads[other], limbs.are_held)
        if rows is not None:
            edges[one, other] = LimbComparison(rows, how, tolerance)
            for hands in held_by(rows) if how == "LR" else ():
                sides = zip((one, other), hands, strict=True)
                found += _verdicts_at(Limbs(tuple(sides), True, True), tolerance) or []
    _keep_to_one_way(edges)
    if any(comparison.other_kinds for comparison in edges.values()):
        return list(_other_kinds(edges)) or None
    if any(c.n_slips for c in edges.values()):
        outvoted = _outvoted(edges)
        found += _convicted(outvoted)
        found += [] if outvoted else [verdict for c in edges.values() for verdict in _of_pair(c)]
    elif tolerance is LOOSE:
        found += [verdict for label, _ in limbs.heads for verdict in _odd_masses(label, edges)]
    elif not found and not any(c.differing_masses() for c in edges.values()):
        return []
    return found or None


def _keep_to_one_way(edges: _Edges) -> None:
    """Read all pairs of a sort in the way in which one of them agrees best."""
    for how in ("LR", "ROW"):
        alike = [c for c in edges.values() if c.how == how]
        best = min((c.best for c in alike if c.n_slips == 0), key=lambda r: r.cost, default=None)
        if best is not None:
            for comparison in alike:
                comparison.keep_to(best.mount.way)


def _outvoted(edges: _Edges) -> list[_ByTwin]:
    """Return what two twins or more say of the one limb that they accuse, agreeing themselves."""
    cases: dict[tuple[Side, Suspect], dict[tuple[Side, Side], list[Accusation]]] = {}
    for pair, comparison in edges.items():
        for both in comparison.accusations() if len(comparison.rows) > 1 else ():
            for label, said in zip(pair, both, strict=True):
                cases.setdefault((label, said.place), {}).setdefault(pair, []).append(said)
    found = []
    for (label, _), by_pair in cases.items():
        others = [c for pair, c in edges.items() if label not in pair]
        if len(by_pair) > 1 and others and all(c.n_slips == 0 for c in others):
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


def _of_pair(c: LimbComparison) -> Iterator[LimbVerdict]:
    """Yield what differs between a left and a right limb by one slip; either may be wrong."""
    if c.n_slips != 1 or c.how not in _SMALLEST:
        return
    most = 1 if len(c.rows) >= _SMALLEST[c.how] else 0
    if c.tolerance is TIGHT and LimbComparison(c.rows, c.how, LOOSE).n_slips == 0:
        return
    ranked = [
        ((round(one.cost, 2), min(one.n_retyped, other.n_retyped)), other.change, (one, other))
        for one, other in c.accusations()
        if one.place.what == "translation" or c.is_seen_below(one.place.joint)
    ]
    ranked.sort(key=lambda each: each[:2])
    if ranked and ranked[0][0][1] <= most:
        tied = [both for likelihood, _, both in ranked if likelihood == ranked[0][0]]
        places = dict.fromkeys(said.place for both in tied for said in both)
        repairs = tuple(MeantNumbers(said.place, (said.meant,)) for said in tied[0][::-1])
        yield LimbVerdict(tuple(places), repairs, (), False)


def _other_kinds(edges: _Edges) -> Iterator[LimbVerdict]:
    """Yield the joint that is prismatic where its twins are revolute, or the reverse."""
    if any(len(c.other_kinds) > 1 or c.n_slips > 0 for c in edges.values()):
        return
    rows = [c.rows[index] for c in edges.values() for index in c.other_kinds]
    votes = Counter(Suspect(b.name, b.joint, "kind") for row in rows for b in (row.one, row.other))
    most = max(votes.values())
    odd = tuple(place for place, n in votes.items() if n == most)
    twins = tuple(place.link for place, n in votes.items() if n < most)
    is_pair_of_sides = len(odd) == 2 and all(c.how in _SMALLEST for c in edges.values())
    if len(odd) == 1 or is_pair_of_sides:
        yield LimbVerdict(odd, (), twins, len(odd) == 1)


def _odd_masses(label: Side, edges: _Edges) -> Iterator[LimbVerdict]:
    """Yield each CoM, and moments, that only one limb has so, where all joints agree."""
    differing = {pair: set(c.differing_masses()) for pair, c in edges.items()}
    mine = [pair for pair in edges if label in pair]
    others = [pair for pair in edges if label not in pair]
    if len(mine) < 2 or not others:
        return
    odd = set.intersection(*(differing[pair] for pair in mine))
    odd = odd.difference(*(differing[pair] for pair in others))
    for index in sorted({index for index, _ in odd}):
        words = [what for row, what in odd if row == index]
        rows = [edges[pair].rows[index] for pair in mine]
        sides = [
            (row.other, row.one) if pair[1] == label else (row.one, row.other)
            for pair, row in zip(mine, rows, strict=True)
        ]
        (body, twin), what = sides[0], words[0] if len(words) == 1 else "inertia"
        place = Suspect(body.name, body.joint, what)
        repairs: tuple[MeantNumbers, ...] = ()
        if what == "com" and twin.inertia is not None:
            C = edges[mine[0]].best.conventions[index]
            back = transposed(C) if mine[0][1] == label else C
            repairs = (MeantNumbers(place, (turned(back, twin.inertia.com),)),)
        yield LimbVerdict((place,), repairs, tuple(twin.name for _, twin in sides), True)
