"""The documents that the editor shows, at their latest version, and files as they are on disk."""

from collections.abc import Callable, Iterator
from pathlib import Path

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document, document
from kindsl.language.text.encodings import decoded
from kindsl.language.text.saves import Stamp, stamp

# An editor takes it off and puts it back; in the text that it shows it does not count.
_BOM = "\ufeff"


class Documents:
    """Open documents by URI; listeners hear of each that opens, changes or closes.

    They are called with the latest version.

    Attributes:
        encoding: How the client counts columns.
    """

    __slots__ = ("_files", "_open", "encoding", "on_change", "on_close", "on_open")

    def __init__(self) -> None:
        self._open: dict[str, Document] = {}
        self._files: dict[Path, tuple[Stamp | None, Document]] = {}
        self.encoding: str = types.PositionEncodingKind.Utf16
        self.on_open: list[Callable[[Document], None]] = []
        self.on_change: list[Callable[[Document], None]] = []
        self.on_close: list[Callable[[Document], None]] = []

    def open(self, item: types.TextDocumentItem) -> None:
        """Follow a document from now on."""
        opened = document(item.uri, item.version, item.text, self.encoding)
        self._open[uris.key(item.uri)] = opened
        for listener in self.on_open:
            listener(opened)

    def change(self, params: types.DidChangeTextDocumentParams) -> None:
        """Make the changes of one notification, all at once.

        Raises:
            JsonRpcInvalidParams: The document is not open.
        """
        key = uris.key(params.text_document.uri)
        if key not in self._open:
            raise JsonRpcInvalidParams(f"'{params.text_document.uri}' is not open")
        version = params.text_document.version
        if not params.content_changes:
            return
        changed = self._open[key].changed(params.content_changes, version)
        self._open[key] = changed
        for listener in self.on_change:
            listener(changed)

    def close(self, uri: str) -> None:
        """Follow a document no longer."""
        closed = self._open.pop(uris.key(uri), None)
        if closed is not None:
            for listener in self.on_close:
                listener(closed)

    def get(self, uri: str) -> Document | None:
        """Return the latest version: what the editor shows, else what the file holds."""
        return self._open.get(uris.key(uri)) or self.read(uri)

    def is_current(self, document: Document) -> bool:
        """Return whether the editor shows that very version."""
        return self._open.get(uris.key(document.uri)) is document

    def is_open(self, uri: str) -> bool:
        """Return whether the editor shows it."""
        return uris.key(uri) in self._open

    def __iter__(self) -> Iterator[Document]:
        return iter(tuple(self._open.values()))

    def read(self, uri: str) -> Document | None:
        """Return a file as a document, read again only when it has changed; None without one."""
        path = uris.path(uri)
        if path is None:
            return None
        try:
            present = stamp(str(path))
            known = self._files.get(path)
            if known is None or known[0] != present:
                text = decoded(path.read_bytes()).removeprefix(_BOM)
                if known is None or known[1].text != text:
                    known = (present, document(uri, None, text, self.encoding))
                known = self._files[path] = (present, known[1])
        except OSError:
            self._files.pop(path, None)
            return None
        return known[1]
