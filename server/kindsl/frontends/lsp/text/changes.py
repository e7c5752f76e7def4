"""A notification's changes, made one after the other, each in the positions the last one left."""

from collections.abc import Sequence

from lsprotocol import types

from kindsl.frontends.lsp.text.lines import Lines
from kindsl.language.text.span import Span

ContentChange = (
    types.TextDocumentContentChangePartial | types.TextDocumentContentChangeWholeDocument
)


def changed(lines: Lines, changes: Sequence[ContentChange], encoding: str) -> tuple[Lines, Span]:
    """Return the lines after some changes, and the stretch of them that is not as it was."""
    row = lines.row.copy()
    before = after = row.length
    for change in changes:
        start, end = _place(Lines(row), change, encoding)
        before, after = min(before, start), min(after, row.length - end)
        row.replace(start, end, change.text)
    return Lines(row), Span(before, row.length - after)


def _place(lines: Lines, change: ContentChange, encoding: str) -> tuple[int, int]:
    """Return what a change replaces; the places of a range may come in either order."""
    if isinstance(change, types.TextDocumentContentChangeWholeDocument):
        return 0, lines.length
    ends = change.range.start, change.range.end
    start, end = sorted(lines.offset(end.line, end.character, encoding) for end in ends)
    return start, end
