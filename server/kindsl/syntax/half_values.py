"""Sections that are still being typed: `CoM`, `CoM = (0.0`, `mass` with nothing behind on the line.

The search for repairs would rather take them for something else that fits, or away.
"""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.syntax.tree import Edit, Problem, Repair, Token
from kindsl.syntax.words import called, shown, supplied

VECTOR = ("(", "FLOAT", ",", "FLOAT", ",", "FLOAT", ")")
_VECTORS = frozenset({"CoM", "translation", "rotation"})
_SCALARS = {"mass": "FLOAT", "MOMENT": "FLOAT", "id": "INT"}
_BEFORE_SECTIONS = frozenset({"{", "}", ")", "FLOAT", "INT"})
_IN_VECTORS = frozenset("*/-,") | {
    "FLOAT",
    "INT",
    "LOWER_PI",
    "MALFORMED_NUMBER",
    "NAME",
    "PI",
    "PI_PREFIXED",
    "SCIENTIFIC",
}
_OPERATORS = frozenset("*/-")


class HalfVector(NamedTuple):
    """A vector without its end.

    Attributes:
        end: The index behind it.
        tokens: It with its end.
        problem: What it lacks first.
    """

    end: int
    tokens: list[Token]
    problem: Problem


def half_vector(text: str, tokens: Sequence[Token], index: int) -> HalfVector | None:
    """Return the vector that opens at a `(` and is not closed; None if something else is wrong."""
    end = index + 1
    while end < len(tokens) and tokens[end].kind in _IN_VECTORS:
        if "\n" in text[tokens[end - 1].end : tokens[end].start]:
            break
        end += 1
    place = _place(tokens[index:end]) if _is_line_end(text, tokens, end) else None
    if place is None:
        return None
    last = tokens[end - 1]
    message = f"expected {called(VECTOR[place])} after '{shown(last.text)}'"
    repair = None
    if place == len(VECTOR) - 1:
        repair = Repair("Insert ')'", (Edit(last.end, last.end, ")"),), False)
    problem = Problem("KD001", message, last.end, last.end, repair)
    lacking = [supplied(kind, last.end) for kind in VECTOR[place:]]
    return HalfVector(end, [*tokens[index:end], *lacking], problem)


def with_whole_sections(text: str, tokens: Sequence[Token], problems: list[Problem]) -> list[Token]:
    """Return tokens with `=` and a value behind keywords that stand alone; tell of each."""
    found: list[Token] = []
    for index, token in enumerate(tokens):
        found.append(token)
        value = VECTOR if token.kind in _VECTORS else _SCALARS.get(token.kind)
        if value is None or not _stands_alone(text, tokens, index):
            continue
        message = f"expected '=' after '{shown(token.text)}'"
        problems.append(Problem("KD001", message, token.end, token.end))
        kinds = ("=", *value) if isinstance(value, tuple) else ("=", value)
        found += [supplied(kind, token.end) for kind in kinds]
    return found


def _is_line_end(text: str, tokens: Sequence[Token], index: int) -> bool:
    """Return whether a line or a block ends before a token; at the text's end nothing is known."""
    if index >= len(tokens):
        return False
    return tokens[index].kind == "}" or "\n" in text[tokens[index - 1].end : tokens[index].start]


def _place(tokens: Sequence[Token]) -> int | None:
    """Return how much of a vector's form stands there; None where it is none, or ends amidst."""
    place = 0
    is_operand_next = True
    for token in tokens[1:]:
        if token.kind == ",":
            if is_operand_next or place == 4:
                return None
            place += 2
            is_operand_next = True
        elif token.kind in _OPERATORS:
            is_operand_next = True
        elif is_operand_next:
            is_operand_next = False
        else:
            return None
    if tokens[-1].kind in _OPERATORS:
        return None
    return place + 1 if is_operand_next else place + 2


def _stands_alone(text: str, tokens: Sequence[Token], index: int) -> bool:
    """Return whether a keyword is first and last on its line, where a section can begin."""
    before, behind = tokens[:index][-1:], tokens[index + 1 :][:1]
    if not before or before[0].kind not in _BEFORE_SECTIONS:
        return False
    if behind and (behind[0].kind in ("=", "{", "via", "FLOATING") or behind[0].text == "via"):
        return False
    is_first = "\n" in text[before[0].end : tokens[index].start]
    return is_first and _is_line_end(text, tokens, index + 1)
