"""Values as other formats and former years write them: bare vectors, decimal commas, `moments`."""

from collections.abc import Iterator, Sequence

from kindsl.language.syntax.habits.engine import Rewrite, Sighting
from kindsl.language.syntax.indentation import indentation
from kindsl.language.syntax.token_names import called, shown, supplied
from kindsl.language.syntax.tree import Edit, Token
from kindsl.language.syntax.typeset import is_grouped
from kindsl.language.syntax.value_forms import form_kind, kinds_accepted_by
from kindsl.language.syntax.vocabulary import MOMENTS, NUMBERS, OPERANDS
from kindsl.language.text.lines import is_first_on_line
from kindsl.language.text.phrases import counted

VECTOR = ("(", "FLOAT", ",", "FLOAT", ",", "FLOAT", ")")

_COMPONENTS = 3
_DECIMAL_COMMAS = (["INT", ",", "INT"], ["INT", ",", "SCIENTIFIC"])
_BEFORE_OPERATORS = OPERANDS | set(")]>")
_SIGNS = frozenset(",([])")


def half_vector(found: Sighting) -> Iterator[Rewrite]:
    """Complete a vector at the end of its line."""
    first, behind = found.span("half")
    letters, last = found.letters("half"), found.tokens[behind - 1]
    place = 2 * letters.count(",") + (1 if letters[-1] in "(," else 2)
    lacking = [supplied(kind, last.end) for kind in VECTOR[place:]]
    edits = (Edit(last.end, last.end, ")"),) if len(lacking) == 1 else ()
    words = (called(VECTOR[place]), shown(last.text))
    new = [*found.of("half"), *lacking]
    yield Rewrite(first, behind, new, (last.end, last.end), words, edits)


def no_vector(found: Sighting) -> Iterator[Rewrite]:
    """Supply a vector after `=` where something else follows."""
    _, behind = found.span()
    end = found.tokens[behind - 1].end
    yield Rewrite(behind, behind, [supplied(kind, end) for kind in VECTOR], (end, end))


def three_numbers(found: Sighting) -> Iterator[Rewrite]:
    """Read three numbers as URDF has them, `"0 0 1.57"`, as a vector."""
    (first, behind), value = found.span("value"), found.of("value")
    numbers = [token for token in value if token.kind in NUMBERS]
    x, y, z = (n.text if n.kind == "FLOAT" else f"{n.text}.0" for n in numbers)
    start, end = value[0].start, value[-1].end
    words = (shown("".join(f" {n.text}" for n in numbers)), f"({x}, {y}, {z})")
    new = [supplied("(", value[0].lead)]
    for number, sign in zip(numbers, (",", ",", ")"), strict=True):
        new += [number, supplied(sign, number.end if sign == "," else end)]
    edits = (Edit(start, end, words[1]),)
    yield Rewrite(first, behind, new, (start, end), words, edits)


def bare_components(found: Sighting) -> Iterator[Rewrite]:
    """Put three numbers with commas into parentheses."""
    (first, behind), value = found.span("value"), found.of("value")
    start, end = value[0].start, value[-1].end
    new = [supplied("(", value[0].lead), *value, supplied(")", end)]
    edits = (Edit(start, start, "("), Edit(end, end, ")"))
    yield Rewrite(first, behind, new, (start, end), (), edits)


def other_brackets(found: Sighting) -> Iterator[Rewrite]:
    """Read a vector in `[]` or `{}` as one in `()`."""
    (first, behind), value = found.span("value"), found.of("value")
    ends = [(value[0], "("), (value[-1], ")")]
    opening, closing = (Token(kind, t.text, t.lead, t.start, t.end) for t, kind in ends)
    edits = tuple(Edit(token.start, token.end, kind) for token, kind in ends)
    words = (value[0].text, value[-1].text)
    new = [opening, *value[1:-1], closing]
    yield Rewrite(first, behind, new, (opening.start, closing.end), words, edits)


def lost_commas(found: Sighting) -> Iterator[Rewrite]:
    """Put commas between components that blanks keep apart; reported where they become three."""
    (first, behind), value = found.span("value"), found.of("value")
    gaps = [
        index
        for index in range(2, len(value) - 1)
        if value[index - 1].kind in OPERANDS and _begins_value(value, index)
    ]
    new = list(value)
    for gap in reversed(gaps):
        new.insert(gap, supplied(",", value[gap - 1].end))
    parts = _components(new)
    if not gaps or len(parts) > _COMPONENTS or not all(map(is_value, parts)):
        return
    before = [value[gap - 1] for gap in gaps]
    place = before[0].end
    edits = tuple(Edit(token.end, token.end, ",") for token in before)
    at = (place, place) if len(parts) == _COMPONENTS else None
    yield Rewrite(first, behind, new, at, (shown(before[0].text),), edits)


def is_value(tokens: Sequence[Token]) -> bool:
    """Return whether tokens are a value, a whole number for a decimal one included."""
    kinds = tuple("FLOAT" if token.kind == "INT" else form_kind(token) for token in tokens)
    return bool(kinds_accepted_by(kinds))


def _begins_value(tokens: Sequence[Token], index: int) -> bool:
    """Return whether a token is an operand, or a sign with a blank only before it."""
    token = tokens[index]
    if token.kind == "-":
        is_apart = tokens[index - 1].end < token.start
        return is_apart and token.end == tokens[index + 1].start
    return token.kind in OPERANDS


def other_numbers(found: Sighting) -> Iterator[Rewrite]:
    """Read `0,5` and `1 234.5` as one malformed number, `x-1.0` as an operation."""
    (first, behind), value = found.span("value"), found.of("value")
    is_scalar, is_vector = found.match["scalar"] is not None, value[0].kind == "("
    new = _with_points(found.text, value)
    expected = {_COMPONENTS - 1} if is_vector else set()
    expected |= {0} if is_scalar else set()
    if sum(token.kind == "," for token in new) not in expected:
        new = list(value)
    is_whole = is_scalar or sum(token.kind == "," for token in new) == _COMPONENTS - 1
    new = [part for i in range(len(new)) for part in _unsigned(found.text, new, i, is_whole)]
    if new != list(value):
        yield Rewrite(first, behind, new)


def _with_points(text: str, tokens: Sequence[Token]) -> list[Token]:
    """Return the tokens with `0,5`, `1 234.5` and the like as one malformed number."""
    merged: list[Token] = []
    index = 0
    while index < len(tokens):
        first, end = tokens[index], _number_end(text, tokens, index)
        last = tokens[end - 1]
        if last is not first:
            written = text[first.start : last.end]
            first = Token("MALFORMED_NUMBER", written, first.lead, first.start, last.end)
        merged.append(first)
        index = end
    return merged


def _number_end(text: str, tokens: Sequence[Token], index: int) -> int:
    """Return the index behind a number in groups of three digits, with a comma, or any token."""
    end = index + 1
    while end < len(tokens) and _may_go_on(text, tokens, end):
        end += 1
    for behind in range(end, index + 1, -1):
        if is_grouped(text[tokens[index].start : tokens[behind - 1].end]):
            return behind
    three = tokens[index : index + 3]
    kinds = [token.kind for token in three]
    is_decimal = kinds in _DECIMAL_COMMAS and three[2].text[0].isdigit()
    return index + 3 if is_decimal and three[0].end + 1 == three[2].start else index + 1


def _may_go_on(text: str, tokens: Sequence[Token], index: int) -> bool:
    """Return whether a number may go on at a token: digits or a comma, a blank between at most."""
    token = tokens[index]
    if token.is_missing or text[tokens[index - 1].end : token.start] not in ("", " "):
        return False
    is_number = token.kind in ("INT", "FLOAT") and token.text[0] not in "+-"
    return token.kind == "," or is_number


def _unsigned(text: str, tokens: Sequence[Token], index: int, is_whole: bool) -> tuple[Token, ...]:
    """Return a signed number behind an operand as an operator and a number: `x-1.0`."""
    token = tokens[index]
    if token.kind not in NUMBERS or token.text[:1] not in ("+", "-") or index == 0:
        return (token,)
    before = tokens[index - 1]
    between = text[before.end : token.start]
    if before.kind not in _BEFORE_OPERATORS or "\n" in between or (between and not is_whole):
        return (token,)
    middle = token.start + 1
    sign = Token(token.text[0], token.text[0], token.lead, token.start, middle)
    return sign, Token(token.kind, token.text[1:], middle, middle, token.end)


def surplus_components(found: Sighting) -> Iterator[Rewrite]:
    """Leave out the components after the third of a vector."""
    (first, behind), value = found.span("value"), found.of("value")
    parts = _components(value)
    if len(parts) > _COMPONENTS and all(map(is_value, parts)):
        count = sum(len(part) for part in parts[:_COMPONENTS]) + _COMPONENTS
        surplus = value[count:-1]
        edits = (Edit(surplus[0].start, surplus[-1].end, ""),)
        at = (value[0].start, value[-1].end)
        yield Rewrite(first, behind, [*value[:count], value[-1]], at, (len(parts),), edits)


def lacking_components(found: Sighting) -> Iterator[Rewrite]:
    """Supply the missing components of a vector."""
    (first, behind), value = found.span("value"), found.of("value")
    parts = _components(value)
    if len(parts) < _COMPONENTS and all(map(is_value, parts)):
        lacking = VECTOR[2 * len(parts) if parts else 1 : -1]
        padding = [supplied(kind, value[-2].end) for kind in lacking]
        at = (value[0].start, value[-1].end)
        words = (counted(len(parts), "component"),)
        yield Rewrite(first, behind, [*value[:-1], *padding, value[-1]], at, words)


def _components(vector: Sequence[Token]) -> list[list[Token]]:
    parts: list[list[Token]] = [[]] if len(vector) > 2 else []
    for token in vector[1:-1]:
        if token.kind == ",":
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def obsolete_moments(found: Sighting) -> Iterator[Rewrite]:
    """Read `moments = a, b, ...` as `Ix = a Iy = b ...`, as many as there are moments."""
    (first, behind), tokens = found.span(), found.of()
    values = _values(found.of("list")) if tokens[0].text.casefold() == "moments" else []
    if not values:
        return
    word = tokens[0]
    new = [Token("MOMENT", MOMENTS[0], word.lead, word.start, word.end), tokens[1], *values[0]]
    for index, name in enumerate(MOMENTS[1:], 1):
        end = new[-1].end
        value = values[index] if index < len(values) else [supplied("FLOAT", end)]
        new += [supplied("MOMENT", end, name), supplied("=", end), *value]
    at = (word.start, tokens[-1].end)
    if len(values) == len(MOMENTS):
        yield Rewrite(first, behind, new, at, (), _edits(found.text, tokens, values))
    else:
        message = f"obsolete 'moments' has {counted(len(values), 'value')} instead of 6"
        yield Rewrite(first, behind, new, at, message=message)


def _values(tokens: Sequence[Token]) -> list[list[Token]]:
    values: list[list[Token]] = []
    before = ","
    for token in tokens:
        if token.kind not in _SIGNS:
            if before in _SIGNS or {token.kind, before} <= NUMBERS:
                values.append([])
            values[-1].append(token)
        before = token.kind
    is_list = all((len(v) == 1 and v[0].kind in NUMBERS) or is_value(v) for v in values)
    return values if is_list else []


def _edits(
    text: str, tokens: Sequence[Token], values: Sequence[Sequence[Token]]
) -> tuple[Edit, ...]:
    """Return the edits that write a name before each value, and keep comments between them."""
    start = tokens[0].start
    gap = "\n" + indentation(text, start) if is_first_on_line(text, start) else " "
    ends = [value[-1].end for value in values]
    edits = [Edit(start, tokens[0].end, MOMENTS[0])]
    for token in tokens[2:]:
        if token.kind in _SIGNS and not ends[0] <= token.start < values[-1][0].start:
            edits.append(Edit(token.start, token.end, ""))
    for name, end, value in zip(MOMENTS[1:], ends, values[1:], strict=False):
        place = value[0].start
        if not text[end:place].strip(" \t\r\n,"):
            edits.append(Edit(end, place, f"{gap}{name} = "))
            continue
        commas = [token for token in tokens if end <= token.start < place]
        edits += [Edit(token.start, token.end, "") for token in commas]
        edits.append(Edit(place, place, f"{name} = "))
    return tuple(edits)
