"""`kindsl.toml` as a document: its links, where it binds parameters, and its problems.

Of unused bindings, open robots are known by their parameters, those on disk by the words in them.
"""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from lsprotocol import types

from kindsl.frontends.lsp.session.findings import SOURCE, diagnostics
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.worker import Urgency
from kindsl.frontends.lsp.session.workspace import CONFIGURATION_FILES
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.protocol import RequestFailed
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.robots import robots_below
from kindsl.language.text.edits import TextEdit

if TYPE_CHECKING:
    from kindsl.frontends.lsp.session.view import View
    from kindsl.judgement.analysis.analysis import Analysis
    from kindsl.judgement.analysis.diagnostics import Diagnostic
    from kindsl.judgement.config.configuration import Configuration
    from kindsl.judgement.config.errors import ConfigurationProblem
    from kindsl.judgement.config.toml_places import KeyPath
    from kindsl.judgement.config.unused_bindings import Names

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


def _valid_configuration(document: Document) -> "Configuration | None":
    try:
        return configuration_of(document)
    except ConfigurationError:
        return None


def configuration_links(document: Document) -> Iterator[types.DocumentLink]:
    """Yield links to the documents that tables are for."""
    path, configuration = uris.path(document.uri), _valid_configuration(document)
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


def bound_places(view: "View", parameter: str) -> Iterator[BoundPlace]:
    """Yield where the configuration file of a document gives a parameter of it a value."""
    file = view.state.workspace.configuration_file(view.document)
    document = view.state.documents.get(uris.uri(file)) if file else None
    configuration = None if document is None else _valid_configuration(document)
    if document is None or configuration is None:
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


async def configuration_diagnostics(state: State, document: Document) -> list[dict[str, Any]]:
    """Return mistakes in a configuration file, else what it binds in vain, as they are sent."""
    problems = await state.worker.run(lambda: configuration_problems(document))
    if problems:
        return problems
    return diagnostics(
        document, await _unused_bindings(state, document), state.client.shows_in_diagnostics
    )


def configuration_problems(document: Document) -> list[dict[str, Any]]:
    """Return mistakes in a configuration file, as they are sent; none for other TOML files."""
    from kindsl.judgement.config.baseline import read_baseline

    try:
        configuration = configuration_of(document)
        if configuration is not None:
            read_baseline(configuration)
    except ConfigurationError as error:
        return shown_problems(document, error.problems)
    return []


def shown_problems(
    document: Document, problems: "Iterable[ConfigurationProblem]"
) -> list[dict[str, Any]]:
    """Return mistakes in a configuration file, as they are sent."""
    return [
        {
            "range": document.wire_range(problem.place.start, problem.place.end),
            "severity": types.DiagnosticSeverity.Error.value,
            "source": SOURCE,
            "message": problem.message,
        }
        for problem in problems
    ]


def names_in(analysis: "Analysis") -> "Names":
    """Return the names of a document's parameters and joints."""
    from kindsl.judgement.config.unused_bindings import Names

    model = analysis.model
    parameters = frozenset(str(parameter.name) for parameter in model.parameters)
    return Names(parameters, frozenset(str(joint.name) for joint in model.joints))


async def _unused_bindings(state: State, document: Document) -> "list[Diagnostic]":
    file = uris.path(document.uri)
    if file is None:
        return []
    settings = (await state.analyses.version(document)).settings
    used = await _names_in_open(state, file.parent)

    def others() -> Iterator[str]:
        for path in robots_below(file.parent):
            state.worker.checkpoint()
            yield str(path)

    def check() -> "list[Diagnostic]":
        from kindsl.judgement.config.unused_bindings import unreadable_twins, unused_bindings

        configuration = configuration_of(document)
        if configuration is None:
            return []

        unreadable = unreadable_twins(configuration, settings, state.workspace.may_read)
        return [*unused_bindings(configuration, settings, used, others()), *unreadable]

    return await state.worker.run(check, Urgency.DIAGNOSTICS)


async def _names_in_open(state: State, folder: Path) -> "dict[str, Names]":
    found = {}
    for robot in state.documents:
        path = uris.path(robot.uri)
        if path is not None and robot.is_robot and path.is_relative_to(folder):
            found[str(path)] = names_in(await state.analyses.of(robot))
    return found
