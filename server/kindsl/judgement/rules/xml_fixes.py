"""Fixes in XML: whole numbers that stand there, in the author's way of writing them."""

import re
from collections.abc import Container, Iterable, Iterator, Sequence
from typing import NamedTuple

from kindsl.judgement.diagnosis.counterparts import are_near, images, namesakes, unlike_numbers
from kindsl.judgement.rules.base import Fix, Replacement
from kindsl.judgement.rules.limb_places import PARTS, numbers_at
from kindsl.judgement.rules.limb_writing import retyped, rewriting
from kindsl.judgement.rules.number_writing import rescaled
from kindsl.judgement.rules.xml_elements import in_words_of_xml
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.expressions import EXACT_ZERO, Expression, half_unit
from kindsl.language.semantics.model import Model
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.interchange.robot_island import RobotIsland
from kindsl.robots.interchange.xml_reading import DECIMAL
from kindsl.robots.limbs.names import label_of
from kindsl.robots.limbs.weighing import Suspect

_GREATEST_POWER = 9
_POWERS = [10.0**power for n in range(1, _GREATEST_POWER + 1) for power in (-n, n)]
# The parts of ten numbers, and what may be between two units of each.
_PARTS = {"mass": PARTS["mass"], "CoM": PARTS["com"], "moments": PARTS["moments"]}
_FACTORS = {"mass": _POWERS, "CoM": (1e-3, 1e-2, 0.0254), "moments": _POWERS}
# A left and a right part of a CAD program agree as nearly as this.
_NEARLY = 0.01
# A name that is all of an attribute, or of an element, and needs no entity.
_NAME = re.compile(r"[A-Za-z_][\w.:/-]*")
_BEFORE, _BEHIND = "\"'>", "\"'<"


def xml_fix(fix: Fix | None) -> Fix | None:
    """Return a fix as it is made in XML, None where a number is not written there by itself."""
    changes = [_change(each) for each in fix.changes] if fix is not None else []
    whole = tuple(each for each in changes if each is not None)
    if fix is None or not whole or len(whole) < len(changes):
        return None
    told = fix.title.replace(fix.changes[0].text, whole[0].text) if len(whole) == 1 else fix.title
    return Fix(in_words_of_xml(told), whole)


def xml_choices(choices: Sequence[Fix]) -> tuple[Fix, ...]:
    """Return choices as they are made in XML, none where only some of them can be."""
    fixes = (xml_fix(each) for each in choices)
    made = tuple(each for each in fixes if each is not None)
    return made if len(made) == len(choices) else ()


def _change(change: Replacement) -> Replacement | None:
    island, at = change.at.island, change.at
    word = island.text[at.start : at.end]
    if not isinstance(island, RobotIsland):
        return None
    if _NAME.fullmatch(word):
        is_whole = _NAME.fullmatch(change.text) and island.text[at.start - 1] in _BEFORE
        return change if is_whole and island.text[at.end] in _BEHIND else None
    if not DECIMAL.fullmatch(word):
        return None
    text = _with_other_sign(change.text) if at.start in island.negated else change.text
    return Replacement(at, _in_its_way(word, text))


def _in_its_way(word: str, text: str) -> str:
    """Return a new number, whole as the old one, or that in its sign or exponent changed."""
    if text.lstrip("-") == EXACT_ZERO:
        return "0"
    meant = float(text)
    rounding = min(half_unit(text), _NEARLY * abs(meant))
    ways = [_with_other_sign(word)]
    mantissa, e, exponent = word.partition("E" if "E" in word else "e")
    if e:
        powers = range(-_GREATEST_POWER, _GREATEST_POWER + 1)
        ways += (f"{mantissa}{e}{int(exponent) + power:+03d}" for power in powers)
    plain = text.removesuffix(".0") if word.lstrip("+-").isdigit() else text
    return next((way for way in ways if abs(float(way) - meant) <= rounding), plain)


def _with_other_sign(word: str) -> str:
    return word[1:] if word.startswith("-") else f"-{word.removeprefix('+')}"


class CounterpartFix(NamedTuple):
    """What makes an odd part as its counterpart.

    Attributes:
        peer: The counterpart.
    """

    fix: Fix
    peer: Link


def fix_by_counterpart(model: Model, link: Link, odd: Container[Link]) -> CounterpartFix | None:
    """Return the fix of a part that is as a counterpart but for its mass, CoM or moments.

    These are in another unit, or one of them is wrong. None where counterparts want different
    numbers.

    Args:
        link: A part that cannot be as it is.
        odd: All parts that cannot.
    """
    words = label_of(str(link.name)).words
    same = (peer for peer in namesakes(model, link) if label_of(str(peer.name)).words == words)
    return set_as(model, link, [peer for peer in same if peer not in odd])


def set_as(model: Model, link: Link, peers: Sequence[Link]) -> CounterpartFix | None:
    """Return the fix of a part by counterparts, None where they want different numbers."""
    own = _ten(model, link)
    found = [
        CounterpartFix(Fix(f"Set {what} of '{link.name}' as of '{peer.name}'", changes), peer)
        for peer in peers
        for what, changes in _differing(own, _ten(model, peer))
    ]
    agreed = found and all(_agree(found[0].fix, each.fix) for each in found[1:])
    return found[0] if agreed else None


def _agree(one: Fix, other: Fix) -> bool:
    """Return whether two fixes write nearly the same numbers at the same places."""
    ours, theirs = ([(c.at.start, float(c.text)) for c in fix.changes] for fix in (one, other))
    return [at for at, _ in ours] == [at for at, _ in theirs] and are_near(
        [value for _, value in ours], [value for _, value in theirs], _NEARLY
    )


def _ten(model: Model, link: Link) -> Sequence[Expression]:
    numbers = numbers_at(model, Suspect(str(link.name), "", "inertia"))
    return numbers if all(number.literal is not None for number in numbers) else ()


def _differing(
    own: Sequence[Expression], peers: Sequence[Expression]
) -> Iterator[tuple[str, tuple[Replacement, ...]]]:
    """Yield what alone differs from a counterpart, and the changes that set it, if these are plain.

    Numbers in another unit keep their digits. The signs of others are those of the mirror images
    that agree in the rest.
    """
    if not own or not peers:
        return
    here, there = (MassDistribution.of(e.literal or 0.0 for e in ten) for ten in (own, peers))
    unlike = [(tuple(unlike_numbers(here, i, _NEARLY)), i.numbers) for i in images(there)]
    alone = [(odd[0], values[_PARTS[odd[0]]]) for odd, values in unlike if len(odd) == 1]
    parts = {part for part, _ in alone}
    for part in parts if len(parts) == 1 else ():
        numbers, theirs = own[_PARTS[part]], peers[_PARTS[part]]
        size = _NEARLY * max(abs(each.literal or 0.0) for each in theirs)
        every = range(len(theirs))
        apart = [n for n in every if _distance(numbers[n], theirs[n]) > size] or every
        changes = _rescaled(numbers, theirs, [every, apart], _FACTORS[part])
        wanted = {tuple(v[n] if abs(v[n]) > size else 0.0 for n in apart) for _, v in alone}
        if changes is None and len(wanted) == 1:
            mine, its = ([group[n] for n in apart] for group in (numbers, theirs))
            meant = [[alone[0][1][n] for n in apart]]
            texts = retyped(mine, [its], meant, [{}], (slice(10),))
            changes = list(rewriting("", mine, texts).changes) if texts else None
        if changes:
            yield part, tuple(changes)


def _rescaled(
    own: Sequence[Expression],
    peers: Sequence[Expression],
    selections: Iterable[Sequence[int]],
    factors: Sequence[float],
) -> list[Replacement] | None:
    """Return the changes that give numbers, or some of them, the unit of a counterpart's."""
    for selected in selections:
        mine, its = ([numbers[n] for n in selected] for numbers in (own, peers))
        here, there = ([abs(each.literal or 0.0) for each in group] for group in (mine, its))
        for factor in factors:
            if are_near([factor * x for x in here], there, _NEARLY):
                return rescaled(mine, [factor * (each.literal or 0.0) for each in mine])
    return None


def _distance(one: Expression, other: Expression) -> float:
    return abs(abs(one.literal or 0.0) - abs(other.literal or 0.0))
