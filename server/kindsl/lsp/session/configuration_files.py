"""`kindsl.toml` as a document: its links, and where it binds parameters."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from lsprotocol import types

from kindsl.lsp.session.workspace import CONFIGURATION_FILES
from kindsl.lsp.text import uris
from kindsl.lsp.text.document import Document
from kindsl.text.edits import TextEdit

if TYPE_CHECKING:
    from kindsl.config.configuration import Configuration
    from kindsl.lsp.session.view import View

_GLOB = frozenset("*?[")
_QUOTES = "\"'"


class BoundPlace(NamedTuple):
    """Where a configuration file gives a parameter a value."""

    document: Document
    start: int
    end: int


def configuration_of(document: Document) -> "Configuration | None":
    """Read the text of a configuration file; None for another TOML file.

    Raises:
        ConfigurationError: It says something wrong.
    """
    from kindsl.config import reading

    path = uris.path(document.uri)
    name = str(path) if path else uris.basename(document.uri)
    is_ours = uris.basename(document.uri) in CONFIGURATION_FILES
    return reading.configuration_of(name, document.text) if is_ours else None


def configuration_links(document: Document) -> list[types.DocumentLink]:
    """Return links to addresses in the comments, and to the documents that tables are for."""
    from kindsl.features.document_links import links_in_text

    links = [
        types.DocumentLink(document.range(link.start, link.end), link.target)
        for link in links_in_text(document.text)
    ]
    return [*links, *_document_links(document)]


def bound_places(view: "View", parameter: str) -> Iterator[BoundPlace]:
    """Yield where the configuration file of a document gives a parameter a value."""
    from kindsl.config.configuration import ConfigurationError

    file = view.state.workspace.configuration_file(view.document)
    document = view.state.documents.get(uris.uri(file)) if file else None
    if document is None:
        return
    try:
        configuration = configuration_of(document)
    except ConfigurationError:
        return
    for keys, (start, end) in configuration.places.items() if configuration else ():
        own = keys[len(configuration.root) :] if configuration else ()
        if own[-2:] == ("parameters", parameter) and len(own) in (2, 4):
            yield BoundPlace(document, start, end)


def rename_binding(place: BoundPlace, name: str) -> TextEdit:
    """Return the edit that gives a bound parameter another name, quoted if it was."""
    first = place.document.text[place.start : place.start + 1]
    quote = first if first in _QUOTES else "" if name.isascii() else '"'
    return TextEdit(place.start, place.end, f"{quote}{name}{quote}")


def _document_links(document: Document) -> Iterator[types.DocumentLink]:
    from kindsl.config.configuration import ConfigurationError

    path = uris.path(document.uri)
    try:
        configuration = configuration_of(document)
    except ConfigurationError:
        return
    if configuration is None or path is None:
        return
    for number, table in enumerate(configuration.documents):
        place = configuration.places.get((*configuration.root, "document", number, "path"))
        target = path.parent / table.pattern
        if place and not _GLOB & set(table.pattern) and target.is_file():
            text = document.text
            start = text.find(table.pattern, place[1])
            if start >= 0:
                span = document.range(start, start + len(table.pattern))
                yield types.DocumentLink(span, uris.uri(target))
