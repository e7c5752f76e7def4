"""A notification's changes as edits of the text before it.

The changes of one notification are made one after the other, each told in the positions that the
one before it left. Here they become edits of one text, to be made at once.
"""

import re
from collections.abc import Sequence
from itertools import pairwise
from typing import TypeGuard

from lsprotocol import types

from kindsl.lsp.text import code_units as convert
from kindsl.lsp.text.lines import Lines, without_end
from kindsl.text.edits import TextEdit

Change = types.TextDocumentContentChangePartial | types.TextDocumentContentChangeWholeDocument

_LINE = re.compile(r"[^\r\n]*(?:\r\n|\n|\r|$)")


def edits_of(lines: Lines, changes: Sequence[Change], encoding: str) -> list[TextEdit]:
    """Return disjoint edits, in the order of the text, that do what the changes do."""
    if _are_independent(changes, lines.last):
        edits = [_edit(lines, change, encoding) for change in changes]
        return edits[::-1]
    return _composed(lines, changes, encoding)


def _are_independent(changes: Sequence[Change], last_line: int) -> bool:
    """Whether each change lies lines before the one made before it, so that none moves another."""
    if len(changes) == 1:
        return True
    for earlier, later in pairwise(changes):
        if not (_is_partial(earlier) and _is_partial(later)):
            return False
        if _last_line(later) >= min(_first_line(earlier), last_line):
            return False
    return True


def _is_partial(change: Change) -> TypeGuard[types.TextDocumentContentChangePartial]:
    return isinstance(change, types.TextDocumentContentChangePartial)


def _first_line(change: types.TextDocumentContentChangePartial) -> int:
    return min(change.range.start.line, change.range.end.line)


def _last_line(change: types.TextDocumentContentChangePartial) -> int:
    return max(change.range.start.line, change.range.end.line)


def _edit(lines: Lines, change: Change, encoding: str) -> TextEdit:
    if not _is_partial(change):
        return TextEdit(0, lines.length, change.text)
    start = lines.offset(change.range.start.line, change.range.start.character, encoding)
    end = lines.offset(change.range.end.line, change.range.end.character, encoding)
    return TextEdit(min(start, end), max(start, end), change.text)


def _composed(lines: Lines, changes: Sequence[Change], encoding: str) -> list[TextEdit]:
    """Make the changes on a list of lines and see which lines are still the old ones."""
    texts = split_lines(lines.text(0, lines.length))
    origins: list[int] = []
    offset = 0
    for text in texts:
        origins.append(offset)
        offset += len(text)
    for change in changes:
        _splice(texts, origins, change, encoding)
    return _differences(texts, origins, lines.length)


def _splice(texts: list[str], origins: list[int], change: Change, encoding: str) -> None:
    """Make one change; a line that it touches has no origin any more."""
    if not _is_partial(change):
        texts[:] = split_lines(change.text)
        origins[:] = [-1] * len(texts)
        return
    (first, begin), (last, end) = sorted(
        _place(texts, position, encoding) for position in (change.range.start, change.range.end)
    )
    text = texts[first][:begin] + change.text + texts[last][end:]
    if first and texts[first - 1].endswith("\r") and text.startswith("\n"):
        first -= 1
        text = texts[first] + text
    new = split_lines(text)
    if last < len(texts) - 1:
        new.pop()
    texts[first : last + 1] = new
    origins[first : last + 1] = [-1] * len(new)


def _place(texts: list[str], position: types.Position, encoding: str) -> tuple[int, int]:
    if position.line >= len(texts):
        return len(texts) - 1, len(texts[-1])
    line = without_end(texts[position.line])
    return position.line, convert.column(line, position.character, encoding)


def _differences(texts: list[str], origins: list[int], length: int) -> list[TextEdit]:
    edits: list[TextEdit] = []
    new: list[str] = []
    done = 0
    for text, origin in zip((*texts, ""), (*origins, length), strict=True):
        if origin < 0:
            new.append(text)
            continue
        if new or origin > done:
            edits.append(TextEdit(done, origin, "".join(new)))
            new = []
        done = origin + len(text)
    return edits


def split_lines(text: str) -> list[str]:
    """Return the lines with their ends; the last, without an end, may be empty."""
    lines = _LINE.findall(text)
    if len(lines) > 1 and not lines[-1] and not lines[-2].endswith(("\n", "\r")):
        lines.pop()
    return lines
