"""The linter's findings, for the list over the picture."""

from collections import Counter
from collections.abc import Sequence

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.lines import LineIndex
from kindsl.robots.mechanism.total_mass import NO_MASS
from kindsl.robots.scene.messages import FindingMessage, StatusMessage
from kindsl.robots.scene.picture import Picture
from kindsl.robots.scene.state import Messages, keyed, path_of

# A page that lists hundreds of findings helps nobody and costs at every keystroke.
MOST_LISTED = 40
_RANK = {severity: rank for rank, severity in enumerate(Severity)}


def listed(findings: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return the findings that the page lists, the worst first."""
    return sorted(findings, key=lambda finding: _RANK[finding.severity])[:MOST_LISTED]


def finding_messages(findings: Sequence[Diagnostic], text: str) -> Messages:
    """Return one message for each listed finding; lines and columns count from 1."""
    if not findings:
        return {}
    lines = LineIndex(text)
    return keyed(_finding(index, finding, lines) for index, finding in enumerate(listed(findings)))


def status_message(drawn: Picture, findings: Sequence[Diagnostic], label: str) -> StatusMessage:
    """Return the message about the state of the picture and how many findings there are."""
    counts = Counter(str(finding.severity) for finding in findings)
    return StatusMessage(
        state=drawn.state,
        message=drawn.message,
        total=len(findings),
        counts=dict(counts),
        label=label,
        mass=drawn.weight.known,
        lacks=drawn.weight.plain_reason,
        is_former=drawn.is_former,
    )


def lost_message(message: str, drawn: Picture | None, total: int, label: str) -> StatusMessage:
    """Return the message that the document itself is not there: what is shown is a former one."""
    weight = NO_MASS if drawn is None else drawn.weight
    return StatusMessage(
        state="gone",
        message=message,
        total=total,
        counts={},
        label=label,
        mass=weight.known,
        lacks=weight.plain_reason,
        is_former=True,
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
