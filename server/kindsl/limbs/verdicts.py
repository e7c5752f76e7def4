"""Which numbers of a robot's limbs do not fit their twins, and what they were meant to be."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from kindsl.limbs.comparison import Comparison, Single, compared, held_parts
from kindsl.limbs.conventions import LOOSE, TIGHT, Tolerance
from kindsl.limbs.limb import Body, Limbs, Side
from kindsl.limbs.slips import Slip, angles_near, change, slip_between
from kindsl.rigid.pose import RigidPose, Rotation, Vector3, transposed, turned

_OF_A_PAIR = frozenset(Slip) - {Slip.OTHER}
_OF_A_COM = frozenset((Slip.SIGN, Slip.SWAPPED, Slip.ZEROED, Slip.UNIT))
_SMALLEST_PAIR = 3
_TIE = 0.005


class Place(NamedTuple):
    """Numbers that may be wrong.

    Attributes:
        body: Whose they are.
        what: `translation` or `angles` of its joint, `kind` of it, its `com` or `moments`.
    """

    body: Body
    what: str


class Repair(NamedTuple):
    """A place with the numbers that its twins have there."""

    place: Place
    meant: Vector3


class Verdict(NamedTuple):
    """What does not fit.

    Attributes:
        places: Where: the one that is odd, or those among which nobody can choose.
        repairs: What to write, one for each way to put it right; none where that is not known.
        twins: Bodies that agree with each other, or the other half of a pair.
        is_convicted: Whether the twins outvote one limb; of a pair either may be wrong.
    """

    places: tuple[Place, ...]
    repairs: tuple[Repair, ...]
    twins: tuple[Body, ...]
    is_convicted: bool


Edges = Mapping[tuple[Side, Side], Comparison]


def verdicts(limbs: Limbs) -> list[Verdict]:
    """Return what does not fit in a group of limbs, nothing where more than a slip or two does."""
    for tolerance in (TIGHT, LOOSE):
        found = _verdicts_at(limbs, tolerance)
        if found is not None:
            return found
    return []


def _verdicts_at(limbs: Limbs, tolerance: Tolerance) -> list[Verdict] | None:
    """Return the verdicts at a tolerance, None where a wider one may tell more."""
    made = {(a, b): compared(limbs.heads[a], limbs.heads[b], how, tolerance)
            for a, b, how in limbs.pairs()}  # fmt: skip
    edges = {pair: comparison for pair, comparison in made.items() if comparison.is_whole}
    if any(comparison.other_kinds for comparison in edges.values()):
        return list(_other_kinds(edges))
    is_all_seen = all(c.part.name == "WHOLE" for c in edges.values())
    if edges and is_all_seen and all(c.n_slips == 0 for c in edges.values()):
        found = list(_masses(limbs, edges))
    else:
        found = [v for c in edges.values() for part in held_parts(c) for v in _of_pair(part)]
        outvoted = _outvoted(edges)
        if outvoted:
            verdict = _convicted(outvoted)
            found += [verdict] if verdict is not None else []
        else:
            found += [v for c in edges.values() for v in _of_pair(c)]
    return found or (None if tolerance is TIGHT else [])


class _Vote(NamedTuple):
    """A comparison in which one place explains the difference, in one or several ways."""

    comparison: Comparison
    singles: list[Single]
    is_other: bool


class _Suspect(NamedTuple):
    """A place, and the comparisons that accuse it."""

    place: Place
    votes: list[_Vote]


def _outvoted(edges: Edges) -> list[_Suspect]:
    """Return the places of the one limb that two twins or more accuse, which agree themselves."""
    accused: dict[tuple[Side, str, str], _Suspect] = {}
    for pair, comparison in edges.items():
        if comparison.n_slips != 1 or len(comparison.rows) < 2:
            continue
        by_place: dict[tuple[int, str], list[Single]] = {}
        for single in comparison.singles():
            by_place.setdefault((single.row, single.what), []).append(single)
        for (index, what), singles in by_place.items():
            row = comparison.rows[index]
            for label, body, is_other in ((pair[0], row.one, False), (pair[1], row.other, True)):
                key = label, body.joint, what
                suspect = accused.setdefault(key, _Suspect(Place(body, what), []))
                suspect.votes.append(_Vote(comparison, singles, is_other))
    found = []
    for (label, _, _), suspect in accused.items():
        others = [c for pair, c in edges.items() if label not in pair]
        if others and len(suspect.votes) > 1 and all(c.n_slips == 0 for c in others):
            found.append(suspect)
    most = max((len(suspect.votes) for suspect in found), default=0)
    return [suspect for suspect in found if len(suspect.votes) == most]


def _convicted(suspects: Sequence[_Suspect]) -> Verdict | None:
    """Return the verdict on one limb; it names one place where that is the cheapest alone."""
    ranked: list[tuple[tuple[float, Slip], int, Repair, _Suspect]] = []
    for suspect in suspects:
        meant = _agreed(suspect)
        if meant is not None:
            own = _written(suspect.place)
            costs = [
                v.comparison.least_cost_of(v.singles[0].row, suspect.place.what)
                for v in suspect.votes
            ]
            slip = slip_between(own, meant, suspect.place.what)
            rank = round(sum(costs) / len(costs), 2), slip
            ranked.append((rank, len(ranked), Repair(suspect.place, meant), suspect))
    if not ranked:
        return None
    ranked.sort(key=lambda each: each[:2])
    rank, _, repair, suspect = ranked[0]
    is_alone = len(ranked) == 1 or ranked[1][0] > rank
    places = [repair.place] if is_alone else [each[2].place for each in ranked if each[0] == rank]
    twins = [_twin(vote) for vote in suspect.votes]
    return Verdict(tuple(places), (repair,) if is_alone else (), tuple(twins), True)


def _twin(vote: _Vote) -> Body:
    row = vote.comparison.rows[vote.singles[0].row]
    return row.one if vote.is_other else row.other


class _Meant(NamedTuple):
    """What one single says: the numbers, and as a pose to be compared with others."""

    numbers: Vector3
    pose: RigidPose
    wild: int | None


def _agreed(suspect: _Suspect) -> Vector3 | None:
    """Return the numbers on which the most twins agree, two at least; None where they do not."""
    place, what = suspect.place, suspect.place.what
    said = [[_meant(vote, single, what) for single in vote.singles] for vote in suspect.votes]
    own = _written(place)
    ranked = []
    for order, each in enumerate(meant for options in said for meant in options):
        n_agreeing = sum(any(_agree(each, other, what) for other in options) for options in said)
        slip = slip_between(own, each.numbers, what)
        rank = -n_agreeing, each.wild is not None, slip, change(own, each.numbers), order
        ranked.append((rank, each.numbers, n_agreeing))
    _, numbers, n_agreeing = min(ranked)
    return numbers if n_agreeing == len(said) or n_agreeing > 1 else None


def _meant(vote: _Vote, single: Single, what: str) -> _Meant:
    row = vote.comparison.rows[single.row]
    if vote.is_other:
        pose, own, twin = vote.comparison.expected(single), row.other, row.one
    else:
        pose, own, twin = vote.comparison.expected_back(single), row.one, row.other
    wild = single.mount.free_axis if single.row == 0 and what == "translation" else None
    return _Meant(_numbers(pose, what, own, twin), pose, wild)


def _agree(one: _Meant, other: _Meant, what: str) -> bool:
    if what == "translation":
        pairs = zip(one.pose.translation, other.pose.translation, strict=True)
        wild = one.wild, other.wild
        return all(i in wild or abs(x - y) < 1e-3 for i, (x, y) in enumerate(pairs))
    rows = zip(one.pose.rotation, other.pose.rotation, strict=True)
    return all(abs(x - y) < 0.02 for row in rows for x, y in zip(*row, strict=True))


def _numbers(pose: RigidPose, what: str, own: Body, twin: Body) -> Vector3:
    if what == "translation":
        return pose.translation
    return angles_near(pose.rotation, own.angles, twin.angles)


def _written(place: Place) -> Vector3:
    body, what = place
    if what == "com":
        assert body.com is not None
        return body.com
    return body.translation if what == "translation" else body.angles


def _of_pair(comparison: Comparison) -> Iterator[Verdict]:
    """Yield what differs between a left and a right limb by one slip; either may be wrong."""
    c = comparison
    if c.n_slips != 1 or c.how != "LR" or len(c.rows) < _SMALLEST_PAIR:
        return
    is_tight = c.matching.tolerance is TIGHT
    if is_tight and Comparison(c.one, c.other, c.how, LOOSE, c.part).n_slips == 0:
        return
    options = []
    for order, single in enumerate(c.singles()):
        if single.what == "angles" and not c.is_seen_below(single.row):
            continue
        row, what = c.rows[single.row], single.what
        here = Repair(
            Place(row.one, what), _numbers(c.expected_back(single), what, row.one, row.other)
        )
        there = Repair(
            Place(row.other, what), _numbers(c.expected(single), what, row.other, row.one)
        )
        slip = min(slip_between(_written(r.place), r.meant, what) for r in (here, there))
        rank = round(single.cost, 2), slip, change(_written(there.place), there.meant), order
        options.append((rank, here, there))
    options.sort(key=lambda each: each[0])
    if options and options[0][0][1] in _OF_A_PAIR:
        tied = [each for each in options if each[0][:2] == options[0][0][:2]]
        places = dict.fromkeys(r.place for each in tied for r in each[1:])
        _, here, there = options[0]
        yield Verdict(tuple(places), (there, here), (), False)


def _other_kinds(edges: Edges) -> Iterator[Verdict]:
    """Yield the joint that is prismatic where its twins are revolute, or the reverse."""
    votes: dict[str, int] = {}
    bodies: dict[str, Body] = {}
    for comparison in edges.values():
        if len(comparison.other_kinds) > 1 or comparison.n_slips > 2:
            return
        for index in comparison.other_kinds:
            for body in comparison.rows[index][1:]:
                assert isinstance(body, Body)
                votes[body.joint] = votes.get(body.joint, 0) + 1
                bodies[body.joint] = body
    most = max(votes.values())
    odd = [bodies[joint] for joint, n in votes.items() if n == most]
    twins = tuple(bodies[joint] for joint, n in votes.items() if n < most)
    if len(odd) <= 2:
        yield Verdict(tuple(Place(body, "kind") for body in odd), (), twins, len(odd) == 1)


def _masses(limbs: Limbs, edges: Edges) -> Iterator[Verdict]:
    """Yield what masses tell where all joints agree: a CoM, moments, a joint turned round."""
    differing = {pair: c.differing_masses() for pair, c in edges.items()}
    suspects = []
    for label in limbs.heads if len(limbs.heads) > 2 else ():
        mine = [pair for pair in edges if label in pair]
        others = [pair for pair in edges if label not in pair]
        is_odd = all(differing[p] for p in mine) and not any(differing[p] for p in others)
        if is_odd and len(mine) > 1 and others:
            suspects.append((label, mine))
    if len(suspects) != 1:
        return
    label, mine = suspects[0]
    seen = {each for pair in mine for each in differing[pair]}
    if len(seen) == 1:
        (index, what) = seen.pop()
        yield _odd_mass([(edges[pair], label == pair[1]) for pair in mine], index, what)
        return
    turned_round = set.intersection(*(edges[pair].turned_joints() for pair in mine))
    if len(turned_round) == 1:
        index = turned_round.pop()
        places = [edges[pair].rows[index][2 if label == pair[1] else 1] for pair in mine]
        twins = [edges[pair].rows[index][1 if label == pair[1] else 2] for pair in mine]
        assert isinstance(places[0], Body)
        yield Verdict(
            (Place(places[0], "angles"),), (), tuple(b for b in twins if isinstance(b, Body)), True
        )


def _odd_mass(mine: Sequence[tuple[Comparison, bool]], index: int, what: str) -> Verdict:
    twins = []
    for comparison, is_other in mine:
        row = comparison.rows[index]
        twins.append(row.one if is_other else row.other)
    comparison, is_other = mine[0]
    row = comparison.rows[index]
    place = Place(row.other if is_other else row.one, what)
    convention: Rotation = comparison.best.conventions[index]
    repairs: tuple[Repair, ...] = ()
    if what == "com" and twins[0].com is not None:
        back = transposed(convention) if is_other else convention
        repairs = (Repair(place, turned(back, twins[0].com)),)
    return Verdict((place,), repairs, tuple(twins), True)
