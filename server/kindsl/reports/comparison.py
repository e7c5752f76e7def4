"""What changed between two documents, whole or broken, as far as both can be compared."""

from typing import NamedTuple

from kindsl.analysis.analysis import Analysis
from kindsl.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanism.difference import Difference, difference
from kindsl.mechanism.errors import ModelError, UnboundParameterError
from kindsl.mechanism.partial_difference import partial_difference

_SYNTAX = "KD0"


class Comparison(NamedTuple):
    """What was found.

    Attributes:
        difference: None if a document has no tree at all.
        notes: What is left out and why, one sentence each.
        mechanics: Of both documents where both are whole, else None.
        treeless: The number of the document, 0 or 1, that has no tree at all; else None.
    """

    difference: Difference | None
    notes: tuple[str, ...] = ()
    mechanics: tuple[Mechanics, Mechanics] | None = None
    treeless: int | None = None


def compared(old: Analysis, new: Analysis) -> Comparison:
    """Compare two documents."""
    whole = _mechanics(old), _mechanics(new)
    if whole[0] is not None and whole[1] is not None:
        found = difference(whole[0].bodies, whole[1].bodies)
        return Comparison(found, mechanics=(whole[0], whole[1]))
    partial = partial_difference((old.model, old.context.values), (new.model, new.context.values))
    if isinstance(partial, int):
        return Comparison(None, treeless=partial)
    return Comparison(partial.difference, partial.notes)


def _mechanics(analysis: Analysis) -> Mechanics | None:
    if any(finding.code.startswith(_SYNTAX) for finding in analysis.findings):
        return None
    try:
        return analysis.mechanism()
    except (ModelError, UnboundParameterError):
        return None
