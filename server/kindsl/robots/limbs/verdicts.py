"""Numbers of a robot's limbs that do not fit their peers, and the numbers that were meant.

Limbs of a group are read in pairs. Where three are alike but for one, and one place of it would
make it alike, its peers convict that place; of two limbs either may be wrong. Where all joints
agree, each mass, CoM and moments that one limb only has so is convicted.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, combinations
from math import dist, inf
from operator import sub
from typing import NamedTuple

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import (
    IDENTITY,
    Rotation,
    Vector3,
    dot,
    pose_from,
    product,
    transposed,
    turned,
)
from kindsl.robots.limbs.comparison import LimbComparison, Reading
from kindsl.robots.limbs.limb import Body, Limbs, Side, held_by, matched
from kindsl.robots.limbs.mounts import ALONG, MIRRORS, REFLECTIONS, SAME_PLACE
from kindsl.robots.limbs.names import is_held
from kindsl.robots.limbs.slips import n_retyped
from kindsl.robots.limbs.weighing import Accusation, Masses, Suspect, WeighedComparison, seen_by

# Bodies of a pair of which a number may be typed anew; of fewer it is a sign, an order, a unit.
_SMALLEST = {"LR": 3, "HELD": 2}
# Of the numbers of a turn that two limbs let expect.
_SAME_TURN = 0.02
_PLACE_OF_HEAD = 0, "translation"
# How far a left and a right part are apart whose numbers come from drawings of their own, as a
# share of the greatest moment, and of what a sign of the CoM changes. Of 609 published robots none
# has such a sign off but in bodies that were copied.
_AS_DRAWN = 0.1
# So many times nearer as mirror images than as copies moments are of bodies that were mirrored.
_NEARER = 3.0
# A limb in another is its copy, or mirrored in the plane across its axis.
_SIDES = (IDENTITY.rotation, MIRRORS[2])
_HALF_A_TURN = ((-1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0))
_Pair = tuple[Side, Side]
_ByPeer = Sequence[Sequence[Accusation]]
_Weighed = Mapping[_Pair, WeighedComparison]
_Way = Mapping[_Pair, Rotation]


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


class ComparedLimbs:
    """A group of limbs compared in pairs, their masses left aside.

    Attributes:
        pairs: The comparisons.
        held: What a left and a right limb of them hold: groups of their own.
        links: The names of the links that are compared.
    """

    def __init__(self, limbs: Limbs) -> None:
        heads = dict(limbs.heads)
        self.held: list[ComparedLimbs] = []
        self.pairs: dict[_Pair, LimbComparison] = {}
        for one, other, how in limbs.pairs():
            rows = matched(heads[one], heads[other])
            if rows is not None:
                self.pairs[one, other] = LimbComparison(rows, how, base=limbs.base)
                for hands in held_by(rows) if how == "LR" else ():
                    sides = zip((one, other), hands, strict=True)
                    self.held.append(ComparedLimbs(Limbs(tuple(sides), True, True)))
        compared = (row for pair in self.pairs.values() for row in pair.rows)
        self.links = list(dict.fromkeys(body.name for _, *both in compared for body in both))


def verdicts(carried: Sequence[ComparedLimbs], masses: Masses) -> list[list[LimbVerdict]]:
    """Return what does not fit in each group of limbs of a carrier.

    It is nothing where more than a slip or two does.
    """
    groups = [
        {pair: WeighedComparison(c, masses) for pair, c in limbs.pairs.items()} for limbs in carried
    ]
    return [_of_group(_without_strangers(_in_one_way(group, groups))) for group in groups]


def _of_group(weighed: _Weighed) -> list[LimbVerdict]:
    if all(c.n_slips == 0 for c in weighed.values()):
        within = [verdict for c in weighed.values() for verdict in _within_each_other(c)]
        return within or [
            verdict for alike in _connected(weighed) for verdict in _odd_masses(alike)
        ]
    return _convicted(weighed) or [v for c in weighed.values() for v in _of_pair(c)]


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


def _in_one_way(pairs: _Weighed, groups: Sequence[_Weighed]) -> _Weighed:
    """Return all pairs of a sort read in the way in which one of them agrees best.

    A left and a right limb for whose places a turn alone accounts are read as others of their
    carrier.
    """
    found = dict(pairs)
    for how in ("LR", "ROW"):
        alike = {pair: c for pair, c in pairs.items() if c.limbs.how == how}
        best = _best([*alike.values()])
        if best is None:
            continue
        others = _best([c for g in groups for c in g.values() if c.limbs.how == how == "LR"])
        if others is not None and others.mount.extra < best.mount.extra:
            mirrored = {pair: c.in_way(others.mount.way) for pair, c in alike.items()}
            slips = {r.slip for c in mirrored.values() for _, r in c.ranked}
            if slips == {_PLACE_OF_HEAD}:
                found |= mirrored
                continue
        found |= {pair: c.in_way(best.mount.way) for pair, c in alike.items()}
    return found


def _best(pairs: Sequence[WeighedComparison]) -> Reading | None:
    """Return the cheapest reading of pairs that agree."""
    whole = [c.best for c in pairs if c.n_slips == 0]
    return min(whole, key=lambda each: each[0])[1] if whole else None


def _without_strangers(pairs: _Weighed) -> _Weighed:
    """Return the pairs without limbs that differ from every other by more than a slip: a thumb."""
    kin = {label for pair, c in pairs.items() if c.n_slips <= 1 for label in pair}
    return {pair: c for pair, c in pairs.items() if kin.issuperset(pair)}


def _connected(pairs: _Weighed) -> Iterator[_Weighed]:
    """Yield the pairs of limbs that match each other: front and rear ones may have other links."""
    rest = dict(pairs)
    while rest:
        sides, together = set(next(iter(rest))), dict[_Pair, WeighedComparison]()
        while found := [pair for pair in rest if not sides.isdisjoint(pair)]:
            together |= {pair: rest.pop(pair) for pair in found}
            sides.update(chain.from_iterable(found))
        yield together


def _convicted(pairs: _Weighed) -> list[LimbVerdict]:
    """Return the verdict of two peers or more, which agree themselves, on the limb they accuse.

    It names one place where that is the cheapest alone.
    """
    cases: dict[tuple[Side, Suspect], dict[_Pair, list[Accusation]]] = {}
    for pair, c in pairs.items():
        for both in c.accusations if len(c.limbs.rows) > 1 or c.limbs.other_kinds else ():
            for label, said in zip(pair, both, strict=True):
                cases.setdefault((label, said.place), {}).setdefault(pair, []).append(said)
    ranked: list[tuple[tuple[float, ...], Accusation, _ByPeer]] = []
    by_peer: _ByPeer
    for (label, _), by_pair in cases.items():
        others = [c for pair, c in pairs.items() if label not in pair]
        by_peer = list(by_pair.values())
        meant = _agreed(by_peer)
        if meant is not None and others and all(c.n_slips == 0 for c in others):
            cost = sum(min(said.cost for said in each) for each in by_peer) / len(by_peer)
            is_there = _is_at_another(pairs, label, meant)
            likelihood = -len(by_peer), is_there, round(cost, 2), meant.n_slips
            ranked.append((likelihood, meant, by_peer))
    ranked.sort(key=lambda each: each[0])
    likeliest = [each for each in ranked if each[0] == ranked[0][0]]
    if not likeliest:
        return []
    _, meant, by_peer = likeliest[0]
    places = tuple(said.place for _, said, _ in likeliest)
    repairs = (MeantNumbers(meant.place, (meant.meant,)),) if len(likeliest) == 1 else ()
    return [LimbVerdict(places, repairs, tuple(each[0].peer for each in by_peer), True)]


def _is_at_another(pairs: _Weighed, label: Side, said: Accusation) -> bool:
    """Return whether a limb so mended would be where another is, though all others are apart."""
    heads: dict[Side, Body] = {}
    for pair, c in pairs.items():
        heads |= dict(zip(pair, c.limbs.rows[0][1:], strict=True))
    own = heads.pop(label)
    is_moved = said.place == Suspect(own.name, own.joint, "translation")
    place = said.meant if is_moved else own.translation
    places = [head.translation for head in heads.values()]
    return any(dist(place, each) < SAME_PLACE for each in places) and all(
        dist(x, y) >= SAME_PLACE for x, y in combinations(places, 2)
    )


def _agreed(by_peer: _ByPeer) -> Accusation | None:
    """Return that on which the most peers agree, two at least; None where they do not."""
    ranked = []
    for order, each in enumerate(said for options in by_peer for said in options):
        n_agreeing = sum(any(_agree(each, other) for other in options) for options in by_peer)
        likelihood = each.free_axis is not None, round(each.cost, 3), each.n_retyped, each.change
        ranked.append(((-n_agreeing, *likelihood, order), each))
    (n_agreeing, *_), meant = min(ranked)
    return meant if -n_agreeing > 1 else None


def _agree(one: Accusation, other: Accusation) -> bool:
    here, there, within = one.meant, other.meant, SAME_PLACE
    if one.place.what == "angles":
        here, there, within = _matrix(*here), _matrix(*there), _SAME_TURN
    free = one.free_axis, other.free_axis
    pairs = enumerate(zip(here, there, strict=True))
    return all(i in free or abs(x - y) < within for i, (x, y) in pairs)


def _matrix(x: float, y: float, z: float) -> tuple[float, ...]:
    return pose_from((0.0, 0.0, 0.0), (x, y, z)).numbers


def _of_pair(c: WeighedComparison) -> Iterator[LimbVerdict]:
    """Yield what differs between a left and a right limb by one slip; either may be wrong."""
    limbs = c.limbs
    if limbs.how not in _SMALLEST:
        return
    most = 1 if len(limbs.rows) >= _SMALLEST[limbs.how] else 0
    ranked = [
        ((round(one.cost, 2), min(one.n_retyped, other.n_retyped)), (one, other))
        for one, other in c.accusations
    ]
    likeliest = min((likelihood for likelihood, _ in ranked), default=(0.0, most + 1))
    # What the likeliest readings cannot tell is not told of another one.
    tied = [
        (one, other)
        for likelihood, (one, other) in ranked
        if likelihood == likeliest
        if one.place.what != "angles"
        or limbs.is_seen_below(one.place.joint)
        or _turns_axis(limbs, one)
        if not _is_base_at_one(limbs, one)
    ]
    if tied and likeliest[1] <= most:
        tied.sort(key=lambda both: (both[0].n_slips + both[1].n_slips, both[1].change))
        places = dict.fromkeys(said.place for both in tied for said in both)
        # Each as the reading has it in which it has the fewest slips, and mirrored rather than
        # where its peer is.
        at = {body.name: body.translation for _, *both in limbs.rows for body in both}
        repairs = []
        for i, first in enumerate(tied[0]):
            own = (both[i] for both in tied if both[i].place == first.place)
            meant = min(own, key=lambda said: (said.n_slips, said.meant == at[said.peer]))
            repairs.append(MeantNumbers(meant.place, (meant.meant,)))
        is_zero = any(_is_of_other_zero(limbs, said) for both in tied for said in both)
        yield LimbVerdict(tuple(places), tuple(repairs[::-1]), (), False, is_zero)


def _within_each_other(c: WeighedComparison) -> Iterator[LimbVerdict]:
    """Yield a left and a right limb that are at one place, off the plane in which they turn.

    What slides begins where its peer does, and so may what is held. In a robot that moves in a
    plane one leg lies in the other, and the axes of their joints are across it.
    """
    heads = c.limbs.rows[0][1:]
    is_moved = any(head.kind == "prismatic" or is_held(head.name) for head in heads)
    if c.limbs.how != "LR" or is_moved or not c.is_of_one_place:
        return
    rows = range(len(c.limbs.rows))
    if any(not c.differing(dict.fromkeys(rows, C)) for C in _SIDES):
        places = tuple(Suspect(head.name, head.joint, "translation") for head in heads[::-1])
        for axis, (_, _, along) in enumerate(heads[0].rotation):
            if abs(along) > ALONG and abs(heads[0].translation[axis]) > SAME_PLACE:
                meant = (turned(MIRRORS[axis], heads[0].translation),)
                yield LimbVerdict(places, tuple(MeantNumbers(p, meant) for p in places), (), False)


def _turns_axis(limbs: LimbComparison, said: Accusation) -> bool:
    """Return whether a joint would turn about another axis."""
    bodies = (body for _, *both in limbs.rows for body in both)
    own = next(body for body in bodies if body.joint == said.place.joint)
    meant = pose_from((0.0, 0.0, 0.0), (said.meant[0], said.meant[1], said.meant[2])).rotation
    one, other = transposed(own.rotation)[2], transposed(meant)[2]
    return abs(dot(one, other)) < ALONG


def _is_of_other_zero(limbs: LimbComparison, said: Accusation) -> bool:
    """Return whether a joint's zero would only be half a turn away: the wrists of Atlas are so."""
    bodies = (body for _, *both in limbs.rows for body in both)
    own = next((body for body in bodies if body.joint == said.place.joint), None)
    if said.place.what != "angles" or own is None or own.kind != "revolute":
        return False
    meant = pose_from((0.0, 0.0, 0.0), (said.meant[0], said.meant[1], said.meant[2])).rotation
    turn = product(transposed(own.rotation), meant)
    return all(dist(a, b) < _SAME_TURN for a, b in zip(turn, _HALF_A_TURN, strict=True))


def _is_base_at_one(limbs: LimbComparison, said: Accusation) -> bool:
    """Return whether a carrier's origin lies at one of two heads, so that no plane is between.

    Fingers may begin at one place.
    """
    _, one, other = limbs.rows[0]
    heads = one.joint, other.joint
    if said.place.what != "translation" or said.place.joint not in heads:
        return False
    peer = other if said.place.joint == one.joint else one
    is_sliding = one.kind == other.kind == "prismatic"
    is_there = not (is_sliding or is_held(one.name, other.name)) and all(
        abs(x - y) < SAME_PLACE for x, y in zip(said.meant, peer.translation, strict=True)
    )
    return is_there or not any(one.translation) or not any(other.translation)


def _odd_masses(pairs: _Weighed) -> Iterator[LimbVerdict]:
    """Yield each mass, CoM and moments that only one limb has so, where all joints agree.

    All limbs are read in one way, that in which they agree most: two ways would accuse two limbs.
    """
    mirrored = {pair: c.best[1].conventions for pair, c in pairs.items()}
    odd = {index for pair, c in pairs.items() for index, _ in c.differing(mirrored[pair])}
    if len(pairs) == 1 and odd:
        yield from _odd_com(pairs, mirrored)
    for index in sorted(odd):
        given = {pair: each[index] for pair, each in mirrored.items()}
        found = [(_differing(pairs, index, way), way) for way in _ways(pairs, given, index)]
        n_fewest = min(_n_words(differing) for differing, _ in found)
        likeliest: dict[tuple[Side, ...], list[LimbVerdict]] = {}
        for differing, way in found:
            if _n_words(differing) == n_fewest:
                accused = dict(_accused(differing))
                said = [_odd_mass(side, index, accused[side], pairs, way) for side in accused]
                likeliest.setdefault(tuple(accused), said)
        yield from _chosen([said for said in likeliest.values() if said])


def _chosen(likeliest: Sequence[Sequence[LimbVerdict]]) -> Iterator[LimbVerdict]:
    """Yield what is said if it is said in one way; else one verdict on all, without repairs."""
    if len(likeliest) == 1:
        yield from likeliest[0]
    elif likeliest:
        every = list(chain.from_iterable(likeliest))
        places = dict.fromkeys(place for verdict in every for place in verdict.places)
        suspects = {place.link for place in places}
        peers = dict.fromkeys(t for v in every for t in v.peers if t not in suspects)
        yield LimbVerdict(tuple(places), (), tuple(peers), True)


def _accused(differing: Mapping[_Pair, set[str]]) -> Iterator[tuple[Side, list[str]]]:
    """Yield each limb that differs from all others, which agree, and in what."""
    for label in dict.fromkeys(label for pair in differing for label in pair):
        mine = [words for pair, words in differing.items() if label in pair]
        others = [words for pair, words in differing.items() if label not in pair]
        words = set.intersection(*mine).difference(*others)
        if words and len(mine) > 1 and others:
            yield label, sorted(words)


def _n_words(differing: Mapping[_Pair, set[str]]) -> int:
    return sum(map(len, differing.values()))


def _ways(pairs: _Weighed, mirrored: _Way, index: int) -> Iterator[_Way]:
    """Yield how peers may lie: as the limbs do, all alike, or mirrored in one row.

    Hips often are where the rest is copied; what they carry stays where it is.
    """
    yield mirrored
    yield dict.fromkeys(pairs, IDENTITY.rotation)
    rows = {pair: C for pair, C in mirrored.items() if pairs[pair].limbs.how == "ROW"}
    places = [r.one.translation for p in rows for r in pairs[p].limbs.rows if r.up == index]
    for signs in REFLECTIONS[1:] if rows else ():
        if all(
            abs(x) < SAME_PLACE for place in places for x in map(sub, turned(signs, place), place)
        ):
            yield {**mirrored, **{pair: product(signs, C) for pair, C in rows.items()}}


def _differing(pairs: _Weighed, index: int, way: _Way) -> dict[_Pair, set[str]]:
    return {p: {what for _, what in c.differing({index: way[p]})} for p, c in pairs.items()}


def _odd_com(
    pairs: _Weighed, conventions: Mapping[_Pair, Mapping[int, Rotation]]
) -> Iterator[LimbVerdict]:
    """Yield the one CoM that a sign or an order keeps from being that of the other side."""
    ((pair, c),) = pairs.items()
    if len(c.limbs.rows) < _SMALLEST.get(c.limbs.how, inf):
        return
    found = [(index, coms) for index in conventions[pair] if (coms := _meant_coms(c, index))]
    if len(found) != 1:
        return
    ((index, coms),) = found
    if c.limbs.how == "HELD" and not index:
        return  # Fingers may be copies where their palm, of the arm's, is mirrored.
    bodies = c.limbs.rows[index][1:]
    both = [
        MeantNumbers(Suspect(body.name, body.joint, "com"), (meant,))
        for body, meant in zip(bodies, coms, strict=True)
    ][::-1]
    yield LimbVerdict(tuple(each.place for each in both), tuple(both), (), False)


def _meant_coms(c: WeighedComparison, index: int) -> tuple[Vector3, ...]:
    """Return the CoM of either body of a row that would fit the other's; none if they may be meant.

    They may where one way to read the limbs, or a copy, explains them. Of a sign the rest of both
    may differ as left and right parts do that come from drawings of their own.
    """
    _, one, other = c.limbs.rows[index]
    here, there = c.masses.get(one.name), c.masses.get(other.name)
    ways = [reading.conventions[index] for cost, reading in c.ranked if cost == c.best[0]]
    differ = [c.differing({index: C}) for C in ways]
    as_copies = c.differing({index: IDENTITY.rotation})
    if here is None or there is None or any((index, "com") not in each for each in differ):
        return ()
    if (index, "com") not in as_copies:
        off = min(_apart(seen_by(here, C).moments, there.moments) for C in ways)
        if _apart(here.moments, there.moments) <= _NEARER * off:
            return ()
    for C, words in zip(ways, differ, strict=True):
        back = seen_by(there, transposed(C))
        sign = _sign_off(here, back)
        if sign is not None:
            return turned(sign, here.com), turned(transposed(C), turned(sign, turned(C, there.com)))
        is_alone = words == as_copies == [(index, "com")]
        if is_alone and n_retyped(here.com, back.com, are_angles=False) == 0:
            return back.com, turned(transposed(C), here.com)
    return ()


def _sign_off(written: MassDistribution, meant: MassDistribution) -> Rotation | None:
    """Return what changes the sign of the one component of a CoM that nearly explains a difference.

    If moments have that sign as well, the whole body is meant so.
    """
    axis = max(range(3), key=lambda i: abs(written.com[i] - meant.com[i]))
    changed = seen_by(written, MIRRORS[axis])
    near = _AS_DRAWN * abs(written.com[axis] - meant.com[axis])
    off, off_if_changed = (_apart(each.moments, meant.moments) for each in (written, changed))
    is_near = _apart(changed.com, meant.com) <= near
    is_alike = off <= min(_AS_DRAWN * max(map(abs, meant.moments)), off_if_changed)
    return MIRRORS[axis] if is_near and is_alike else None


def _apart(one: Sequence[float], other: Sequence[float]) -> float:
    return max(abs(x - y) for x, y in zip(one, other, strict=True))


def _odd_mass(
    label: Side, index: int, words: Sequence[str], pairs: _Weighed, way: _Way
) -> LimbVerdict:
    """Return the verdict on numbers of a body, and the first peer's in their place."""
    mine = [pair for pair in pairs if label in pair]
    rows = [pairs[pair].limbs.rows[index][1:][:: 1 if pair[0] == label else -1] for pair in mine]
    (body, peer), C = rows[0], way[mine[0]]
    what = words[0] if len(words) == 1 else "inertia"
    meant = seen_by(pairs[mine[0]].masses[peer.name], C if mine[0][1] == label else transposed(C))
    numbers = {"mass": (meant.mass,), "com": meant.com, "moments": meant.moments}
    place = Suspect(body.name, body.joint, what)
    repair = MeantNumbers(place, (numbers.get(what, meant.numbers),))
    return LimbVerdict((place,), (repair,), tuple(peer.name for _, peer in rows), True)
