"""The one style, and the text edits that bring blanks into it; nothing else is changed."""

import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tables import KINDS
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.vocabulary import BLOCKS, NUMBERS, of_kind
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.span import Span

_LINE_END = re.compile(r"\r\n|\n|\r")
_INDENT = "    "
_BLOCKS = frozenset(("head", *BLOCKS))
_LINES = KINDS.keys() - of_kind("group")
_GLUED_AFTER = frozenset("(<[")
_GLUED_BEFORE = frozenset(",)>]")
_COMMENTS = frozenset(("//", "/*"))


class FormattingRefusedError(ValueError):
    """The document is not in the language, so its blanks cannot be judged."""


def format_document(document: SyntaxDocument) -> list[TextEdit]:
    """Return the edits that bring a document into the one style.

    Raises:
        FormattingRefusedError: The document has errors of syntax.
    """
    _refuse_broken(document)
    text = document.text
    first_line_end = _LINE_END.search(text)
    newline = first_line_end[0] if first_line_end else "\n"
    proper = gaps(pieces(document), len(text), newline)
    return [gap for gap in proper if text[gap.start : gap.end] != gap.text]


def format_range(document: SyntaxDocument, span: Span) -> list[TextEdit]:
    """Return the edits that touch a range.

    Raises:
        FormattingRefusedError: The document has errors of syntax.
    """
    edits = format_document(document)
    return [edit for edit in edits if edit.start <= span.end and span.start <= edit.end]


def _refuse_broken(document: SyntaxDocument) -> None:
    problems = [p for island in document.islands for p in island.problems]
    problems += [placed.problem for placed in document.problems]
    if problems:
        count = f"{len(problems)} errors" if len(problems) > 1 else "an error"
        raise FormattingRefusedError(f"the document has {count} of syntax: {problems[0].message}")


class Lexeme(NamedTuple):
    """A token or a comment.

    Attributes:
        start: Absolute offset.
        end: Absolute offset, without a comment's trailing blanks.
        kind: The token's kind; `//` or `/*` for comments.
        path: Kinds of the nodes that the token begins, outermost first.
        parent: Kind of the innermost node that holds it.
        lines_before: Line ends between the piece before and this one.
    """

    start: int
    end: int
    kind: str
    path: tuple[str, ...]
    parent: str
    lines_before: int


def pieces(document: SyntaxDocument) -> Iterator[Lexeme]:
    """Yield the tokens and comments of a document without problems, in order."""
    done = 0
    text = document.text
    for island, origin in zip(document.islands, document.starts, strict=True):
        for start, end, kind, path, parent in sorted(_in_island(island)):
            start, end = start + origin, end + origin
            yield Lexeme(start, end, kind, path, parent, len(_LINE_END.findall(text, done, start)))
            done = end


def _in_island(island: Island) -> Iterator[tuple[int, int, str, tuple[str, ...], str]]:
    for node in island.nodes:
        yield from _in_node(node, ())
    for start, end in island.comments:
        comment = island.text[start:end].rstrip()
        yield start, start + len(comment), comment[:2], (), ""


def _in_node(
    node: Node, outer: tuple[str, ...]
) -> Iterator[tuple[int, int, str, tuple[str, ...], str]]:
    """Yield the tokens below; the first carries the kinds of all nodes that begin with it."""
    path = (*outer, node.kind)
    for child in node.children:
        if isinstance(child, Token):
            yield child.start, child.end, child.kind, path, node.kind
        else:
            yield from _in_node(child, path)
        path = ()


def gaps(pieces: Iterable[Lexeme], length: int, newline: str) -> Iterator[TextEdit]:
    """Yield every gap of a document, absolute, with its proper blanks."""
    before: Lexeme | None = None
    done = depth = 0
    for piece in pieces:
        if piece.kind == "}" and piece.parent != "end":
            depth -= 1
        yield TextEdit(done, piece.start, _blanks(before, piece, depth, newline))
        if piece.kind == "{" and piece.parent != "head":
            depth += 1
        before, done = piece, piece.end
    yield TextEdit(done, length, newline)


def _blanks(before: Lexeme | None, piece: Lexeme, depth: int, newline: str) -> str:
    if before is None:
        return ""
    lines = _line_ends(before, piece)
    if not lines:
        return _space(before, piece)
    is_continuation = not _begins_line(piece) and piece.kind not in _COMMENTS
    return newline * lines + _INDENT * (depth + is_continuation)


def _line_ends(before: Lexeme, piece: Lexeme) -> int:
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
