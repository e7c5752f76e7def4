"""Changes between two documents, whole or broken, as far as both can be compared."""

from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.robots.comparison.difference import Difference
from kindsl.robots.comparison.partial_difference import document_difference, partial_difference
from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.mechanism.total_mass import total_mass

_SYNTAX = "KD0"


class Comparison(NamedTuple):
    """The result of a comparison.

    Attributes:
        difference: None if a document has no tree at all.
        notes: Parts left out, and why, one sentence each.
        is_of_whole: Whether both documents are whole.
        treeless: The number of the document, 0 or 1, that has no tree at all; else None.
    """

    difference: Difference | None
    notes: tuple[str, ...] = ()
    is_of_whole: bool = False
    treeless: int | None = None


def compared(old: Analysis | None, new: Analysis | None) -> Comparison:
    """Compare two documents; None stands for one that is not there, at most once."""
    sides = [None if a is None else (a.model, a.context.values) for a in (old, new)]
    documents = [side for side in sides if side is not None]
    whole = [skeleton for a in (old, new) if a is not None and (skeleton := _skeleton(a))]
    if len(whole) == len(sides):
        found, notes = document_difference(documents, whole)
        return Comparison(found, tuple(notes), is_of_whole=True)
    partial = partial_difference(*sides)
    if isinstance(partial, int):
        return Comparison(None, treeless=partial)
    return Comparison(*partial)


def _skeleton(analysis: Analysis) -> Linkage | None:
    if any(finding.code.startswith(_SYNTAX) for finding in analysis.findings):
        return None
    if not total_mass(analysis.model, analysis.context.values).is_whole:
        return None
    try:
        return analysis.skeleton()
    except (ModelError, UnboundParameterError):
        return None
