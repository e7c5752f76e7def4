"""Habits from other languages, read as they are meant: `0,5`, `[1.0, 0.0, 0.0]`, `x-1.0`, `# a`.

They are put right before the search for repairs, which would see several mistakes in them.
"""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.syntax.components import COMPONENTS, QUOTES, from_attribute, of_three, with_commas
from kindsl.syntax.foreign.words import in_our_words, without_relatives
from kindsl.syntax.half_written import VECTOR, half_vector, with_whole_children, with_whole_sections
from kindsl.syntax.malformed import is_grouped
from kindsl.syntax.obsolete_forms import in_todays_forms
from kindsl.syntax.token_names import SPELLINGS, supplied
from kindsl.syntax.tree import Edit, Problem, Repair, Token

_REACH = 40
_VECTORS = frozenset({"CoM", "translation", "rotation"})
_SCALARS = frozenset({"mass", "MOMENT"})
_NUMBERS = frozenset({"FLOAT", "INT", "SCIENTIFIC", "POWER_FLOAT"})
_OPERANDS = _NUMBERS | frozenset({"NAME", "PI_PREFIXED", "PI", "LOWER_PI", ")", "]", ">"})
_KEYWORD_KINDS = frozenset(SPELLINGS) - {"PI", "LOWER_PI"}
_CLOSING = {"[": "]", "{": "}"}
_CODE_SIGNS = frozenset("={}(")


class Adapted(NamedTuple):
    """Tokens put right.

    Attributes:
        tokens: What is to be read.
        skipped: What is left out.
        problems: What there is to say; malformed numbers are told of later.
    """

    tokens: list[Token]
    skipped: list[Token]
    problems: list[Problem]


def adapted(text: str, tokens: Sequence[Token]) -> Adapted:
    """Return the tokens of an island with the habits of other languages put right."""
    result = Adapted([], [], [])
    tokens, relatives = without_relatives(text, tokens, result.problems)
    result.skipped.extend(relatives)
    tokens, repeated = in_our_words(tokens, result.problems)
    result.skipped.extend(repeated)
    tokens, obsolete = in_todays_forms(text, tokens, result.problems)
    result.skipped.extend(obsolete)
    tokens = with_whole_children(text, tokens, result.problems)
    index = 0
    while index < len(tokens):
        token = tokens[index]
        previous = tokens[index - 1] if index else None
        if token.text == "#" and _is_comment(text, tokens, index):
            end = _line_end(text, tokens, index)
            _leave_out(result, tokens[index:end])
            index = end
        elif previous is None or previous.kind != "=":
            result.tokens.append(token)
            index += 1
        else:
            word = tokens[index - 2].kind if index > 1 else ""
            end = _value_end(tokens, index)
            half = half_vector(text, tokens, index) if _is_open(tokens, index, end, word) else None
            if half is not None:
                result.problems.append(half.problem)
                result.tokens.extend(half.tokens)
                index = half.end
                continue
            following = tokens[end].kind if end < len(tokens) else ""
            is_scalar = word in _SCALARS and following != "="
            if word in _VECTORS:
                _put_vector(text, result, tokens[index:end], following, tokens[index - 1])
            else:
                result.tokens.extend(_with_points_or_signs(text, tokens[index:end], is_scalar))
            index = end
    result.tokens[:] = with_whole_sections(text, result.tokens, result.problems)
    return result


def _is_open(tokens: Sequence[Token], index: int, end: int, word: str) -> bool:
    """Return whether a value is a vector that does not end."""
    return word in _VECTORS and tokens[index].kind == "(" and tokens[end - 1].kind != ")"


def _is_comment(text: str, tokens: Sequence[Token], index: int) -> bool:
    """Return whether `#` begins a comment: words behind it on its line, no code."""
    words = tokens[index + 1 : _line_end(text, tokens, index)]
    if not words or any(word.kind in _CODE_SIGNS for word in words):
        return False
    start = max(text.rfind("\n", 0, tokens[index].start), text.rfind("\r", 0, tokens[index].start))
    is_first = not text[start + 1 : tokens[index].start].strip(" \t")
    if len(words) == 1:
        return is_first and words[0].kind == "NAME"
    return len(words) > 3 or (is_first and words[0].text[:1].isidentifier())


def _line_end(text: str, tokens: Sequence[Token], index: int) -> int:
    end = index + 1
    while end < len(tokens):
        between = text[tokens[end - 1].end : tokens[end].start]
        if "\n" in between or "\r" in between:
            break
        end += 1
    return end


def _leave_out(result: Adapted, comment: Sequence[Token]) -> None:
    first = comment[0]
    repair = Repair("Write '//'", (Edit(first.start, first.end, "//"),), True)
    message = "'#' does not begin a comment"
    result.problems.append(Problem("KD001", message, first.start, first.end, repair))
    result.skipped.extend(comment)


def _value_end(tokens: Sequence[Token], index: int) -> int:
    """Return the index behind a bracketed value, or behind the operands of a bare one."""
    first = tokens[index].kind
    if first in ("(", "[", "{"):
        closing = _CLOSING.get(first, ")")
        for end in range(index + 1, min(index + _REACH, len(tokens))):
            if tokens[end].kind in (closing, ")"):
                return end + 1
            if tokens[end].kind in ("=", "{", "}"):
                break
        return index + 1
    if tokens[index].text in QUOTES:
        inside = [token.text for token in tokens[index + 1 : index + 2 + COMPONENTS]]
        quote = tokens[index].text
        return index + 2 + inside.index(quote) if quote in inside else index + 1
    end = index + 1
    while end < min(index + _REACH, len(tokens)) and tokens[end].kind in ("INT", "FLOAT", ","):
        end += 1
    return end


def _put_vector(
    text: str, result: Adapted, tokens: Sequence[Token], following: str, equals: Token
) -> None:
    """Add the tokens of a vector, of three components where their number is plain."""
    first = tokens[0]
    if first.kind in _KEYWORD_KINDS or first.kind == "}":
        if following == "=" or (first.kind == "}" and following not in _NUMBERS):
            message = "expected a vector '(x, y, z)' after '='"
            result.problems.append(Problem("KD001", message, equals.end, equals.end))
            result.tokens.extend(supplied(kind, equals.end) for kind in VECTOR)
        result.tokens.extend(tokens)
        return
    attribute = from_attribute(tokens, result.problems) if following != ")" else []
    if attribute:
        result.tokens.extend(attribute)
        return
    if first.kind in _NUMBERS:
        tokens = _with_parentheses(tokens, following, result.problems)
    tokens = _with_round_brackets(tokens, result.problems)
    tokens = with_commas(tokens, result.problems)
    tokens = _with_points_or_signs(text, tokens, False)
    result.tokens.extend(of_three(tokens, result.problems, result.skipped))


def _with_parentheses(
    tokens: Sequence[Token], following: str, problems: list[Problem]
) -> Sequence[Token]:
    """Return three bare numbers as a vector."""
    if [token.kind for token in tokens[1::2]] != [",", ","] or len(tokens) != 5 or following == ")":
        return tokens
    start, end = tokens[0].start, tokens[-1].end
    repair = Repair("Insert '()'", (Edit(start, start, "("), Edit(end, end, ")")), True)
    problems.append(Problem("KD001", "vector is not enclosed in '()'", start, end, repair))
    return [supplied("(", tokens[0].lead), *tokens, supplied(")", end)]


def _with_points_or_signs(text: str, tokens: Sequence[Token], is_scalar: bool) -> list[Token]:
    merged = _with_points(text, tokens)
    commas = sum(token.kind == "," for token in merged)
    is_vector = bool(merged) and merged[0].kind == "("
    if not (is_vector and commas == COMPONENTS - 1) and not (is_scalar and commas == 0):
        merged = list(tokens)
    commas = sum(token.kind == "," for token in merged)
    is_whole = is_scalar or commas == COMPONENTS - 1
    return [part for i, token in enumerate(merged) for part in _unsigned(text, merged, i, is_whole)]


def _with_round_brackets(tokens: Sequence[Token], problems: list[Problem]) -> list[Token]:
    """Return the tokens of a vector in `[]` or `{}` as one in `()`."""
    first, last = tokens[0], tokens[-1]
    if _CLOSING.get(first.kind) != last.kind or not any(t.kind == "," for t in tokens):
        return list(tokens)
    edits = (Edit(first.start, first.end, "("), Edit(last.start, last.end, ")"))
    message = f"vector is enclosed in '{first.text}{last.text}' instead of '()'"
    repair = Repair("Write '()'", edits, True)
    problems.append(Problem("KD001", message, first.start, last.end, repair))
    opening = Token("(", first.text, first.lead, first.start, first.end)
    closing = Token(")", last.text, last.lead, last.start, last.end)
    return [opening, *tokens[1:-1], closing]


def _with_points(text: str, tokens: Sequence[Token]) -> list[Token]:
    """Return the tokens with `0,5`, `1 234.5` and the like as one malformed number."""
    merged: list[Token] = []
    index = 0
    while index < len(tokens):
        parts = _one_number(text, tokens, index)
        if len(parts) > 1:
            start, end = parts[0].start, parts[-1].end
            written = text[start:end]
            merged.append(Token("MALFORMED_NUMBER", written, parts[0].lead, start, end))
        else:
            merged.append(tokens[index])
        index += max(len(parts), 1)
    return merged


def _one_number(text: str, tokens: Sequence[Token], index: int) -> Sequence[Token]:
    """Return the tokens that make one number in groups of three digits, or with a comma."""
    end = index + 1
    while end < len(tokens) and _may_go_on(text, tokens, end):
        end += 1
    while end > index + 1:
        if is_grouped(text[tokens[index].start : tokens[end - 1].end]):
            return tokens[index:end]
        end -= 1
    three = tokens[index : index + 3]
    return three if _is_decimal_comma(three) else ()


def _may_go_on(text: str, tokens: Sequence[Token], index: int) -> bool:
    """Return whether a number may go on at a token: digits or a comma, a blank between at most."""
    token = tokens[index]
    if token.start == token.end or text[tokens[index - 1].end : token.start] not in ("", " "):
        return False
    is_number = token.kind in ("INT", "FLOAT") and token.text[0] not in "+-"
    return token.kind == "," or is_number


def _is_decimal_comma(tokens: Sequence[Token]) -> bool:
    if [token.kind for token in tokens] != ["INT", ",", "INT"]:
        return False
    left, comma, right = tokens
    return left.end == comma.start and comma.end == right.start and right.text.isdigit()


def _unsigned(text: str, tokens: Sequence[Token], index: int, is_whole: bool) -> tuple[Token, ...]:
    """Return a signed number behind an operand as an operator and a number: `x-1.0`."""
    token = tokens[index]
    if token.kind not in _NUMBERS or token.text[:1] not in ("+", "-") or index == 0:
        return (token,)
    before = tokens[index - 1]
    between = text[before.end : token.start]
    if before.kind not in _OPERANDS or "\n" in between or (between and not is_whole):
        return (token,)
    middle = token.start + 1
    sign = Token(token.text[0], token.text[0], token.lead, token.start, middle)
    return sign, Token(token.kind, token.text[1:], middle, middle, token.end)
