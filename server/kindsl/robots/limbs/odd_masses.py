"""Masses, CoMs and moments that one limb only has so, where all joints agree."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from math import dist, inf
from operator import sub

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import IDENTITY, Rotation, Vector3, product, transposed, turned
from kindsl.robots.limbs.limb import Side
from kindsl.robots.limbs.mounts import MIRRORS, REFLECTIONS, SAME_PLACE
from kindsl.robots.limbs.slips import n_retyped
from kindsl.robots.limbs.weighing import (
    LimbVerdict,
    MeantNumbers,
    Suspect,
    WeighedComparison,
    seen_by,
)

# Bodies of a pair of which a number may be typed anew; of fewer it is a sign, an order, a unit.
SMALLEST = {"LR": 3, "HELD": 2}
# How far a left and a right part are apart whose numbers come from drawings of their own, as a
# share of the greatest moment, and of what a sign of the CoM changes. Of 609 published robots none
# has such a sign off but in bodies that were copied.
AS_DRAWN = 0.1
# So many times nearer as mirror images than as copies moments are of bodies that were mirrored,
# not of copies with cables besides.
_NEARER = 5.0
# Bodies that are the same in all ten numbers to the second share, or in some to the first, were
# copied, and one that is not was typed otherwise. Where each has numbers of its own, one that is
# hardly farther away has so too: no difference is told that would be none between a left and a
# right part alone, nor one of so many times what the others are apart. Of 1,647 files of others
# one robot loses a finding so, and its four thighs are equal to five digits.
_EQUAL, _COPIED, _SIGNIFICANT, _FARTHER = 1e-6, 1e-3, 0.05, 5.0
Pair = tuple[Side, Side]
Weighed = Mapping[Pair, WeighedComparison]
_Way = Mapping[Pair, Rotation]


def odd_masses(pairs: Weighed) -> Iterator[LimbVerdict]:
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
                accused = {
                    side: words
                    for side, words in _accused(differing)
                    if _is_far(side, index, words, pairs, way)
                }
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


def _accused(differing: Mapping[Pair, set[str]]) -> Iterator[tuple[Side, list[str]]]:
    """Yield each limb that differs from all others, which agree, and in what."""
    for label in dict.fromkeys(label for pair in differing for label in pair):
        mine = [words for pair, words in differing.items() if label in pair]
        others = [words for pair, words in differing.items() if label not in pair]
        words = set.intersection(*mine).difference(*others)
        if words and len(mine) > 1 and others:
            yield label, sorted(words)


def _is_far(label: Side, index: int, words: Sequence[str], pairs: Weighed, way: _Way) -> bool:
    """Return whether a body is farther from its peers than these are from each other."""
    shares = {pair: _shares(c, index, way[pair]) for pair, c in pairs.items()}
    off = min(max(shares[pair][w] for w in words) for pair in pairs if label in pair)
    others = [shares[pair] for pair in pairs if label not in pair]
    spread = max(max(each.values()) for each in others)
    are_equal = all(each[w] <= _EQUAL for each in others for w in words)
    return are_equal or spread <= _COPIED or off > max(_SIGNIFICANT, _FARTHER * spread)


def _shares(c: WeighedComparison, index: int, C: Rotation) -> dict[str, float]:
    """Return how far mass, CoM and moments are apart, as shares of the greatest number of each."""
    _, one, other = c.limbs.rows[index]
    here, there = seen_by(c.masses[one.name], C), c.masses[other.name]
    both = {
        "mass": ([here.mass], [there.mass]),
        "com": (here.com, there.com),
        "moments": (here.moments, there.moments),
    }
    sizes = {what: max(map(abs, chain(*pair))) for what, pair in both.items()}
    return {what: _apart(*pair) / (sizes[what] or 1.0) for what, pair in both.items()}


def _n_words(differing: Mapping[Pair, set[str]]) -> int:
    return sum(map(len, differing.values()))


def _ways(pairs: Weighed, mirrored: _Way, index: int) -> Iterator[_Way]:
    """Yield how peers may lie: as the limbs do, all alike, or mirrored in one row.

    Hips often are where the rest is copied; what they carry stays where it is.
    """
    yield mirrored
    yield dict.fromkeys(pairs, IDENTITY.rotation)
    for across in _across(pairs):
        rows = {pair: mirrored[pair] for pair in across}
        places = [r.one.translation for p in rows for r in pairs[p].limbs.rows if r.up == index]
        for signs in REFLECTIONS[1:] if rows else ():
            offs = (x for at in places for x in map(sub, turned(signs, at), at))
            if all(abs(off) < SAME_PLACE for off in offs):
                yield {**mirrored, **{pair: product(signs, C) for pair, C in rows.items()}}


def _across(pairs: Weighed) -> Iterator[list[Pair]]:
    """Yield the pairs of limbs of two rows; of numbered ones those on both sides of a plane."""
    yield [pair for pair, c in pairs.items() if c.limbs.how == "ROW"]
    numbered = {pair: c.best[1].mount.map for pair, c in pairs.items() if c.limbs.how == "TURN"}
    for axis in range(3):
        yield [pair for pair, matrix in numbered.items() if matrix[axis][axis] < 0.0]


def _differing(pairs: Weighed, index: int, way: _Way) -> dict[Pair, set[str]]:
    return {p: {what for _, what in c.differing({index: way[p]})} for p, c in pairs.items()}


def _odd_com(
    pairs: Weighed, conventions: Mapping[Pair, Mapping[int, Rotation]]
) -> Iterator[LimbVerdict]:
    """Yield the one CoM that a sign or an order keeps from being that of the other side."""
    ((pair, c),) = pairs.items()
    if len(c.limbs.rows) < SMALLEST.get(c.limbs.how, inf):
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
    if _apart(here.com, there.com) <= AS_DRAWN * max(map(abs, there.com)):
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
    near = AS_DRAWN * abs(written.com[axis] - meant.com[axis])
    off, off_if_changed = (_apart(each.moments, meant.moments) for each in (written, changed))
    is_near = _apart(changed.com, meant.com) <= near
    is_alike = off <= min(AS_DRAWN * max(map(abs, meant.moments)), off_if_changed)
    return MIRRORS[axis] if is_near and is_alike else None


def _apart(one: Sequence[float], other: Sequence[float]) -> float:
    return max(abs(x - y) for x, y in zip(one, other, strict=True))


def _odd_mass(
    label: Side, index: int, words: Sequence[str], pairs: Weighed, way: _Way
) -> LimbVerdict:
    """Return the verdict on numbers of a body, and the first peer's in their place."""
    mine = [pair for pair in pairs if label in pair]
    rows = [pairs[pair].limbs.rows[index][1:][:: 1 if pair[0] == label else -1] for pair in mine]
    (body, peer), C = rows[0], _as_in_another(mine[0], label, index, pairs) or way[mine[0]]
    what = words[0] if len(words) == 1 else "inertia"
    meant = seen_by(pairs[mine[0]].masses[peer.name], C if mine[0][1] == label else transposed(C))
    numbers = {"mass": (meant.mass,), "com": meant.com, "moments": meant.moments}
    place = Suspect(body.name, body.joint, what)
    repair = MeantNumbers(place, (numbers.get(what, meant.numbers),))
    return LimbVerdict((place,), (repair,), tuple(peer.name for _, peer in rows), True)


def _as_in_another(own: Pair, label: Side, index: int, pairs: Weighed) -> Rotation | None:
    """Return how bodies of another pair lie that is like this one; signs of small numbers too."""
    for pair, c in pairs.items():
        here, there = (c.masses.get(body.name) for body in c.limbs.rows[index][1:])
        is_alike = label not in pair and c.limbs.how == pairs[own].limbs.how != "TURN"
        if is_alike and here is not None and there is not None:
            ways = {C: dist(seen_by(here, C).numbers, there.numbers) for C in REFLECTIONS}
            return min(ways, key=lambda C: ways[C])
    return None
