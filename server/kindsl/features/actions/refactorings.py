"""All refactorings; each offers what makes sense at a range."""

from collections.abc import Callable, Iterator

from kindsl.analysis.analysis import Analysis
from kindsl.features.actions.action import CodeAction
from kindsl.features.actions.add_sections import add_sections
from kindsl.features.actions.extract_parameter import extract_parameter
from kindsl.features.actions.inline_parameter import inline_parameter
from kindsl.features.actions.move_inertia import move_inertia
from kindsl.features.actions.refactor_renumber import renumber_links
from kindsl.features.actions.sort_links import sort_links

_REFACTORINGS: tuple[Callable[[Analysis, int, int], Iterator[CodeAction]], ...] = (
    extract_parameter,
    inline_parameter,
    move_inertia,
    add_sections,
    renumber_links,
    sort_links,
)


def refactorings(analysis: Analysis, start: int, end: int) -> tuple[CodeAction, ...]:
    """Return the refactorings that make sense at a range."""
    return tuple(action for offer in _REFACTORINGS for action in offer(analysis, start, end))
