"""`kindsl.toml` as a document: its links, and where it binds parameters."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from lsprotocol import types

from kindsl.frontends.lsp.session.workspace import CONFIGURATION_FILES
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.protocol import RequestFailed
from kindsl.language.text.edits import TextEdit

if TYPE_CHECKING:
    from kindsl.frontends.lsp.session.view import View
    from kindsl.judgement.config.configuration import Configuration
    from kindsl.judgement.config.toml_places import KeyPath

_GLOB = frozenset("*?[")


class BoundPlace(NamedTuple):
    """The place where a configuration file gives a parameter a value, and by which keys."""

    document: Document
    keys: "KeyPath"
    start: int
    end: int


def configuration_of(document: Document) -> "Configuration | None":
    """Read the text of a configuration file; None for another TOML file.

    Raises:
        ConfigurationError: It says something wrong.
    """
    from kindsl.judgement.config import configuration_reading

    path = uris.path(document.uri)
    name = str(path) if path else uris.basename(document.uri)
    is_ours = uris.basename(document.uri) in CONFIGURATION_FILES
    return configuration_reading.configuration_of(name, document.text) if is_ours else None


def configuration_links(document: Document) -> list[types.DocumentLink]:
    """Return links to addresses in the comments, and to the documents that tables are for."""
    from kindsl.frontends.features.document_links import links_in_text

    links = [
        types.DocumentLink(document.range(link.start, link.end), link.target)
        for link in links_in_text(document.text)
    ]
    return [*links, *_document_links(document)]


def bound_places(view: "View", parameter: str) -> Iterator[BoundPlace]:
    """Yield where the configuration file of a document gives a parameter of it a value."""
    from kindsl.judgement.config.configuration import ConfigurationError

    file = view.state.workspace.configuration_file(view.document)
    document = view.state.documents.get(uris.uri(file)) if file else None
    if document is None:
        return
    try:
        configuration = configuration_of(document)
    except ConfigurationError:
        return
    if configuration is None:
        return
    for keys in configuration.keys_of(parameter, str(uris.path(view.document.uri))):
        yield BoundPlace(document, keys, *configuration.places[keys])


def rename_binding(place: BoundPlace, name: str) -> tuple[TextEdit, ...]:
    """Return the edits that give a bound parameter another name.

    Raises:
        RequestFailed: That name is bound already.
    """
    from kindsl.judgement.config.toml_edits import renaming_edits

    edits = renaming_edits(place.document.text, place.keys, name)
    if edits is None:
        file = uris.basename(place.document.uri)
        raise RequestFailed(f"{file} already gives a parameter '{name}' a value")
    return edits


def _document_links(document: Document) -> Iterator[types.DocumentLink]:
    from kindsl.judgement.config.configuration import ConfigurationError

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
            before, found, _ = document.text[place[1] :].partition(table.pattern)
            start = place[1] + len(before)
            if found:
                span = document.range(start, start + len(found))
                yield types.DocumentLink(span, uris.uri(target))
