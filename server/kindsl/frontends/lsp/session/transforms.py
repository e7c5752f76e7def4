"""Transforms documents in the editor, and the robots that they are about."""

from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.view import Sight
from kindsl.frontends.lsp.session.worker import Urgency
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kindsl.judgement.analysis.diagnostics import Diagnostic
    from kindsl.language.semantics.model import Model


class TransformsView(Sight):
    """One version of a transforms document.

    Attributes:
        model: The robot that it is about, None where that is not known.
    """

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


async def transforms_diagnostics(state: State, document: Document) -> "Sequence[Diagnostic]":
    """Return what is wrong with a transforms document as it is in the editor."""
    from kindsl.judgement.analysis.known_findings import lines_of, set_apart
    from kindsl.judgement.analysis.transforms_findings import transforms_findings

    view = await transforms_view(state, document)
    settings = await state.analyses.settings(document)
    check = lambda: transforms_findings(document.text, view.model, settings)  # noqa: E731
    found = await state.worker.run(check, Urgency.DIAGNOSTICS)
    return set_apart(found, lines_of(document.text), settings).told


def _robot_beside(state: State, document: Document) -> Document | None:
    from kindsl.judgement.analysis.analysis import analyse
    from kindsl.judgement.config.beside import robot_beside
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
