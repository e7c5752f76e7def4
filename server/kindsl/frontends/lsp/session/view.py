"""A handler's view: one version of a document, its analysis, and the settings."""

import re
from typing import TYPE_CHECKING

from lsprotocol import types

from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.client import Client
from kindsl.language.text.span import Span

if TYPE_CHECKING:
    from kindsl.judgement.analysis.analysis import Analysis
    from kindsl.judgement.config.editor_settings import EditorSettings

_MARKS = re.compile(r"\*\*|`|\\(?=[^\w\s])")


class Sight:
    """One version of a document, of whatever kind."""

    __slots__ = ("document", "state")

    def __init__(self, document: Document, state: State) -> None:
        self.document = document
        self.state = state

    def offset(self, position: types.Position) -> int:
        """Return the code point that a client's position means."""
        return self.document.offset(position)

    def span(self, at: types.Range) -> Span:
        """Return the stretch of code points that a client's range means."""
        return Span(self.offset(at.start), self.offset(at.end))

    @property
    def client(self) -> Client:
        """The editor's capabilities."""
        return self.state.client

    @property
    def editor_settings(self) -> "EditorSettings":
        """The user's settings in the editor."""
        return self.state.workspace.editor_settings(self.document.uri)

    def markup(self, markdown: str, capability: str) -> types.MarkupContent:
        """Return a text as Markdown, or plain to a client that lists other formats only."""
        formats = self.client.values(capability)
        is_known = not formats or types.MarkupKind.Markdown in formats
        kind = types.MarkupKind.Markdown if is_known else types.MarkupKind.PlainText
        return types.MarkupContent(kind, markdown if is_known else without_marks(markdown))

    def refuse(self, message: str) -> None:
        """Tell the user why something was not done; not again at each save of a broken document."""
        if self.document.uri not in self.state.refused:
            self.state.refused.add(self.document.uri)
            self.state.show_warning(message)

    def location(self, start: int, end: int) -> types.Location:
        """Return the client's place of a stretch of code points."""
        return types.Location(self.document.uri, self.range(start, end))

    def range(self, start: int, end: int) -> types.Range:
        """Return the client's range of a stretch of code points."""
        return self.document.range(start, end)


class View(Sight):
    """One version of a robot with its analysis."""

    __slots__ = ("analysis",)

    def __init__(self, document: Document, analysis: "Analysis", state: State) -> None:
        super().__init__(document, state)
        self.analysis = analysis

    def follow_cursor(self, position: types.Position) -> None:
        """Tell who listens what the cursor is on."""
        from kindsl.frontends.features.symbol_at import symbol_at

        symbol = symbol_at(self.analysis, self.offset(position))
        self.tell_cursor(*((symbol.entity.kind, symbol.entity.name) if symbol else ("", "")))

    def tell_cursor(self, kind: str, name: str) -> None:
        """Tell who listens that the cursor is on a thing; on nothing for an empty name."""
        for listener in self.state.on_cursor:
            listener(self.document.uri, kind, name)


def without_marks(markdown: str) -> str:
    """Return Markdown without its marks."""
    return _MARKS.sub("", markdown)
