"""Text of another format, as it becomes when it is pasted."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.language.syntax.passages import foreign_passages
from kindsl.language.text.edits import TextEdit, apply_edits
from kindsl.language.text.lines import line_start


class Pasting(NamedTuple):
    """A way to paste a text: edits of the document as it was before, certain if the only way."""

    title: str
    edits: tuple[TextEdit, ...]
    is_certain: bool


def pastings(analysis: Analysis, start: int, end: int, text: str) -> tuple[Pasting, ...]:
    """Return how a text of another format may be pasted; none where it is ours."""
    if not foreign_passages(text):
        return ()
    raw = TextEdit(start, end, _as_lines(analysis.text, start, end, text))
    after = analysis.edited([raw])
    return tuple(
        Pasting(fix.title, tuple(_before(raw, after.text, fix.edits)), is_certain)
        for fix, is_certain in _fixes(after, start, start + len(raw.text))
    )


def _as_lines(document: str, start: int, end: int, text: str) -> str:
    """Return a text with line ends where it would share a line with another."""
    before = document[line_start(document, start) : start]
    behind = document[end:].partition("\n")[0]
    lead = "\n" if before.strip() else ""
    return lead + text.strip("\r\n") + ("\n" if behind.strip() else "")


def _fixes(after: Analysis, start: int, end: int) -> Iterator[tuple[TextFix, bool]]:
    """Yield the fixes for the pasted text, and whether each is the only one."""
    for finding in after.check_without_twins():
        is_pasted = start <= finding.start and finding.end <= end
        if is_pasted and foreign_passages(after.text[finding.start : finding.end]):
            fixes = finding.choices if finding.fix is None else (finding.fix,)
            yield from ((fix, len(fixes) == 1) for fix in fixes)


def _before(raw: TextEdit, after: str, edits: Sequence[TextEdit]) -> Iterator[TextEdit]:
    begin, stop = raw.start, raw.start + len(raw.text)
    inner = [edit for edit in edits if edit.end >= begin and edit.start <= stop]
    first = min((begin, *(edit.start for edit in inner)))
    last = max((stop, *(edit.end for edit in inner)))
    shift = len(raw.text) - (raw.end - raw.start)
    moved = [TextEdit(e.start - first, e.end - first, e.text) for e in inner]
    yield TextEdit(first, last - shift, apply_edits(after[first:last], moved))
    for edit in edits:
        if edit not in inner:
            by = shift if edit.start >= stop else 0
            yield TextEdit(edit.start - by, edit.end - by, edit.text)
