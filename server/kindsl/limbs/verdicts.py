"""Which numbers of a robot's limbs do not fit their twins, and what they were meant to be."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from kindsl.limbs.comparison import Accusation, LimbComparison, Suspect, compared, held_parts
from kindsl.limbs.conventions import LOOSE, TIGHT, Tolerance
from kindsl.limbs.limb import Body, LimbPart, Limbs, Side
from kindsl.limbs.slips import SlipOfHand
from kindsl.rigid.pose import Vector3, transposed, turned

_SMALLEST_PAIR = 3
_SAME_PLACE, _SAME_TURN = 1e-3, 0.02


class MeantNumbers(NamedTuple):
    """A place with the numbers that its twins have there, at each assignment of parameters."""

    place: Suspect
    meant: tuple[Vector3, ...]


class LimbVerdict(NamedTuple):
    """What does not fit.

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


Edges = Mapping[tuple[Side, Side], LimbComparison]


def verdicts(limbs: Limbs) -> list[LimbVerdict]:
    """Return what does not fit in a group of limbs, nothing where more than a slip or two does."""
    found = _verdicts_at(limbs, TIGHT)
    return _verdicts_at(limbs, LOOSE) or [] if found is None else found


def agreed(found: Sequence[Sequence[LimbVerdict]]) -> list[LimbVerdict]:
    """Return what is found at every assignment of parameters, with what is meant at each."""
    first, *others = found
    by_places = [{(v.places, v.is_convicted): v for v in each} for each in others]
    made = []
    for verdict in first:
        same = [verdict, *(each.get((verdict.places, verdict.is_convicted)) for each in by_places)]
        known = [v.repairs for v in same if v is not None]
        if len(known) == len(same):
            repairs = tuple(
                MeantNumbers(each[0].place, tuple(repair.meant[0] for repair in each))
                for each in zip(*known, strict=False)
            )
            made.append(verdict._replace(repairs=repairs))
    return made


def _verdicts_at(limbs: Limbs, tolerance: Tolerance) -> list[LimbVerdict] | None:
    """Return the verdicts at a tolerance, None where a wider one may tell more."""
    made = {(a, b): compared(limbs.heads[a], limbs.heads[b], how, tolerance)
            for a, b, how in limbs.pairs()}  # fmt: skip
    edges = {pair: comparison for pair, comparison in made.items() if comparison.is_whole}
    _keep_to_one_way(edges)
    if any(comparison.other_kinds for comparison in edges.values()):
        return list(_other_kinds(edges))
    if all(c.part is LimbPart.WHOLE and c.n_slips == 0 for c in edges.values()):
        has_like_masses = not any(c.differing_masses() for c in edges.values())
        if tolerance is TIGHT and not has_like_masses:
            return None
        return [] if has_like_masses else _of_masses(limbs, edges)
    found = [v for c in edges.values() for part in held_parts(c) for v in _of_pair(part)]
    outvoted = _outvoted(edges, LimbComparison.accusations)
    if outvoted:
        found += _convicted(outvoted)
    else:
        found += [v for c in edges.values() for v in _of_pair(c)]
    return found or None


def _keep_to_one_way(edges: Edges) -> None:
    """Compare all pairs of a sort in the way in which one of them agrees best."""
    for how in ("LR", "ROW"):
        alike = sorted((c for c in edges.values() if c.how == how), key=lambda c: c.best.cost)
        for comparison in alike[1:] if alike and alike[0].n_slips == 0 else ():
            if comparison.way != alike[0].way:
                comparison.keep_to(alike[0].way)


_ByTwin = Sequence[Sequence[Accusation]]


def _outvoted(
    edges: Edges, said_by: Callable[[LimbComparison], Sequence[tuple[Accusation, Accusation]]]
) -> list[_ByTwin]:
    """Return what two twins or more say of the one limb that they accuse, agreeing themselves."""
    cases: dict[tuple[Side, Suspect], dict[tuple[Side, Side], list[Accusation]]] = {}
    for pair, comparison in edges.items():
        for both in said_by(comparison) if len(comparison.rows) > 1 else ():
            for label, said in zip(pair, both, strict=True):
                cases.setdefault((label, said.place), {}).setdefault(pair, []).append(said)
    found = []
    for (label, _), by_pair in cases.items():
        others = [c for pair, c in edges.items() if label not in pair]
        if len(by_pair) > 1 and others and all(c.n_slips == 0 for c in others):
            found.append(list(by_pair.values()))
    most = max(map(len, found), default=0)
    return [by_twin for by_twin in found if len(by_twin) == most]


def _convicted(outvoted: Sequence[_ByTwin]) -> Iterator[LimbVerdict]:
    """Yield the verdict on one limb; it names one place where that is the cheapest alone."""
    ranked: list[tuple[float, SlipOfHand, Accusation, _ByTwin]] = []
    for by_twin in outvoted:
        meant = _agreed(by_twin)
        if meant is not None:
            least = [min(said.cost for said in each) for each in by_twin]
            ranked.append((round(sum(least) / len(least), 2), meant.slip, meant, by_twin))
    ranked.sort(key=lambda each: each[:2])
    likeliest = [each for each in ranked if each[:2] == ranked[0][:2]]
    if likeliest:
        places = tuple(meant.place for _, _, meant, _ in likeliest)
        _, _, meant, by_twin = likeliest[0]
        repairs = (MeantNumbers(meant.place, (meant.meant,)),) if len(likeliest) == 1 else ()
        yield LimbVerdict(places, repairs, tuple(each[0].twin for each in by_twin), True)


def _agreed(by_twin: _ByTwin) -> Accusation | None:
    """Return that on which the most twins agree, two at least; None where they do not."""
    ranked = []
    for order, each in enumerate(said for options in by_twin for said in options):
        n_agreeing = sum(any(_agree(each, other) for other in options) for options in by_twin)
        likelihood = each.free_axis is not None, round(each.cost, 3), each.slip, each.change
        ranked.append(((-n_agreeing, *likelihood, order), each))
    (n_agreeing, *_), meant = min(ranked)
    return meant if -n_agreeing > 1 else None


def _agree(one: Accusation, other: Accusation) -> bool:
    if one.place.what == "translation":
        pairs = enumerate(zip(one.meant, other.meant, strict=True))
        free = one.free_axis, other.free_axis
        return all(i in free or abs(x - y) < _SAME_PLACE for i, (x, y) in pairs)
    rows = zip(one.pose.rotation, other.pose.rotation, strict=True)
    return all(abs(x - y) < _SAME_TURN for row in rows for x, y in zip(*row, strict=True))


def _of_pair(comparison: LimbComparison) -> Iterator[LimbVerdict]:
    """Yield what differs between a left and a right limb by one slip; either may be wrong."""
    c = comparison
    if c.n_slips != 1 or c.how != "LR" or len(c.rows) < _SMALLEST_PAIR:
        return
    is_tight = c.matching.tolerance is TIGHT
    if is_tight and LimbComparison(c.one, c.other, c.how, LOOSE, c.part).n_slips == 0:
        return
    ranked = [
        ((round(one.cost, 2), min(one.slip, other.slip)), other.change, order, (one, other))
        for order, (one, other) in enumerate(c.accusations())
        if one.place.what == "translation" or c.is_seen_below(one.place.joint)
    ]
    ranked.sort(key=lambda each: each[:3])
    if ranked and ranked[0][0][1] is not SlipOfHand.OTHER:
        tied = [each[3] for each in ranked if each[0] == ranked[0][0]]
        places = dict.fromkeys(said.place for both in tied for said in both)
        one, other = tied[0]
        repairs = MeantNumbers(other.place, (other.meant,)), MeantNumbers(one.place, (one.meant,))
        yield LimbVerdict(tuple(places), repairs, (), False)


def _other_kinds(edges: Edges) -> Iterator[LimbVerdict]:
    """Yield the joint that is prismatic where its twins are revolute, or the reverse."""
    votes: dict[Suspect, int] = {}
    for comparison in edges.values():
        if len(comparison.other_kinds) > 1 or comparison.n_slips > 0:
            return
        for index in comparison.other_kinds:
            _, one, other = comparison.rows[index]
            for body in (one, other):
                place = Suspect(body.name, body.joint, "kind")
                votes[place] = votes.get(place, 0) + 1
    most = max(votes.values())
    odd = tuple(place for place, n in votes.items() if n == most)
    twins = tuple(place.link for place, n in votes.items() if n < most)
    is_pair_of_sides = len(odd) == 2 and all(c.how == "LR" for c in edges.values())
    if len(odd) == 1 or is_pair_of_sides:
        yield LimbVerdict(odd, (), twins, len(odd) == 1)


def _of_masses(limbs: Limbs, edges: Edges) -> list[LimbVerdict]:
    """Return what masses tell where all joints agree: of themselves, or of a joint turned round."""
    found = list(_odd_masses(limbs, edges))
    if any(verdict.places[0].what == "inertia" for verdict in found):
        return list(_convicted(_outvoted(edges, LimbComparison.turnings))) or found
    return found


def _odd_masses(limbs: Limbs, edges: Edges) -> Iterator[LimbVerdict]:
    """Yield each CoM, and moments, that only one limb has so, where all joints agree."""
    differing = {pair: set(c.differing_masses()) for pair, c in edges.items()}
    for label in limbs.heads:
        mine = [pair for pair in edges if label in pair]
        others = [pair for pair in edges if label not in pair]
        if len(mine) > 1 and others:
            odd = set.intersection(*(differing[pair] for pair in mine))
            odd = odd.difference(*(differing[pair] for pair in others))
            by_row = {
                index: [what for row, what in sorted(odd) if row == index] for index, _ in odd
            }
            for index, words in sorted(by_row.items()):
                what = words[0] if len(words) == 1 else "inertia"
                yield _odd_mass([(edges[pair], label == pair[1]) for pair in mine], index, what)


def _odd_mass(mine: Sequence[tuple[LimbComparison, bool]], index: int, what: str) -> LimbVerdict:
    comparison, is_other = mine[0]
    body, twin = _body_and_twin(comparison, index, is_other)
    place = Suspect(body.name, body.joint, what)
    convention = comparison.best.conventions[index]
    repairs: tuple[MeantNumbers, ...] = ()
    if what == "com" and twin.com is not None:
        back = transposed(convention) if is_other else convention
        repairs = (MeantNumbers(place, (turned(back, twin.com),)),)
    twins = tuple(_body_and_twin(c, index, other)[1].name for c, other in mine)
    return LimbVerdict((place,), repairs, twins, True)


def _body_and_twin(comparison: LimbComparison, index: int, is_other: bool) -> tuple[Body, Body]:
    _, one, other = comparison.rows[index]
    return (other, one) if is_other else (one, other)
