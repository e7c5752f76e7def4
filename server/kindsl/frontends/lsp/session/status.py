"""`kindsl/status`: one line about a robot for the editor's status bar."""

from collections.abc import Sized
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kindsl.judgement.analysis.analysis import Analysis

STATUS = "kindsl/status"

_BASE_FREEDOM = 6


def status_of(analysis: "Analysis", findings: Sized) -> dict[str, object]:
    """Return the number of findings, the degrees of freedom, None without a tree, and a word."""
    from kindsl.robots.mechanism.errors import ModelError
    from kindsl.robots.mechanism.numbering import numbered_by_id

    model = analysis.model
    try:
        edges = numbered_by_id(model)
    except ModelError:
        return {"findings": len(findings), "dof": None, "state": "broken model"}
    dof = len(edges) + (_BASE_FREEDOM if model.floating else 0)
    names = {str(parameter.name) for parameter in model.parameters}
    is_bound = names <= analysis.context.values.keys()
    state = "ready" if is_bound else "unbound parameters"
    return {"findings": len(findings), "dof": dof, "state": state}
