"""All refactorings; each offers what makes sense at a range."""

from collections.abc import Callable, Iterator

from kindsl.features.action import CodeAction
from kindsl.features.refactor_add_sections import add_sections
from kindsl.features.refactor_extract_parameter import extract_parameter
from kindsl.features.refactor_inline_parameter import inline_parameter
from kindsl.features.refactor_move_inertia import move_inertia
from kindsl.features.refactor_renumber import renumber_links
from kindsl.features.refactor_sort_links import sort_links
from kindsl.rules.analysis import Analysis

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
