"""The linter's findings, for the list over the picture."""

from collections import Counter
from collections.abc import Sequence

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.lines import LineIndex
from kindsl.robots.mechanism.total_mass import NO_MASS
from kindsl.robots.scene.messages import FindingMessage, StatusMessage, path_of
from kindsl.robots.scene.picture import Picture

# A page that lists hundreds of findings helps nobody and costs at every keystroke.
MOST_LISTED = 40
_RANK = {severity: rank for rank, severity in enumerate(Severity)}


def listed(findings: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return the findings that the page lists, the worst first."""
    return sorted(findings, key=lambda finding: _RANK[finding.severity])[:MOST_LISTED]


def finding_messages(findings: Sequence[Diagnostic], text: str) -> list[FindingMessage]:
    """Return one message for each listed finding; lines and columns count from 1."""
    if not findings:
        return []
    lines = LineIndex(text)
    return [_finding(index, finding, lines) for index, finding in enumerate(listed(findings))]


def status_message(
    drawn: Picture | None, findings: Sequence[Diagnostic], label: str, lost: str = ""
) -> StatusMessage:
    """Return the message about the state of the picture and how many findings there are.

    Args:
        drawn: The picture, None if there has never been one.
        findings: All of them, listed or not.
        label: Name of the document.
        lost: Why the document is not there any longer, so that a former one is shown.
    """
    weight = NO_MASS if drawn is None else drawn.weight
    counts = Counter(str(finding.severity) for finding in findings)
    return StatusMessage(
        state="gone" if lost or drawn is None else drawn.state,
        message=lost or ("" if drawn is None else drawn.message),
        total=len(findings),
        counts={} if lost else dict(counts),
        label=label,
        mass=weight.known,
        lacks=weight.plain_reason,
        is_former=bool(lost) or (drawn is not None and drawn.is_former),
    )


def _finding(index: int, finding: Diagnostic, lines: LineIndex) -> FindingMessage:
    line, column = lines.position(finding.start)
    return FindingMessage(
        path=path_of("findings", str(index)),
        index=index,
        code=finding.code,
        severity=str(finding.severity),
        message=finding.message,
        line=line + 1,
        column=column + 1,
    )
