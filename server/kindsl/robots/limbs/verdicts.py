"""Numbers of a robot's limbs that do not fit their peers, and the numbers that were meant.

Limbs of a group are read in pairs. Where three are alike but for one, and one place of it would
make it alike, its peers convict that place; of two limbs either may be wrong. Where all joints
agree, each mass, CoM and moments that one limb only has so is convicted.
"""

from collections.abc import Iterator, Sequence
from itertools import chain, combinations
from math import dist, inf

from kindsl.mechanics.rigid.pose import IDENTITY, Rotation, pose_from, product, transposed, turned
from kindsl.robots.limbs.comparison import LimbComparison, Reading
from kindsl.robots.limbs.limb import Body, Limbs, Match, Side, held_by, matched
from kindsl.robots.limbs.mounts import ALONG, MIRRORS, SAME_PLACE
from kindsl.robots.limbs.names import is_held
from kindsl.robots.limbs.odd_masses import SMALLEST, Pair, Weighed, odd_masses
from kindsl.robots.limbs.weighing import (
    Accusation,
    LimbVerdict,
    Masses,
    MeantNumbers,
    Suspect,
    WeighedComparison,
)

# Of the numbers of a turn that two limbs let expect.
_SAME_TURN = 0.02
_PLACE_OF_HEAD = 0, "translation"
# A limb in another is its copy, or mirrored in the plane across its axis.
_SIDES = (IDENTITY.rotation, MIRRORS[2])
_HALF_A_TURN = ((-1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0))
_ByPeer = Sequence[Sequence[Accusation]]


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
        self.pairs: dict[Pair, LimbComparison] = {}
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


def _of_group(weighed: Weighed) -> list[LimbVerdict]:
    if all(c.n_slips == 0 for c in weighed.values()):
        within = [verdict for c in weighed.values() for verdict in _within_each_other(c)]
        return within or [verdict for alike in _connected(weighed) for verdict in odd_masses(alike)]
    return _convicted(weighed) or _of_pairs(list(weighed.values()))


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


def _in_one_way(pairs: Weighed, groups: Sequence[Weighed]) -> Weighed:
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


def _without_strangers(pairs: Weighed) -> Weighed:
    """Return the pairs without limbs that differ from every other by more than a slip: a thumb."""
    kin = {label for pair, c in pairs.items() if c.n_slips <= 1 for label in pair}
    return {pair: c for pair, c in pairs.items() if kin.issuperset(pair)}


def _connected(pairs: Weighed) -> Iterator[Weighed]:
    """Yield the pairs of limbs that match each other: front and rear ones may have other links."""
    rest = dict(pairs)
    while rest:
        sides, together = set(next(iter(rest))), dict[Pair, WeighedComparison]()
        while found := [pair for pair in rest if not sides.isdisjoint(pair)]:
            together |= {pair: rest.pop(pair) for pair in found}
            sides.update(chain.from_iterable(found))
        yield together


def _convicted(pairs: Weighed) -> list[LimbVerdict]:
    """Return the verdict of two peers or more, which agree themselves, on the limb they accuse.

    It names one place where that is the cheapest alone.
    """
    cases: dict[tuple[Side, Suspect], dict[Pair, list[Accusation]]] = {}
    usual = {c.limbs.how: c.best[0] for c in pairs.values() if c.n_slips == 0}
    for pair, c in pairs.items():
        is_told = len(c.limbs.rows) > 1 or c.limbs.other_kinds
        for both in c.accusations(usual.get(c.limbs.how, 0.0)) if is_told else ():
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
            likelihood = -len(by_peer), is_there, round(cost, 2), meant.n_slips, meant.n_unlike > 0
            ranked.append((likelihood, meant, by_peer))
    ranked.sort(key=lambda each: each[0])
    likeliest = [each for each in ranked if each[0] == ranked[0][0]]
    if not likeliest:
        return []
    _, meant, by_peer = likeliest[0]
    places = tuple(said.place for _, said, _ in likeliest)
    repairs = (MeantNumbers(meant.place, (meant.meant,)),) if len(likeliest) == 1 else ()
    return [LimbVerdict(places, repairs, tuple(each[0].peer for each in by_peer), True)]


def _is_at_another(pairs: Weighed, label: Side, said: Accusation) -> bool:
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
    """Return that on which the most peers agree, two at least; None where they do not.

    They must agree at the least cost; what else they agree on is meant if it takes fewer slips.
    """
    least = [min(said.cost for said in each) for each in by_peer]
    both = zip(by_peer, least, strict=True)
    cheapest = [[said for said in each if said.cost == cost] for each, cost in both]
    return _likeliest(by_peer) if _likeliest(cheapest) is not None else None


def _likeliest(by_peer: _ByPeer) -> Accusation | None:
    ranked = []
    for order, each in enumerate(said for options in by_peer for said in options):
        n_agreeing = sum(any(_agree(each, other) for other in options) for options in by_peer)
        likelihood = each.free_axis is not None, each.n_slips, round(each.cost, 3), each.n_unlike
        ranked.append(((-n_agreeing, *likelihood, each.change, order), each))
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


def _of_pairs(pairs: Sequence[WeighedComparison]) -> list[LimbVerdict]:
    """Return what differs between left and right limbs; not where all are copies of one another.

    What carries them may be mirrored then.
    """
    odd = [(c, found) for c in pairs if (found := list(_of_pair(c)))]
    are_copies = all(_is_copied(c, each.places) for c, found in odd for each in found)
    return [] if are_copies and len(odd) > 1 else [each for _, found in odd for each in found]


def _is_copied(c: WeighedComparison, places: Sequence[Suspect]) -> bool:
    """Return whether two joints have the same translation in the text, and that is told."""
    at = {body.joint: body for _, *both in c.limbs.rows for body in both}
    written = {at[place.joint].as_written("translation") for place in places}
    return len(written) == 1 and all(place.what == "translation" for place in places)


def _of_pair(c: WeighedComparison) -> Iterator[LimbVerdict]:
    """Yield what differs between a left and a right limb by one slip; either may be wrong."""
    limbs = c.limbs
    if limbs.how not in SMALLEST:
        return
    most = 1 if len(limbs.rows) >= SMALLEST[limbs.how] else 0
    accusations = c.accusations()
    ranked = [
        ((round(one.cost, 2), min(one.n_retyped, other.n_retyped)), (one, other))
        for one, other in accusations
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
        # Each as the reading has it in which it has the fewest slips, turned as its peer is, and
        # mirrored rather than where its peer is.
        at = {body.name: body.translation for _, *both in limbs.rows for body in both}

        def likelihood_of(said: Accusation) -> tuple[float, ...]:
            return said.n_slips, said.cost, said.n_unlike, said.meant == at[said.peer]

        repairs = []
        for i, first in enumerate(tied[0]):
            own = (both[i] for both in accusations if both[i].place == first.place)
            meant = min(own, key=likelihood_of)
            repairs.append(MeantNumbers(meant.place, (meant.meant,)))
        is_zero = any(_is_of_other_zero(limbs, said) for both in tied for said in both)
        yield LimbVerdict(tuple(places), tuple(repairs[::-1]), (), False, is_zero)


def _within_each_other(c: WeighedComparison) -> Iterator[LimbVerdict]:
    """Yield a left and a right limb that are at one place, off the plane in which they turn.

    So are those of which more bodies would be alike on both sides of a plane. What slides begins
    where its peer does, and so may what is held. In a robot that moves in a plane one leg lies in
    the other, and the axes of their joints are across it.
    """
    rows, heads = c.limbs.rows, c.limbs.rows[0][1:]
    is_moved = any(head.kind == "prismatic" or is_held(head.name) for head in heads)
    place = heads[0].translation
    if c.limbs.how != "LR" or is_moved or dist(place, heads[1].translation) >= SAME_PLACE:
        return
    ways = [dict.fromkeys(range(len(rows)), C) for C in _SIDES]
    is_copy = c.is_of_one_place and any(not c.differing(way) for way in ways)
    apart = [axis for axis in range(3) if abs(place[axis]) > SAME_PLACE]
    found = [axis for axis in apart if is_copy and abs(heads[0].rotation[axis][2]) > ALONG]
    if not found:
        differing = {axis: _n_differing(c, axis) for axis in apart}
        fewest = min(differing.values(), default=inf)
        is_better = fewest < len(c.differing(c.best[1].conventions))
        found = [axis for axis, n in differing.items() if is_better and n == fewest]
    places = tuple(Suspect(head.name, head.joint, "translation") for head in heads[::-1])
    for axis in found:
        meant = (turned(MIRRORS[axis], place),)
        yield LimbVerdict(places, tuple(MeantNumbers(p, meant) for p in places), (), False)


def _n_differing(c: WeighedComparison, axis: int) -> float:
    """Return how many numbers of bodies would differ if limbs were on both sides of a plane."""
    up, one, other = c.limbs.rows[0]
    moved = other._replace(translation=turned(MIRRORS[axis], one.translation))
    limbs = LimbComparison([Match(up, one, moved), *c.limbs.rows[1:]], "LR")
    apart = WeighedComparison(limbs, c.masses, (MIRRORS[axis], False))
    is_whole = apart.n_slips == 0 and apart.best[1].mount.map == MIRRORS[axis]
    return len(apart.differing(apart.best[1].conventions)) if is_whole else inf


def _turns_axis(limbs: LimbComparison, said: Accusation) -> bool:
    """Return whether a joint would turn about another axis."""
    own = _accused_body(limbs, said)
    return own is not None and abs(_turn_meant(own, said)[2][2]) < ALONG


def _is_of_other_zero(limbs: LimbComparison, said: Accusation) -> bool:
    """Return whether a joint's zero would only be half a turn away: the wrists of Atlas are so."""
    own = _accused_body(limbs, said)
    if said.place.what != "angles" or own is None or own.kind != "revolute":
        return False
    turn = _turn_meant(own, said)
    return all(dist(a, b) < _SAME_TURN for a, b in zip(turn, _HALF_A_TURN, strict=True))


def _accused_body(limbs: LimbComparison, said: Accusation) -> Body | None:
    bodies = (body for _, *both in limbs.rows for body in both)
    return next((body for body in bodies if body.joint == said.place.joint), None)


def _turn_meant(own: Body, said: Accusation) -> Rotation:
    """Return the turn that takes a joint frame as it is to that which its peers have."""
    x, y, z = said.meant
    return product(transposed(own.rotation), pose_from((0.0, 0.0, 0.0), (x, y, z)).rotation)


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
