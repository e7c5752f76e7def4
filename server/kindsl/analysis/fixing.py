"""Applies the fixes of findings until nothing changes any more."""

from bisect import bisect_left, insort
from collections.abc import Callable, Iterable
from typing import NamedTuple

from kindsl.analysis.analysis import Analysis
from kindsl.analysis.diagnostics import Diagnostic
from kindsl.syntax.scanner import comments, scan
from kindsl.text.edits import TextEdit

# A fix may make another possible; a hundred in a row are a defect of the rules.
_MOST_ROUNDS = 100
_SYNTAX = "KD0"


class Mended(NamedTuple):
    """What became of a document.

    Attributes:
        analysis: Of the text with fixes applied.
        n_findings: How many findings they mended.
        rounds: The edits that were made at once, each in the text that the round before left.
    """

    analysis: Analysis
    n_findings: int
    rounds: tuple[tuple[TextEdit, ...], ...]


def mended(analysis: Analysis, is_wanted: Callable[[Diagnostic], bool]) -> Mended:
    """Apply the wanted fixes; those that meet others wait for the next round.

    A round that would add errors of syntax is not made. Rounds that lead back to an earlier text,
    but for blanks, are undone.
    """
    state = Mended(analysis, 0, ())
    seen = {_written(analysis.text): state}
    while len(state.rounds) < _MOST_ROUNDS:
        fixes, n_mended = disjoint_fixes(filter(is_wanted, state.analysis.findings))
        edits = tuple(in_line_style(edit, state.analysis.text) for edit in fixes)
        better = state.analysis.edited(edits)
        if not fixes or _n_syntax_errors(better) > _n_syntax_errors(state.analysis):
            break
        state = Mended(better, state.n_findings + n_mended, (*state.rounds, edits))
        written = _written(better.text)
        if written in seen:
            return seen[written]
        seen[written] = state
    return state


def _written(text: str) -> tuple[str, ...]:
    """Return what two texts share that differ in blanks alone."""
    remarks = [text[start:end] for start, end in comments(text)]
    return (*(token.text for token in scan(text)), *remarks)


def is_safe(finding: Diagnostic) -> bool:
    """Return whether a finding has a fix that cannot change what was meant."""
    return finding.fix is not None and finding.fix.is_safe


def is_mendable(finding: Diagnostic) -> bool:
    """Return whether a finding has a fix, safe or not."""
    return finding.fix is not None


def disjoint_fixes(findings: Iterable[Diagnostic]) -> tuple[list[TextEdit], int]:
    """Return edits that do not touch each other, in their order, and how many findings they mend.

    A fix is taken whole or not at all; of two that touch each other the safe one wins, then the
    first. Fixes may share edits.
    """
    taken: list[TextEdit] = []
    n_mended = 0
    fixes = [finding.fix for finding in findings if finding.fix is not None and finding.fix.edits]
    for fix in sorted(fixes, key=lambda fix: not fix.is_safe):
        new = [edit for edit in fix.edits if not _is_among(taken, edit)]
        if all(_is_apart(taken, edit) for edit in new):
            for edit in new:
                insort(taken, edit)
            n_mended += 1
    return taken, n_mended


def in_line_style(edit: TextEdit, text: str) -> TextEdit:
    """Return an edit with the line ends that a text has."""
    if "\n" not in edit.text or "\r" not in text:
        return edit
    line_end = "\r\n" if "\r\n" in text else "\r"
    if "\n" in text.replace("\r\n", ""):
        return edit
    return edit._replace(text=edit.text.replace("\r\n", "\n").replace("\n", line_end))


def _is_among(taken: list[TextEdit], edit: TextEdit) -> bool:
    index = bisect_left(taken, edit)
    return taken[index : index + 1] == [edit]


def _is_apart(taken: list[TextEdit], edit: TextEdit) -> bool:
    """Return whether an edit neither overlaps nor touches sorted, disjoint ones."""
    index = bisect_left(taken, edit)
    before, behind = taken[max(index - 1, 0) : index], taken[index : index + 1]
    return all(t.end < edit.start for t in before) and all(edit.end < t.start for t in behind)


def _n_syntax_errors(analysis: Analysis) -> int:
    return sum(finding.code.startswith(_SYNTAX) for finding in analysis.findings)
