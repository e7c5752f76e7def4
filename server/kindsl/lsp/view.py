"""What a handler sees: one version of a document, what is known about it, and the settings."""

from typing import TYPE_CHECKING

from lsprotocol import types

from kindsl.lsp.client import Client
from kindsl.lsp.document import Document

if TYPE_CHECKING:
    from kindsl.lsp.server import KindslLanguageServer
    from kindsl.rules.analysis import Analysis


class View:
    """One version of a document with its analysis.

    Attributes:
        document: The text.
        analysis: What it means.
        server: The settings, the client, the other documents.
    """

    __slots__ = ("analysis", "document", "server")

    def __init__(
        self, document: Document, analysis: "Analysis", server: "KindslLanguageServer"
    ) -> None:
        self.document = document
        self.analysis = analysis
        self.server = server

    def offset(self, position: types.Position) -> int:
        """Return the code point that a client's position means."""
        return self.document.offset(position)

    @property
    def client(self) -> Client:
        """What the editor can do."""
        return self.server.client

    def show_warning(self, message: str) -> None:
        """Tell the user why something that they asked for was not done."""
        self.server.show_warning(message)

    def location(self, start: int, end: int) -> types.Location:
        """Return the client's place of a stretch of code points."""
        return types.Location(self.document.uri, self.range(start, end))

    def range(self, start: int, end: int) -> types.Range:
        """Return the client's range of a stretch of code points."""
        return self.document.range(start, end)
