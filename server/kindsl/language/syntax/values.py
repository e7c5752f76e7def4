"""Problems in blocks that have the shape of the grammar: sections, numbers and expressions."""

import math
from collections.abc import Iterator, Sequence

from kindsl.language.syntax.arithmetic import FLOATS, evaluate
from kindsl.language.syntax.comment_problems import UNDECODABLE
from kindsl.language.syntax.sections import section_problems
from kindsl.language.syntax.tables import NEITHER
from kindsl.language.syntax.token_names import shown
from kindsl.language.syntax.tree import Edit, Node, Problem, Repair, Token
from kindsl.language.syntax.value_forms import accepted_by, form_kind, is_decimal, kinds_accepted_by
from kindsl.language.syntax.vocabulary import BLOCKS, VALUE_HOLDERS, of_kind
from kindsl.language.text.decimals import exact_decimal, significant_decimal

DEEPEST = 60
LARGEST_ID = 2**31 - 1
_HOLDERS = VALUE_HOLDERS | of_kind("whole")
_MOST_PARTS = 1000.0
_SUMS = frozenset({"add", "subtract"})


def value_problems(text: str, block: Node, touched: frozenset[int]) -> Iterator[Problem]:
    """Yield the problems of the numbers, expressions and vectors of a block.

    An expression of more tokens than any generator takes by far is made a flat node `unsupported`.
    """
    pending: list[Node] = [block]
    while pending:
        node = pending.pop()
        if id(node) in touched and node.kind in _HOLDERS:
            _flatten_long_expressions(node)
            continue
        if node.kind in VALUE_HOLDERS:
            for child in node.children:
                if isinstance(child, Node) and not is_decimal(child):
                    yield from _expression_problems(text, node, child)
        elif node.kind == "id":
            yield from _id_problems(node, block.kind)
        else:
            pending += node.parts


def _expression_problems(text: str, parent: Node, node: Node) -> Iterator[Problem]:
    tokens = list(node.tokens())
    if len(tokens) > DEEPEST:
        _flatten_long_expressions(parent)
    if any(token.is_missing or UNDECODABLE.search(token.text) for token in tokens):
        return  # reported already
    if accepted_by(tokens):
        return
    yield (_malformed(tokens) or _integer(tokens) or _unsupported(text, node, tokens))


def _flatten_long_expressions(parent: Node) -> None:
    """Flatten expressions that are too long, so that walking them does not exhaust the stack."""
    for place, child in enumerate(parent.children):
        if isinstance(child, Node) and child.kind != "number":
            tokens = list(child.tokens())
            if len(tokens) > DEEPEST:
                parent.children[place] = Node("unsupported", [*tokens])


def _malformed(tokens: Sequence[Token]) -> Problem | None:
    token = next((t for t in tokens if form_kind(t) in NEITHER), None)
    if token is None:
        return None
    from kindsl.language.syntax.typeset import meant_numbers

    repairs = tuple(
        Repair(f"Write {meant}", (Edit(token.start, token.end, meant),), False)
        for meant in meant_numbers(token.text)
    )
    message = f"'{shown(token.text)}' is not a number"
    code = NEITHER[form_kind(token)]
    return Problem(code, message, token.start, token.end).repaired_by(repairs)


def _integer(tokens: Sequence[Token]) -> Problem | None:
    """Return the problem of a whole number where both targets need a decimal point."""
    kinds = [form_kind(token) for token in tokens]
    whole = [index for index, kind in enumerate(kinds) if kind == "INT"]
    for chosen in (*([index] for index in whole), whole):
        trial = tuple("FLOAT" if i in chosen else kind for i, kind in enumerate(kinds))
        if chosen and kinds_accepted_by(trial):
            token = tokens[chosen[0]]
            glued = next((t for t in tokens if t.start == token.end and t.kind == "NAME"), None)
            if glued is not None:
                return with_unit(token.text + glued.text, token, glued)
            edits = tuple(Edit(tokens[i].end, tokens[i].end, ".0") for i in chosen)
            message = f"number '{shown(token.text)}' has no decimal point"
            repair = Repair(f"Write {shown(token.text)}.0", edits, True)
            return Problem("KD005", message, token.start, token.end, repair)
    return None


def with_unit(written: str, number: Token, unit: Token) -> Problem:
    """Return the problem of a number with a unit; its repair if that is degrees."""
    repair = None
    if unit.text in ("deg", "degrees", "°") and float(number.text):
        meant = in_radians(number.text)
        repair = Repair(f"Write {meant}", (Edit(number.start, unit.end, meant),), False)
    message = f"'{shown(written)}' is not a number"
    return Problem("KD005", message, number.start, unit.end, repair)


def in_radians(degrees: str) -> str:
    """Return an angle other than zero as both generators read it."""
    angle = math.radians(float(degrees))
    return _part_of_pi(angle) or exact_decimal(angle)


def _unsupported(text: str, node: Node, tokens: Sequence[Token]) -> Problem:
    written = shown(text[tokens[0].start : tokens[-1].end])
    if node.kind in _SUMS:
        message = f"sum '{written}' where the language has no sums"
    elif node.kind == "group":
        message = f"parentheses in '{written}' where the language has none"
    else:
        message = f"expression '{written}' is of a form that no generator takes"
    start, end = tokens[0].start, tokens[-1].end
    return Problem("KD006", message, start, end, _evaluated(node, tokens, start, end))


def _evaluated(node: Node, tokens: Sequence[Token], start: int, end: int) -> Repair | None:
    if node.kind == "group" and accepted_by(tokens[1:-1]):
        edits = (Edit(start, tokens[0].end, ""), Edit(tokens[-1].start, end, ""))
        return Repair("Remove the parentheses", edits, True)
    has_names = any(token.kind == "NAME" for token in tokens)
    value = evaluate(node, {}, FLOATS) if not has_names and len(tokens) <= DEEPEST else None
    if value is None or not math.isfinite(value):
        return None
    number = significant_decimal(value, 15)
    if any(token.kind == "PI" for token in tokens):
        number = _part_of_pi(value) or exact_decimal(value)
    return Repair(f"Write {number}", (Edit(start, end, number),), False)


def _part_of_pi(value: float) -> str | None:
    """Return a multiple of pi as both generators read it: `-PI`, `PI/0.5`; None without such."""
    divisor = math.pi / abs(value) if value else math.inf
    text = f"{divisor:.6f}".rstrip("0")
    text += "0" if text.endswith(".") else ""
    if divisor > _MOST_PARTS or not float(text) or math.pi / float(text) != abs(value):
        return None
    return f"{'-' if value < 0 else ''}PI" + ("" if divisor == 1 else f"/{text}")


def _id_problems(node: Node, block: str) -> Iterator[Problem]:
    token = node.children[-1]
    if not isinstance(token, Token) or token.is_missing or block != "link":
        return
    digits = token.text.lstrip("+")
    if token.kind == "INT" and not digits.startswith("-") and 0 < size_of(digits) <= LARGEST_ID:
        return
    message = f"id '{shown(token.text)}' is not a natural number"
    if token.kind == "INT" and size_of(digits) > LARGEST_ID:
        message = f"id '{shown(token.text)}' is larger than {LARGEST_ID}"
    yield Problem("KD005", message, token.start, token.end)


def size_of(digits: str) -> int:
    """Return the number, or one too large where it has more digits than are worth reading."""
    return int(digits) if len(digits) < 20 else LARGEST_ID + 1


def meaning_problems(text: str, nodes: Sequence[Node], touched: frozenset[int]) -> list[Problem]:
    """Return the problems of sections and values.

    Args:
        touched: Ids of the nodes that were repaired, about which less is known.
    """
    problems: list[Problem] = []
    for node in nodes:
        if node.kind in BLOCKS:
            problems += section_problems(text, node, touched)
            problems += value_problems(text, node, touched)
    return problems
