"""The calm of a document in which someone types: a line that is not done yet draws no squiggles."""

from typing import TYPE_CHECKING, NamedTuple

from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.text.open_documents import Documents

if TYPE_CHECKING:
    from kindsl.judgement.analysis.diagnostics import Diagnostic

# Seconds without an edit after which a line counts as done.
PATIENCE = 0.7

_Key = tuple[str, str]


class Calm:
    """Holds back what is new while someone types in one line; what is corrected goes at once.

    What is held back is told when the next edit is in another line, or after `PATIENCE`.
    """

    __slots__ = ("_known",)

    def __init__(self, documents: Documents) -> None:
        self._known: dict[str, _Told] = {}
        documents.on_close.append(self._forget)

    def shown(
        self, document: Document, findings: "tuple[Diagnostic, ...]"
    ) -> "tuple[Diagnostic, ...]":
        """Return the findings of a version that are told now: the very same if none is held."""
        line, key = _line_of_edit(document), uris.key(document.uri)
        known = self._known.get(key)
        told = findings
        if known is not None and line is not None:
            has_left = known.line is not None and known.line != line
            told = tuple(
                each
                for each in findings
                if _key(each) in known.keys
                or (has_left and document.lines.line(each.start) != line)
            )
            told = findings if len(told) == len(findings) else told
        self._known[key] = _Told(line, frozenset(map(_key, told)))
        return told

    def settle(self, document: Document, findings: "tuple[Diagnostic, ...]") -> None:
        """Note that all findings of a version are told, for its line counts as done."""
        known = _Told(_line_of_edit(document), frozenset(map(_key, findings)))
        self._known[uris.key(document.uri)] = known

    def _forget(self, document: Document) -> None:
        self._known.pop(uris.key(document.uri), None)


class _Told(NamedTuple):
    """The findings told of a version, and the line in which someone typed, from 0.

    Without a line all was told, for the edit left one.
    """

    line: int | None
    keys: frozenset[_Key]


def _key(finding: "Diagnostic") -> _Key:
    return finding.code, finding.message


def _line_of_edit(document: Document) -> int | None:
    """Return the line that contains the whole last edit, None if none does."""
    if document.touched is None:
        return None
    first, last = map(document.lines.line, document.touched)
    return first if first == last else None
