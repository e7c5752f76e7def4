"""The components of a vector: three, apart by commas."""

from collections.abc import Sequence

from kindsl.syntax.token_names import shown, supplied
from kindsl.syntax.tree import Edit, Problem, Repair, Token
from kindsl.syntax.value_forms import form_kind, kinds_accepted_by

COMPONENTS = 3
QUOTES = ('"', "'")

_OPERANDS = frozenset({"FLOAT", "INT", "SCIENTIFIC", "POWER_FLOAT", "NAME", "PI", "LOWER_PI"})


def from_attribute(tokens: Sequence[Token], problems: list[Problem]) -> list[Token]:
    """Return three numbers as URDF writes them, `"0 0 1.57"`, as a vector; nothing for others."""
    is_quoted = tokens[0].text in QUOTES and tokens[0].text == tokens[-1].text
    numbers = tokens[1:-1] if is_quoted else tokens
    if len(numbers) != COMPONENTS or any(n.kind not in ("INT", "FLOAT") for n in numbers):
        return []
    x, y, z = (n.text if n.kind == "FLOAT" else f"{n.text}.0" for n in numbers)
    start, end = tokens[0].start, tokens[-1].end
    written = shown("".join(f" {n.text}" for n in numbers))
    repair = Repair(f"Write '({x}, {y}, {z})'", (Edit(start, end, f"({x}, {y}, {z})"),), False)
    message = f"expected a vector '(x, y, z)' instead of '{written}'"
    problems.append(Problem("KD001", message, start, end, repair))
    first, second, third = numbers
    return [
        supplied("(", tokens[0].lead),
        first,
        supplied(",", first.end),
        second,
        supplied(",", second.end),
        third,
        supplied(")", end),
    ]


def with_commas(tokens: Sequence[Token], problems: list[Problem]) -> list[Token]:
    """Return the tokens of a vector whose components blanks keep apart, with commas there.

    Of fewer than three components nothing is told: `of_three` counts them.
    """
    gaps = _gaps(tokens) if tokens[0].kind == "(" and tokens[-1].kind == ")" else []
    commas = sum(token.kind == "," for token in tokens)
    parts = _components(_separated(tokens, gaps)[1:-1])
    if not gaps or len(parts) > COMPONENTS or not all(_is_form(part) for part in parts):
        return list(tokens)
    if commas + len(gaps) == COMPONENTS - 1:
        before = [tokens[gap - 1] for gap in gaps]
        edits = tuple(Edit(token.end, token.end, ",") for token in before)
        place, message = before[0].end, f"expected ',' after '{shown(before[0].text)}'"
        repair = Repair("Insert ','", edits, False)
        problems.append(Problem("KD001", message, place, place, repair))
    return _separated(tokens, gaps)


def _gaps(tokens: Sequence[Token]) -> list[int]:
    """Return the index of each token that begins a value right behind another one."""
    return [
        index
        for index in range(2, len(tokens) - 1)
        if tokens[index - 1].kind in _OPERANDS and _begins_value(tokens, index)
    ]


def _begins_value(tokens: Sequence[Token], index: int) -> bool:
    """Return whether a token is an operand, or a sign that stands apart on its left alone."""
    token = tokens[index]
    if token.kind == "-":
        is_apart = tokens[index - 1].end < token.start
        return is_apart and token.end == tokens[index + 1].start
    return token.kind in _OPERANDS


def _separated(tokens: Sequence[Token], gaps: Sequence[int]) -> list[Token]:
    """Return the tokens with a comma before each index."""
    found: list[Token] = []
    for index, token in enumerate(tokens):
        if index in gaps:
            found.append(supplied(",", tokens[index - 1].end))
        found.append(token)
    return found


def of_three(
    tokens: Sequence[Token], problems: list[Problem], skipped: list[Token]
) -> Sequence[Token]:
    """Return a well-formed vector of fewer or more components as one of three."""
    if tokens[0].kind != "(" or tokens[-1].kind != ")":
        return tokens
    parts = _components(tokens[1:-1])
    if len(parts) == COMPONENTS or not all(_is_form(part) for part in parts):
        return tokens
    noun = "component" if len(parts) == 1 else "components"
    start, end = tokens[0].start, tokens[-1].end
    message = f"vector has {len(parts)} {noun} instead of 3"
    if len(parts) > COMPONENTS:
        count = sum(len(part) for part in parts[:COMPONENTS]) + COMPONENTS
        surplus = tokens[count:-1]
        edit = Edit(surplus[0].start, surplus[-1].end, "")
        repair = Repair("Remove the surplus components", (edit,), False)
        problems.append(Problem("KD001", message, start, end, repair))
        skipped.extend(surplus)
        return [*tokens[:count], tokens[-1]]
    problems.append(Problem("KD001", message, start, end))
    return [*tokens[:-1], *_padding(len(parts), tokens[-2].end), tokens[-1]]


def _padding(count: int, position: int) -> list[Token]:
    kinds = ["FLOAT", ",", "FLOAT", ",", "FLOAT"][2 * count - 1 if count else 0 :]
    return [supplied(kind, position) for kind in kinds]


def _components(tokens: Sequence[Token]) -> list[list[Token]]:
    parts: list[list[Token]] = [[]] if tokens else []
    for token in tokens:
        if token.kind == ",":
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def _is_form(tokens: Sequence[Token]) -> bool:
    """Return whether tokens are a value, a whole number for a decimal one included."""
    kinds = tuple("FLOAT" if token.kind == "INT" else form_kind(token) for token in tokens)
    return len(kinds) <= 12 and bool(kinds_accepted_by(kinds))
