"""KD004 for what the parser does not see: a file that is no text at all."""

from kindsl.analysis.diagnostics import Diagnostic
from kindsl.cli.documents.sources import NotText
from kindsl.cli.outcome import LintedFile
from kindsl.rules.base import Severity

_CODE = "KD004"
_NAME = "invalid-character"


def no_document(shown: str, content: NotText) -> LintedFile:
    """Return the file whose content is no text, with the one finding that says so."""
    end = min(content.offset + 1, len(content.text))
    message = f"the document {content.message}"
    finding = Diagnostic(_CODE, _NAME, Severity.ERROR, message, content.offset, end)
    return LintedFile(shown, content.text, [finding])
