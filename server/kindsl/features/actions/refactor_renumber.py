"""Give the links regular numbers: 1 to n without gaps, parents before children."""

from collections.abc import Iterator

from kindsl.analysis.analysis import Analysis
from kindsl.features.actions.action import CodeAction
from kindsl.features.tree_path import token_at
from kindsl.rules.renumbering import renumbering
from kindsl.text.edits import TextEdit

_KIND = "refactor.rewrite"
_WHERE = frozenset(("head", "base", "link", "id"))


def renumber_links(analysis: Analysis, start: int, _end: int) -> Iterator[CodeAction]:
    """Offer to renumber, at the head of a link and at its id, if a number would change."""
    found = token_at(analysis.syntax, start)
    if found is None or not found.path or found.path[-1].kind not in _WHERE:
        return
    fix = renumbering(analysis.model)
    if fix is not None:
        edits = tuple(TextEdit(*analysis.resolver.span(c.at), c.text) for c in fix.changes)
        yield CodeAction(fix.title, _KIND, edits)
