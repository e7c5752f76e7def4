"""Problems of documents that stand beside robots: configuration and transforms."""

from typing import TYPE_CHECKING, Any, NamedTuple

from kindsl.frontends.lsp.session.configuration_diagnostics import (
    configuration_diagnostics,
    names_in,
)
from kindsl.frontends.lsp.session.findings import diagnostics
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.transforms import transforms_diagnostics
from kindsl.frontends.lsp.text.document import Document

if TYPE_CHECKING:
    from kindsl.judgement.analysis.analysis import Analysis
    from kindsl.judgement.config.unused_bindings import Names


class Mentioned(NamedTuple):
    """The names of a robot that a companion may mention."""

    robot: str
    names: "Names"
    frames: frozenset[str]


def mentioned(analysis: "Analysis") -> Mentioned:
    """Return what a companion may mention of a robot."""
    from kindsl.language.semantics.transforms import frame_names

    model = analysis.model
    return Mentioned(str(model.name), names_in(analysis), frozenset(frame_names(model)))


async def companion_diagnostics(state: State, document: Document) -> list[dict[str, Any]]:
    """Return what is wrong with a companion as it is in the editor, as it is sent."""
    if document.is_toml:
        return await configuration_diagnostics(state, document)
    return diagnostics(
        document, await transforms_diagnostics(state, document), state.client.shows_in_diagnostics
    )
