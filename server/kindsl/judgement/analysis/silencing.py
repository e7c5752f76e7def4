"""Findings that comments silence, and comments that silence nothing."""

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Finding, Rule
from kindsl.judgement.rules.checks.kd704_unused_suppression import RULE as UNUSED_SUPPRESSION
from kindsl.judgement.rules.checks.kd704_unused_suppression import unused_suppressions
from kindsl.judgement.rules.checks.kd706_unknown_suppression import RULE as UNKNOWN_SUPPRESSION
from kindsl.judgement.rules.checks.kd706_unknown_suppression import unknown_suppressions
from kindsl.judgement.rules.suppression import Directive, Suppression, covered_by, directives
from kindsl.language.syntax.document import SyntaxDocument


def without_silenced(
    found: Sequence[Diagnostic],
    document: SyntaxDocument,
    silenced: Sequence[Suppression],
    codes: Collection[str],
    resolve: Callable[[Rule, Finding], Diagnostic],
) -> list[Diagnostic]:
    """Return the findings that no comment silences, and those about needless comments.

    Args:
        codes: Those of the rules that ran.
        resolve: Gives findings absolute offsets.
    """

    def of(rule: Rule, findings: Iterable[Finding]) -> list[Diagnostic]:
        return [resolve(rule, finding) for finding in findings] if rule.code in codes else []

    found = [*found, *of(UNKNOWN_SUPPRESSION, unknown_suppressions(_unknown(document, found)))]
    unused = [s for s in silenced if not any(s.covers(d.code, d.start) for d in found)]
    found = [d for d in found if not any(s.covers(d.code, d.start) for s in silenced)]
    return found + of(UNUSED_SUPPRESSION, unused_suppressions(unused, codes))


def _unknown(
    document: SyntaxDocument, found: Sequence[Diagnostic]
) -> Iterator[tuple[Directive, list[str]]]:
    """Yield the `kindsl:` comments, each with the codes of the findings there."""
    islands, starts = document.islands, document.starts
    for island in islands:
        for directive in directives(island):
            start, end = covered_by(islands, starts, len(document.text), directive)
            here = [d.code for d in found if start <= d.start < end and d.code[:3] != "KD0"]
            yield directive, here
