"""Findings as the client can show them."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from lsprotocol import types

from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.client import DiagnosticParts

if TYPE_CHECKING:
    from kindsl.judgement.analysis.diagnostics import Diagnostic

SOURCE = "kindsl"
_SEVERITIES = {
    "error": types.DiagnosticSeverity.Error.value,
    "warning": types.DiagnosticSeverity.Warning.value,
    "info": types.DiagnosticSeverity.Information.value,
    "hint": types.DiagnosticSeverity.Hint.value,
}
_TAGS = {"unnecessary": types.DiagnosticTag.Unnecessary.value}


def diagnostics(
    document: Document, findings: "Iterable[Diagnostic]", parts: DiagnosticParts
) -> list[dict[str, Any]]:
    """Return findings as a client can show them, in the protocol's form, for there are many."""
    return [_diagnostic(document, finding, parts) for finding in findings]


def _diagnostic(
    document: Document, finding: "Diagnostic", parts: DiagnosticParts
) -> dict[str, Any]:
    at = finding.start, finding.end
    found: dict[str, Any] = {
        "range": document.wire_range(*at),
        "severity": _SEVERITIES[finding.severity],
        "code": finding.code,
        "source": SOURCE,
        "message": finding.message,
    }
    if parts.links and finding.url is not None:
        found["codeDescription"] = {"href": finding.url}
    if parts.tags and finding.tag:
        found["tags"] = [_TAGS[finding.tag]]
    if parts.related and finding.related:
        found["relatedInformation"] = [
            {"location": {"uri": document.uri, "range": place_range}, "message": message}
            for start, end, message in finding.related
            # Rivals of what a finding tells have its place.
            for place_range in (
                found["range"] if (start, end) == at else document.wire_range(start, end),
            )
        ]
    return found
