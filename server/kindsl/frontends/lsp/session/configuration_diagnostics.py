"""Problems of a configuration file as it is in the editor.

For bindings that nothing uses, open robots are known by their parameters, those on disk by the
words in them.
"""

from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lsprotocol import types

from kindsl.frontends.lsp.session.configuration_files import configuration_of
from kindsl.frontends.lsp.session.findings import SOURCE, diagnostics
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.worker import Urgency
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document
from kindsl.judgement.config.robots import robots_below

if TYPE_CHECKING:
    from kindsl.judgement.analysis.analysis import Analysis
    from kindsl.judgement.analysis.diagnostics import Diagnostic
    from kindsl.judgement.config.errors import ConfigurationProblem
    from kindsl.judgement.config.unused_bindings import Names


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
    from kindsl.judgement.config.configuration import ConfigurationError

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
    """Return what a configuration file, as it is in the editor, binds in vain."""
    file = uris.path(document.uri)
    if file is None:
        return []
    settings = await state.analyses.settings(document)
    used = await _names_in_open(state, file.parent)

    def others() -> "Iterator[tuple[str, Names]]":
        from kindsl.judgement.config.unused_bindings import words_of

        for path in robots_below(file.parent):
            state.worker.checkpoint()
            if str(path) not in used:
                with suppress(OSError):
                    yield str(path), words_of(path.read_text("utf-8", "replace"))

    def check() -> "list[Diagnostic]":
        from kindsl.judgement.config.unused_bindings import unused_bindings

        configuration = configuration_of(document)
        if configuration is None:
            return []
        from kindsl.judgement.config.unreadable_twins import unreadable_twins

        unreadable = unreadable_twins(configuration, settings, state.workspace.may_read)
        return [*unused_bindings(configuration, settings, used, others), *unreadable]

    return await state.worker.run(check, Urgency.DIAGNOSTICS)


async def _names_in_open(state: State, folder: Path) -> "dict[str, Names]":
    """Return the names in the robots below a folder that the editor shows, by path."""
    found = {}
    for robot in state.documents:
        path = uris.path(robot.uri)
        if path is not None and robot.is_robot and path.is_relative_to(folder):
            found[str(path)] = names_in(await state.analyses.of(robot))
    return found
