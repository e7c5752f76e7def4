"""`kindsl/status`: one line about a robot for the editor's status bar."""

from typing import TYPE_CHECKING

from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.worker import Urgency
from kindsl.frontends.lsp.text.document import Document

if TYPE_CHECKING:
    from kindsl.judgement.analysis.analysis import Analysis
    from kindsl.judgement.analysis.diagnostics import Diagnostic

METHOD = "kindsl/status"

_BASE_FREEDOM = 6


async def tell_status(state: State, document: Document, findings: "tuple[Diagnostic, ...]") -> None:
    """Send a status to a client that listens to it."""
    if state.client.announces(METHOD):
        analysis = await state.analyses.of(document)
        status = await state.worker.run(lambda: _status(analysis), Urgency.DIAGNOSTICS)
        found = {"uri": document.uri, "findings": len(findings)}
        state.editor.protocol.notify(METHOD, found | status)


def _status(analysis: "Analysis") -> dict[str, object]:
    """Return the degrees of freedom, None for a broken model, and a word for the user."""
    from kindsl.robots.mechanism.errors import ModelError
    from kindsl.robots.mechanism.numbering import numbered_by_id

    model = analysis.model
    try:
        edges = numbered_by_id(model)
    except ModelError:
        return {"dof": None, "state": "broken model"}
    dof = len(edges) + (_BASE_FREEDOM if model.floating else 0)
    names = {str(parameter.name) for parameter in model.parameters}
    is_bound = names <= analysis.context.values.keys()
    return {"dof": dof, "state": "ready" if is_bound else "unbound parameters"}
