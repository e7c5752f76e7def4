"""Fixes in XML: whole numbers that stand there, in the author's way of writing them."""

import re
from collections.abc import Sequence

from kindsl.judgement.rules.base import Fix, Replacement
from kindsl.judgement.rules.xml_shapes import in_words_of_xml
from kindsl.language.semantics.expressions import EXACT_ZERO, half_unit
from kindsl.robots.interchange.robot_island import RobotIsland
from kindsl.robots.interchange.xml_reading import DECIMAL

_GREATEST_POWER = 9
# A name that is all of an attribute, or of an element, and needs no entity.
_NAME = re.compile(r"[A-Za-z_][\w.:/-]*")
_BEFORE, _BEHIND = "\"'>", "\"'<"


def xml_fix(fix: Fix | None) -> Fix | None:
    """Return a fix as it is made in XML, None where a number is not written there by itself."""
    changes = [_change(each) for each in fix.changes] if fix is not None else []
    whole = tuple(each for each in changes if each is not None)
    if fix is None or not whole or len(whole) < len(changes):
        return None
    return Fix(in_words_of_xml(fix.title), whole)


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
    """Return a new number, as the old one where it differs in its sign or exponent alone."""
    if text.lstrip("-") == EXACT_ZERO:
        return "0"
    meant, rounding = float(text), half_unit(text)
    ways = [_with_other_sign(word)]
    mantissa, e, exponent = word.partition("E" if "E" in word else "e")
    if e:
        powers = range(-_GREATEST_POWER, _GREATEST_POWER + 1)
        ways += (f"{mantissa}{e}{int(exponent) + power:+03d}" for power in powers)
    return next((way for way in ways if abs(float(way) - meant) <= rounding), text)


def _with_other_sign(word: str) -> str:
    return word[1:] if word.startswith("-") else f"-{word.removeprefix('+')}"
