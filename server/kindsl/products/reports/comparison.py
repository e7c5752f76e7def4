"""Changes between two documents, whole or broken, as far as both can be compared."""

from collections.abc import Callable
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.model import Model
from kindsl.robots.comparison.difference import Difference, difference
from kindsl.robots.comparison.partial_difference import added, partial_difference, removed
from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError
from kindsl.robots.mechanism.skeleton import Skeleton
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
    if old is None:
        assert new is not None, "there is a document to compare"
        return _of_one(new, added, 1)
    if new is None:
        return _of_one(old, removed, 0)
    whole = _skeleton(old), _skeleton(new)
    if whole[0] is not None and whole[1] is not None:
        return Comparison(difference(whole[0], whole[1]), is_of_whole=True)
    partial = partial_difference((old.model, old.context.values), (new.model, new.context.values))
    if isinstance(partial, int):
        return Comparison(None, treeless=partial)
    return Comparison(partial.difference, partial.notes)


def _of_one(
    analysis: Analysis, told: Callable[[Difference, Model], Difference], number: int
) -> Comparison:
    """Return the difference of a document to nothing."""
    document = analysis.model, analysis.context.values
    same = partial_difference(document, document)
    if isinstance(same, int):
        return Comparison(None, treeless=number)
    return Comparison(told(same.difference, analysis.model), same.notes)


def _skeleton(analysis: Analysis) -> Skeleton | None:
    if any(finding.code.startswith(_SYNTAX) for finding in analysis.findings):
        return None
    if not total_mass(analysis.model, analysis.context.values).is_whole:
        return None
    try:
        return analysis.skeleton()
    except (ModelError, UnboundParameterError):
        return None
