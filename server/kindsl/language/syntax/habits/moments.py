"""`moments = a, b, c, d, e, f`, which models of the language's first years have in every link."""

from collections.abc import Iterator, Sequence

from kindsl.language.syntax.habits.engine import Rewrite, Sighting
from kindsl.language.syntax.habits.vectors import is_value
from kindsl.language.syntax.indentation import indentation
from kindsl.language.syntax.token_names import supplied
from kindsl.language.syntax.tree import Edit, Token
from kindsl.language.syntax.vocabulary import MOMENTS, NUMBERS
from kindsl.language.text.lines import is_first_on_line
from kindsl.language.text.phrases import counted

_SIGNS = frozenset(",([])")


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
    """Return the tokens of each value of a list; none where one is no value."""
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
