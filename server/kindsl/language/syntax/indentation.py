"""Indentation, and the lost or surplus braces that it reveals."""

from collections.abc import Iterator, Sequence

from kindsl.language.syntax.tree import Token
from kindsl.language.text.lines import is_first_on_line, line_start


def indentation(text: str, position: int) -> str:
    """Return the blanks at the beginning of the line that holds a position."""
    start = end = line_start(text, position)
    while end < len(text) and text[end] in " \t":
        end += 1
    return text[start:end]


def lost_closing(text: str, tokens: Sequence[Token]) -> int | None:
    """Return the index of the first `}` that stands further left than the block it would close.

    The brace of that block is the lost one. None where the layout shows nothing.
    """
    closings = _closings(text, tokens)
    return next(
        (i for i, column, indent, is_first in closings if column < indent and is_first), None
    )


def surplus_closing(text: str, tokens: Sequence[Token]) -> int | None:
    """Return the index of the `}` that closes too much, as the layout shows it.

    It is the first that stands further right than the block it closes, or the one before where
    that one stands at no block's own column.
    """
    suspect: int | None = None
    for index, column, indent, is_first in _closings(text, tokens):
        if column > indent and is_first:
            return index if suspect is None else suspect
        suspect = None if is_first and column == indent else index
    return None


def _closings(text: str, tokens: Sequence[Token]) -> Iterator[tuple[int, int, int, bool]]:
    """Yield the index of each `}`, its line's and its block's indentation, and if it is first."""
    openings: list[int] = []
    for index, token in enumerate(tokens):
        if token.kind in ("{", "}"):
            column = len(indentation(text, token.start))
            if token.kind == "{":
                openings.append(column)
            else:
                is_first = is_first_on_line(text, token.start)
                yield index, column, openings.pop() if openings else -1, is_first
