"""KD004 for what the parser does not see: bytes that are no UTF-8, in comments or altogether."""

import re
from collections.abc import Iterator, Sequence

from kindsl.cli.outcome import LintedFile
from kindsl.cli.sources import NotText
from kindsl.rules.base import Severity
from kindsl.rules.diagnostics import Diagnostic

_CODE = "KD004"
_NAME = "invalid-character"
_BYTES = re.compile("[\udc80-\udcff]+")


def with_undecodable(text: str, findings: Sequence[Diagnostic]) -> Sequence[Diagnostic]:
    """Return findings with one for each run of undecodable bytes that none tells of yet.

    Args:
        text: As read, such bytes as `surrogateescape` leaves them.
        findings: What is known already, in the order of the text.
    """
    known = {offset for f in findings if f.code == _CODE for offset in range(f.start, f.end)}
    added = list(_undecodable(text, known))
    if not added:
        return findings
    return sorted([*findings, *added], key=lambda d: (d.start, d.end, d.code, d.message))


def no_document(shown: str, content: NotText) -> LintedFile:
    """Return the file whose content is no text, with the one finding that says so."""
    end = min(content.offset + 1, len(content.text))
    message = f"the document {content.message}"
    finding = Diagnostic(_CODE, _NAME, Severity.ERROR, message, content.offset, end)
    return LintedFile(shown, content.text, [finding])


def _undecodable(text: str, known: set[int]) -> Iterator[Diagnostic]:
    for run in _BYTES.finditer(text):
        if known.isdisjoint(range(*run.span())):
            told = " ".join(f"0x{ord(character) - 0xDC00:02X}" for character in run[0][:8])
            noun = "byte" if len(run[0]) == 1 else "bytes"
            message = f"undecodable {noun} {told}, a document is UTF-8"
            yield Diagnostic(_CODE, _NAME, Severity.ERROR, message, *run.span())
