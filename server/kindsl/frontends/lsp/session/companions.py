"""Documents beside robots: transforms with the robot that they are about, configuration."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

from kindsl.frontends.lsp.session.configuration_files import configuration_diagnostics, names_in
from kindsl.frontends.lsp.session.findings import diagnostics
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.view import Sight
from kindsl.frontends.lsp.session.worker import Urgency
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kindsl.judgement.analysis.analysis import Analysis
    from kindsl.judgement.analysis.diagnostics import Diagnostic
    from kindsl.language.semantics.model import Model


class TransformsView(Sight):
    """One version of a transforms document; the model is None where no robot is known for it."""

    __slots__ = ("model",)

    def __init__(self, document: Document, model: "Model | None", state: State) -> None:
        super().__init__(document, state)
        self.model = model


async def transforms_view(state: State, document: Document) -> TransformsView:
    """Return a transforms document with the robot beside it, as the editor shows it."""
    robot = await state.worker.run(lambda: _robot_beside(state, document))
    if robot is None:
        return TransformsView(document, None, state)
    return TransformsView(document, (await state.analyses.of(robot)).model, state)


def mentioned(analysis: "Analysis") -> object:
    """Return what a companion may mention of a robot, to compare it."""
    from kindsl.language.semantics.transforms import frame_names

    model = analysis.model
    return str(model.name), names_in(analysis), frozenset(frame_names(model))


async def companion_diagnostics(state: State, document: Document) -> list[dict[str, Any]]:
    """Return what is wrong with a companion as it is in the editor, as it is sent."""
    if document.is_toml:
        return await configuration_diagnostics(state, document)
    found = await _transforms_diagnostics(state, document)
    return diagnostics(document, found, state.client.shows_in_diagnostics)


async def _transforms_diagnostics(state: State, document: Document) -> "Sequence[Diagnostic]":
    from kindsl.judgement.analysis.known_findings import lines_of, set_apart
    from kindsl.judgement.analysis.transforms_findings import transforms_findings

    view = await transforms_view(state, document)
    settings = (await state.analyses.version(document)).settings
    check = lambda: transforms_findings(document.text, view.model, settings)  # noqa: E731
    found = await state.worker.run(check, Urgency.DIAGNOSTICS)
    return set_apart(found, lines_of(document.text), settings).reported


def _robot_beside(state: State, document: Document) -> Document | None:
    from kindsl.judgement.analysis.analysis import analyse
    from kindsl.judgement.config.robots import robot_beside
    from kindsl.language.syntax.transforms_text import read_transforms

    def name_of(file: str) -> str | None:
        robot = state.documents.get(uris.uri(Path(file)))
        return str(analyse(robot.text).model.name) if robot is not None else None

    path = uris.path(document.uri)
    if path is None:
        return None
    robot = read_transforms(document.text).robot
    file = robot_beside(str(path), robot.text if robot is not None else None, name_of)
    return state.documents.get(uris.uri(Path(file))) if file is not None else None
