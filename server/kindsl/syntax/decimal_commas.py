"""Numbers with a comma in place of the decimal point: `0,5` is read as one number."""

from collections.abc import Sequence

from kindsl.syntax.tree import Token

_COMPONENTS = 3


def with_decimal_commas(tokens: Sequence[Token]) -> list[Token]:
    """Return the tokens, each number with a decimal comma as one malformed number.

    A comma is a decimal one where no blank is on either side, and the value then has no comma,
    or the vector three components.
    """
    merged: list[Token] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        if token.kind == "(" and index > 0 and tokens[index - 1].kind == "=":
            end = _closing(tokens, index)
            merged += _vector(tokens[index:end])
            index = end
        elif token.kind == "INT" and index > 0 and tokens[index - 1].kind == "=":
            merged += _merged(tokens[index : index + 3])
            index += 3
        else:
            merged.append(token)
            index += 1
    return merged


def _closing(tokens: Sequence[Token], index: int) -> int:
    """Return the index of the `)` behind an opening, at most some tokens behind."""
    for end in range(index, min(index + 40, len(tokens))):
        if tokens[end].kind == ")":
            return end
    return index + 1


def _vector(tokens: Sequence[Token]) -> list[Token]:
    merged: list[Token] = []
    index = 0
    while index < len(tokens):
        three = _merged(tokens[index : index + 3])
        merged.append(three[0])
        index += 3 if len(three) == 1 and index + 3 <= len(tokens) else 1
    commas = sum(token.kind == "," for token in merged)
    return merged if commas == _COMPONENTS - 1 else list(tokens)


def _merged(tokens: Sequence[Token]) -> list[Token]:
    """Return one token for digits, comma, digits; else the tokens as they are."""
    if [token.kind for token in tokens] != ["INT", ",", "INT"]:
        return list(tokens)
    left, comma, right = tokens
    if left.end != comma.start or comma.end != right.start or not right.text.isdigit():
        return list(tokens)
    text = f"{left.text},{right.text}"
    return [Token("MALFORMED_NUMBER", text, left.lead, left.start, right.end)]
