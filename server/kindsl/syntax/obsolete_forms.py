"""Forms of the language's first years: `moments = a,b,c,d,e,f`, and a `ref_frame` in a link.

Models that are still published have them in every link. Each is one mistake, told and put right
before the search for repairs, which would see several.
"""

from collections.abc import Sequence

from kindsl.syntax.indentation import indentation
from kindsl.syntax.moving import removed
from kindsl.syntax.tables import KEYWORDS
from kindsl.syntax.token_names import shown, supplied
from kindsl.syntax.tree import Edit, Problem, Repair, Token
from kindsl.syntax.value_forms import form_kind, kinds_accepted_by
from kindsl.text.lines import is_first_on_line
from kindsl.text.phrases import counted

_MOMENTS = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")
_MOST_TOKENS = 60
_LONGEST_FORM = 12
_SIGNS = frozenset(",([])")
_NUMBERS = frozenset({"FLOAT", "INT", "SCIENTIFIC", "POWER_FLOAT", "MALFORMED_NUMBER"})
_OWNERS = {"link": "link", "RobotBase": "base"}
_SECTIONS = frozenset({"INERTIA", "children"})
_POSE = frozenset({"translation", "rotation"})


def in_todays_forms(
    text: str, tokens: Sequence[Token], problems: list[Problem]
) -> tuple[list[Token], list[Token]]:
    """Return what to read in place of an island's tokens, and what to leave out; tell of each."""
    read: list[Token] = []
    left_out: list[Token] = []
    index = 0
    while index < len(tokens):
        end = _list_end(tokens, index)
        values = _values(tokens[index + 2 : end])
        if not values:
            read.append(tokens[index])
            index += 1
            continue
        problems.append(_about_moments(text, tokens[index:end], values))
        assignments = _assignments(tokens[index], tokens[index + 1], values)
        read += assignments
        used = {id(token) for token in (tokens[index], *assignments)}
        left_out += [token for token in tokens[index:end] if id(token) not in used]
        index = end
    return _without_own_frame(text, read, left_out, problems), left_out


def _list_end(tokens: Sequence[Token], index: int) -> int:
    """Return the index behind `moments = a, b, ...`; `index` itself where none begins."""
    behind = [token.kind for token in tokens[index + 1 : index + 2]]
    if tokens[index].text.casefold() != "moments" or behind != ["="]:
        return index
    end = index + 2
    while end < min(index + _MOST_TOKENS, len(tokens)) and not _is_behind(tokens, end):
        end += 1
    return end


def _is_behind(tokens: Sequence[Token], index: int) -> bool:
    """Return whether a token is no part of a list of values: a brace or what begins a section."""
    token = tokens[index]
    following = tokens[index + 1].kind if index + 1 < len(tokens) else ""
    return token.kind in ("{", "}") or token.text in KEYWORDS or following == "="


def _values(tokens: Sequence[Token]) -> list[list[Token]]:
    """Return the tokens of each value of a list; none where one is no value."""
    values: list[list[Token]] = []
    before = ","
    for token in tokens:
        if token.kind not in _SIGNS:
            if before in _SIGNS or {token.kind, before} <= _NUMBERS:
                values.append([])
            values[-1].append(token)
        before = token.kind
    return values if all(_is_value(value) for value in values) else []


def _is_value(tokens: Sequence[Token]) -> bool:
    if len(tokens) == 1 and tokens[0].kind == "MALFORMED_NUMBER":
        return True
    kinds = tuple("FLOAT" if token.kind == "INT" else form_kind(token) for token in tokens)
    return len(kinds) <= _LONGEST_FORM and bool(kinds_accepted_by(kinds))


def _assignments(word: Token, equals: Token, values: Sequence[Sequence[Token]]) -> list[Token]:
    """Return the tokens of `Ix = a Iy = b ...`, as many as there are moments."""
    first = Token("MOMENT", _MOMENTS[0], word.lead, word.start, word.end)
    read = [first, equals, *values[0]]
    for index, name in enumerate(_MOMENTS[1:], 1):
        end = read[-1].end
        value = values[index] if index < len(values) else [supplied("FLOAT", end)]
        read += [supplied("MOMENT", end, name), supplied("=", end), *value]
    return read


def _about_moments(
    text: str, tokens: Sequence[Token], values: Sequence[Sequence[Token]]
) -> Problem:
    start, end = tokens[0].start, tokens[-1].end
    if len(values) != len(_MOMENTS):
        message = f"obsolete 'moments' has {counted(len(values), 'value')} instead of 6"
        return Problem("KD010", message, start, end)
    message = "obsolete 'moments': write 'Ix', 'Iy', 'Iz', 'Ixy', 'Ixz', 'Iyz'"
    repair = Repair("Replace 'moments' by six assignments", _edits(text, tokens, values), True)
    return Problem("KD010", message, start, end, repair)


def _edits(
    text: str, tokens: Sequence[Token], values: Sequence[Sequence[Token]]
) -> tuple[Edit, ...]:
    """Return the edits that write a name before each value, and keep comments between them."""
    start = tokens[0].start
    gap = "\n" + indentation(text, start) if is_first_on_line(text, start) else " "
    ends = [value[-1].end for value in values]
    edits = [Edit(start, tokens[0].end, _MOMENTS[0])]
    for token in tokens[2:]:
        if token.kind in _SIGNS and not ends[0] <= token.start < values[-1][0].start:
            edits.append(Edit(token.start, token.end, ""))
    for name, end, value in zip(_MOMENTS[1:], ends, values[1:], strict=False):
        place = value[0].start
        if not text[end:place].strip(" \t\r\n,"):
            edits.append(Edit(end, place, f"{gap}{name} = "))
            continue
        commas = [token for token in tokens if end <= token.start < place]
        edits += [Edit(token.start, token.end, "") for token in commas]
        edits.append(Edit(place, place, f"{name} = "))
    return tuple(edits)


def _without_own_frame(
    text: str, tokens: list[Token], left_out: list[Token], problems: list[Problem]
) -> list[Token]:
    """Return the tokens of a link or base without the pose of its own frame that it once had."""
    owner = _OWNERS.get(tokens[0].kind) if tokens else None
    start = _own_frame(tokens) if owner else None
    if start is None:
        return tokens
    end = next((i for i in range(start, len(tokens)) if tokens[i].kind == "}"), None)
    if end is None or len(tokens) < 2:
        return tokens
    edits = (removed(text, tokens[start], tokens[end].end),)
    repair = Repair("Remove 'ref_frame'", edits, False)
    message = f"{owner} '{shown(tokens[1].text)}' has a 'ref_frame', which only joints have"
    problems.append(Problem("KD001", message, tokens[start].start, tokens[end].end, repair))
    left_out += tokens[start : end + 1]
    return [*tokens[:start], *tokens[end + 1 :]]


def _own_frame(tokens: Sequence[Token]) -> int | None:
    """Return where a pose stands right in a link that has sections of a link before it."""
    depth, has_section = 0, False
    for index, token in enumerate(tokens[:-2]):
        depth += (token.kind == "{") - (token.kind == "}")
        if depth == 0 and token.kind == "}":
            return None
        has_section |= token.kind in _SECTIONS
        if depth == 1 and has_section and token.kind == "id":
            # That of a joint whose head is lost.
            return None
        kinds = [t.kind for t in tokens[index : index + 3]]
        if depth == 1 and has_section and kinds[:2] == ["ref_frame", "{"] and kinds[2] in _POSE:
            return index
    return None
