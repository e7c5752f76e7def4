"""The one style: what stands between two neighbouring tokens or comments.

Blocks open on the line of their keyword and close on a line of their own; a section a line; one
blank line between links and joints, at most one elsewhere; comments stay where they are.
"""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from kindsl.language.formatting.pieces import Lexeme
from kindsl.language.syntax.tables import KINDS
from kindsl.language.syntax.vocabulary import BLOCKS, NUMBERS, of_kind

_INDENT = "    "
_BLOCKS = frozenset(("head", *BLOCKS))
_LINES = KINDS.keys() - of_kind("group")
_GLUED_AFTER = frozenset("(<[")
_GLUED_BEFORE = frozenset(",)>]")
_COMMENTS = frozenset(("//", "/*"))


class Gap(NamedTuple):
    """The blanks from `start` to `end` (absolute), and what should be there."""

    start: int
    end: int
    blanks: str


def gaps(pieces: Iterable[Lexeme], length: int, newline: str) -> Iterator[Gap]:
    """Yield every gap of a document with its proper blanks.

    Args:
        pieces: All tokens and comments, in order; at least one.
        length: Of the text, code points.
        newline: The document's line end.
    """
    before: Lexeme | None = None
    done = depth = 0
    for piece in pieces:
        if piece.kind == "}" and piece.parent != "end":
            depth -= 1
        yield Gap(done, piece.start, _blanks(before, piece, depth, newline))
        if piece.kind == "{" and piece.parent != "head":
            depth += 1
        before, done = piece, piece.end
    yield Gap(done, length, newline)


def _blanks(before: Lexeme | None, piece: Lexeme, depth: int, newline: str) -> str:
    if before is None:
        return ""
    lines = _line_ends(before, piece)
    if not lines:
        return _space(before, piece)
    is_continuation = not _begins_line(piece) and piece.kind not in _COMMENTS
    return newline * lines + _INDENT * (depth + is_continuation)


def _line_ends(before: Lexeme, piece: Lexeme) -> int:
    """Return how many line ends separate two pieces."""
    is_comment = piece.kind in _COMMENTS
    if not piece.lines_before and is_comment:
        return 0
    if not piece.lines_before and before.kind == "/*":
        return 1 if _begins_line(piece) and not before.lines_before else 0
    if before.kind == "{" and piece.kind == "}":
        return 0
    if not is_comment and not _begins_line(piece) and before.kind not in _COMMENTS:
        return 0
    if before.kind == "{" and before.parent == "head" and piece.parent != "end":
        return 2
    if before.kind == "}" and not _BLOCKS.isdisjoint(piece.path):
        return 2
    may_be_blank = before.kind != "{" and piece.kind != "}"
    may_be_blank = may_be_blank and (is_comment or _begins_line(piece))
    return 2 if piece.lines_before > 1 and may_be_blank else 1


def _begins_line(piece: Lexeme) -> bool:
    return piece.kind == "}" or not _LINES.isdisjoint(piece.path)


def _space(before: Lexeme, piece: Lexeme) -> str:
    """Return what separates two pieces on one line."""
    if piece.kind == "//":
        return "  "
    if before.kind in _GLUED_AFTER or piece.kind in _GLUED_BEFORE:
        return ""
    if piece.kind in _COMMENTS or before.kind in _COMMENTS:
        return " "
    if piece.kind == "}":
        return ""
    if piece.kind == "[" or before.kind in ("*", "/") or piece.kind in ("*", "/"):
        return ""
    if piece.parent == "constant" and "=" in (before.kind, piece.kind):
        return ""
    if before.parent == "constant" and before.kind == "=":
        return ""
    if before.parent == "negate":
        return " " if piece.kind in NUMBERS else ""
    return " "
