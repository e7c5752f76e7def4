"""Sections and children that are still being typed: `CoM`, `mass`, `upper via`, `CoM = (0.0`.

Nothing stands behind them on their line. The search for repairs would rather take them for
something else that fits, or away, or close the block there, which tells a typist nothing.
"""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.syntax.token_names import called, shown, supplied
from kindsl.syntax.tree import Edit, Problem, Repair, Token

VECTOR = ("(", "FLOAT", ",", "FLOAT", ",", "FLOAT", ")")
_VECTORS = frozenset({"CoM", "translation", "rotation"})
_SCALARS = {"mass": "FLOAT", "MOMENT": "FLOAT", "id": "INT"}
_OWNERS = {"translation": "frame", "rotation": "frame", "id": "link"}
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
    opened: list[str] = []
    for index, token in enumerate(tokens):
        found.append(token)
        if token.kind == "{":
            opened.append(_owner(tokens, index))
        elif token.kind == "}" and opened:
            opened.pop()
        value = VECTOR if token.kind in _VECTORS else _SCALARS.get(token.kind)
        if value is None or opened[-1:] != [_OWNERS.get(token.kind, "inertia")]:
            continue
        if not _stands_alone(text, tokens, index):
            continue
        message = f"expected '=' after '{shown(token.text)}'"
        problems.append(Problem("KD001", message, token.end, token.end))
        kinds = ("=", *value) if isinstance(value, tuple) else ("=", value)
        found += [supplied(kind, token.end) for kind in kinds]
    return found


def _owner(tokens: Sequence[Token], brace: int) -> str:
    """Return the kind of block that a brace opens, as far as sections of values stand in it."""
    before = [token.kind for token in tokens[max(brace - 2, 0) : brace]]
    if before[-1:] == ["INERTIA"]:
        return "inertia"
    if before[:1] in (["link"], ["JOINT_KIND"]):
        return "link"
    return "frame" if before[-1:] in (["ref_frame"], ["NAME"]) else ""


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


_CHILD = ("NAME", "via", "NAME")


def with_whole_children(text: str, tokens: Sequence[Token], problems: list[Problem]) -> list[Token]:
    """Return tokens with what half a child lacks supplied; tell of each."""
    found: list[Token] = []
    place = -1
    for index, token in enumerate(tokens):
        if place > 0 and place < len(_CHILD) and not _goes_on(text, tokens, index, _CHILD[place]):
            before = tokens[index - 1]
            message = f"expected {called(_CHILD[place])} after '{shown(before.text)}'"
            problems.append(Problem("KD001", message, before.end, before.end))
            found += [supplied(kind, before.end) for kind in _CHILD[place:]]
            place = len(_CHILD)
        found.append(token)
        place = _next_place(tokens, index, place)
    return found


def _next_place(tokens: Sequence[Token], index: int, place: int) -> int:
    """Return how many tokens of a child stand up to an index; -1 outside of `children`."""
    token = tokens[index]
    if token.kind == "{" and index and tokens[index - 1].kind == "children":
        return 0
    if place < 0 or token.kind == "}":
        return -1
    place %= len(_CHILD)
    return place + 1 if token.kind == _CHILD[place] else -1


def _goes_on(text: str, tokens: Sequence[Token], index: int, wanted: str) -> bool:
    """Return whether a child goes on at a token, as it should or in a way that others mend."""
    token, before = tokens[index], tokens[index - 1]
    if token.kind == wanted and not (wanted == "NAME" and _is_new_child(text, tokens, index)):
        return True
    is_new_line = "\n" in text[before.end : token.start]
    return token.kind != "}" and not (is_new_line and token.kind == "NAME")


def _is_new_child(text: str, tokens: Sequence[Token], index: int) -> bool:
    """Return whether a name on the next line begins a child of its own."""
    is_new_line = "\n" in text[tokens[index - 1].end : tokens[index].start]
    return is_new_line and index + 1 < len(tokens) and tokens[index + 1].kind == "via"
