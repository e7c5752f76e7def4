"""What the linter doubts about bodies, for pictures of them."""

from collections.abc import Iterable

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.subject import SubjectKind
from kindsl.robots.scene.solids import Doubt

# The hundreds about inertia and geometry, but for what says that nothing was measured.
_NUMBERS, _UNMEASURED = ("KD3", "KD5"), ("KD304", "KD310")
_DOUBTED = (Severity.ERROR, Severity.WARNING)


def body_doubts(analysis: Analysis, findings: Iterable[Diagnostic]) -> dict[str, tuple[Doubt, ...]]:
    """Return the errors and warnings about the numbers of bodies by link, the errors first.

    Args:
        analysis: What is drawn.
        findings: Of its text, what is suppressed not among them.
    """
    doubts: dict[str, list[Doubt]] = {}
    for finding in findings:
        is_of_numbers = finding.code.startswith(_NUMBERS) and finding.code not in _UNMEASURED
        if not is_of_numbers or finding.severity not in _DOUBTED:
            continue
        doubt = Doubt(finding.code, finding.message, finding.severity is Severity.ERROR)
        for kind, name in (finding.subject, *finding.also):
            if kind is SubjectKind.LINK:
                doubts.setdefault(analysis.body_with(name), []).append(doubt)
    return {
        link: tuple(sorted(own, key=lambda doubt: not doubt.is_error))
        for link, own in doubts.items()
    }
