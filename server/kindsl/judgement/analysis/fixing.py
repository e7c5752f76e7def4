"""Applies the fixes of findings until nothing changes any more."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.fix_trials import offered
from kindsl.judgement.analysis.proof import effect
from kindsl.judgement.analysis.text_fix import TextFix, disjoint, edits_of, prove
from kindsl.judgement.rules.base import Severity
from kindsl.language.syntax.scanner import comments, scan
from kindsl.language.text.edits import TextEdit, in_line_style

# A fix may make another possible; a hundred in a row are a defect of the rules.
_MOST_ROUNDS = 100
# Many fixes that spoil each other are not worth more looks at the whole document.
_MOST_TRIES = 64
_SYNTAX = "KD0"


class Fixed(NamedTuple):
    """The result of fixing a document.

    Attributes:
        rounds: The edits that were made at once, each in the text that the round before left.
    """

    analysis: Analysis
    n_findings: int
    rounds: tuple[tuple[TextEdit, ...], ...]


def fixed(analysis: Analysis, is_wanted: Callable[[Diagnostic], bool]) -> Fixed:
    """Apply the wanted fixes in rounds; those that meet others wait for the next one.

    A text is read before it is judged: fixes of its syntax come first. What a round did is looked
    at as a whole, see `made`. Rounds that lead back to an earlier text, but for blanks, are undone.
    """
    state = Fixed(analysis, 0, ())
    seen = {_without_blanks(analysis.text): state}
    while len(state.rounds) < _MOST_ROUNDS:
        prove(finding.fix for finding in state.analysis.findings if finding.fix is not None)
        wanted = offered(state.analysis, filter(is_wanted, state.analysis.findings))
        done = _round(state.analysis, wanted)
        if done is None:
            break
        n_findings = state.n_findings + done.n_findings
        state = Fixed(done.analysis, n_findings, state.rounds + done.rounds)
        written = _without_blanks(state.analysis.text)
        if written in seen:
            return seen[written]
        seen[written] = state
    return state


def made(analysis: Analysis, findings: Iterable[Diagnostic]) -> Fixed | None:
    """Apply the fixes of findings that go together in one round, None if there is none.

    Fixes go together if no comment and no block is lost, if there are no more errors than before,
    and, where all of them are safe, if every number keeps its value. If they do not, halves of them
    are tried, down to single ones.
    """
    best, taken = analysis, list[TextFix]()
    pending, n_tries = [disjoint_fixes(findings)], 0
    while pending and n_tries < _MOST_TRIES:
        some = pending.pop()
        if not some:
            continue
        n_tries += 1
        fixes = [*taken, *some]
        tried = analysis.edited(_edits(fixes, analysis.text))
        if _go_together(fixes, analysis, best, tried):
            best, taken = tried, fixes
        elif len(some) > 1:
            pending += [some[len(some) // 2 :], some[: len(some) // 2]]
    return Fixed(best, len(taken), (_edits(taken, analysis.text),)) if taken else None


def announced(analysis: Analysis) -> tuple[Diagnostic, ...]:
    """Return the findings; a fix that is never made, since it does harm, is but a choice."""
    prove(finding.fix for finding in analysis.findings if finding.fix is not None)
    findings = offered(analysis, analysis.findings)
    refused = _refused(analysis, findings)
    return tuple(
        finding._replace(fix=None, choices=(finding.fix,))
        if finding.fix is not None and finding.fix in refused
        else finding
        for finding in findings
    )


def _refused(analysis: Analysis, findings: Iterable[Diagnostic]) -> set[TextFix]:
    """Return the fixes that are not applied even alone; after many tries the rest is accepted."""
    refused, pending = set[TextFix](), list(_alike(findings))
    for _ in range(_MOST_TRIES):
        if not pending:
            break
        some = pending.pop()
        tried = analysis.edited(_edits(some, analysis.text))
        if _go_together(some, analysis, analysis, tried):
            continue
        if len(some) > 1:
            pending += [some[len(some) // 2 :], some[: len(some) // 2]]
        else:
            refused.update(some)
    return refused


def _alike(findings: Iterable[Diagnostic]) -> Iterator[list[TextFix]]:
    """Yield disjoint fixes that agree in being safe and in being of syntax: each fix once."""
    kinds: dict[tuple[bool, bool], dict[TextFix, None]] = {}
    for finding in findings:
        if finding.fix is not None:
            kind = finding.fix.is_safe, finding.code.startswith(_SYNTAX)
            kinds.setdefault(kind, {})[finding.fix] = None
    for fixes in kinds.values():
        while some := disjoint(fixes):
            yield some
            for fix in some:
                del fixes[fix]


def _round(analysis: Analysis, findings: list[Diagnostic]) -> Fixed | None:
    of_syntax = [finding for finding in findings if finding.code.startswith(_SYNTAX)]
    of_meaning = [finding for finding in findings if not finding.code.startswith(_SYNTAX)]
    return made(analysis, of_syntax) or made(analysis, of_meaning)


def _go_together(
    fixes: Sequence[TextFix], analysis: Analysis, best: Analysis, tried: Analysis
) -> bool:
    """Return whether fixes do no harm, compared with the best text so far."""
    within_digits = any(fix.is_within_digits for fix in fixes)
    done = effect(analysis.syntax, tried.syntax, within_digits=within_digits)
    is_kept = done.is_kept or not all(fix.is_safe for fix in fixes)
    if not done.is_whole or not is_kept:
        return False
    before, after = _errors(best), _errors(tried)
    # Text that can be read at last may have other errors; fixes of meaning bring none together.
    is_reading = any(code.startswith(_SYNTAX) for code in before - after)
    is_new = bool(after - before) and len(fixes) > 1 and not is_reading
    return after.total() <= before.total() and not is_new


def _without_blanks(text: str) -> tuple[str, ...]:
    """Return a key that texts share that differ in blanks only."""
    remarks = [text[start:end] for start, end in comments(text)]
    return (*(token.text for token in scan(text)), *remarks)


def is_safe(finding: Diagnostic) -> bool:
    """Return whether a finding has a safe fix."""
    return finding.fix is not None and finding.fix.is_safe


def is_fixable(finding: Diagnostic) -> bool:
    """Return whether a finding has a fix, safe or not."""
    return finding.fix is not None


def disjoint_fixes(findings: Iterable[Diagnostic]) -> list[TextFix]:
    """Return fixes that do not touch each other; of two that do the safe one wins, then the first.

    A fix is taken whole or not at all. Fixes may share edits.
    """
    fixes = [finding.fix for finding in findings if finding.fix is not None]
    return disjoint(sorted(fixes, key=lambda fix: not fix.is_safe))


def _edits(fixes: Iterable[TextFix], text: str) -> tuple[TextEdit, ...]:
    return tuple(in_line_style(edit, text) for edit in edits_of(fixes))


def _errors(analysis: Analysis) -> Counter[str]:
    """Return the errors by code, known ones of a baseline included."""
    found = (*analysis.findings, *analysis.apart.known)
    return Counter(f.code for f in found if f.severity is Severity.ERROR)
