"""Applies the fixes of findings until nothing changes any more."""

from collections.abc import Iterable

from kindsl.analysis.analysis import Analysis, analyse
from kindsl.analysis.diagnostics import Diagnostic
from kindsl.text.edits import TextEdit, apply_edits

# A fix may make another possible; a hundred in a row are a defect of the rules.
_MOST_ROUNDS = 100
_SYNTAX = "KD0"


def mended(analysis: Analysis, with_unsafe: bool) -> tuple[Analysis, int]:
    """Return the analysis of the text with fixes applied, and how many findings they mended.

    A round that would add errors of syntax, or lead back to an earlier text, is not made.
    """
    n_fixed = 0
    seen = {analysis.text}
    for _ in range(_MOST_ROUNDS):
        edits, n_mended = disjoint_fixes(analysis.findings, with_unsafe)
        if not edits:
            break
        edits = [in_line_style(edit, analysis.text) for edit in edits]
        better = analyse(apply_edits(analysis.text, edits), analysis.settings)
        if better.text in seen or _n_syntax_errors(better) > _n_syntax_errors(analysis):
            break
        seen.add(better.text)
        analysis, n_fixed = better, n_fixed + n_mended
    return analysis, n_fixed


def disjoint_fixes(findings: Iterable[Diagnostic], with_unsafe: bool) -> tuple[list[TextEdit], int]:
    """Return the edits of fixes that do not touch each other, and how many findings they mend.

    A fix is taken whole or not at all; the first in the text wins, safe ones before unsafe.
    """
    taken: list[TextEdit] = []
    known: set[tuple[TextEdit, ...]] = set()
    n_mended = 0
    fixes = [finding.fix for finding in findings if finding.fix is not None]
    wanted = [fix for fix in fixes if fix.edits and (fix.is_safe or with_unsafe)]
    for fix in sorted(wanted, key=lambda fix: not fix.is_safe):
        if fix.edits in known:
            n_mended += 1
        elif not any(_touch(edit, other) for edit in fix.edits for other in taken):
            known.add(fix.edits)
            taken += fix.edits
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


def _touch(one: TextEdit, other: TextEdit) -> bool:
    return one.start <= other.end and other.start <= one.end


def _n_syntax_errors(analysis: Analysis) -> int:
    return sum(finding.code.startswith(_SYNTAX) for finding in analysis.findings)
