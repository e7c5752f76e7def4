"""Put links in order: parents before children, as blocks and by number."""

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from kindsl.frontends.features.actions.action import REWRITE, CodeAction
from kindsl.frontends.features.tree_path import token_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.rules.renumbering import regular_order, renumbering
from kindsl.language.semantics.declarations import Link
from kindsl.language.syntax.vocabulary import BODIES
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.lines import newline_of

_WHERE = frozenset(("head", *BODIES))
_REST_OF_LINE = re.compile(r"(?:[ \t]*(?://[^\r\n]*|/\*(?:[^*\r\n]|\*(?!/))*\*/))*")


def sort_links(analysis: Analysis, start: int, _end: int) -> Iterator[CodeAction]:
    """Offer to sort, at the head of a link, if the links are not in order."""
    found = token_at(analysis.syntax, start)
    if found is None or not found.path or found.path[-1].kind not in _WHERE:
        return
    links, order = analysis.model.links, regular_order(analysis.model)
    if order is None or order == links or not _are_neighbours(analysis, links):
        return
    pieces = _pieces(analysis, links)
    text, newline = analysis.text, newline_of(analysis.text)
    # A piece may follow one that ends in a comment.
    apart = ("" if text[s : s + 1] in ("\n", "\r") else newline for s, _ in pieces)
    whole = (start + text[s:e] for start, (s, e) in zip(apart, pieces, strict=True))
    texts = dict(zip(links, whole, strict=True))
    edits = [
        TextEdit(s, e, texts[link])
        for (s, e), link in zip(pieces, order, strict=True)
        if texts[link] != text[s:e]
    ]
    end = pieces[-1][1]
    if text[end : end + 1] not in ("\r", "\n"):
        edits.append(TextEdit(end, end, newline))
    yield CodeAction("Sort the links, parents first", REWRITE, tuple(edits))


def _are_neighbours(analysis: Analysis, links: Sequence[Link]) -> bool:
    """Return whether the links are complete and nothing is between them."""
    islands = [analysis.syntax.island_at(analysis.resolver.span(link)[0]) for link in links]
    first = islands[0].index
    if first == 0 or [place.index for place in islands] != list(range(first, first + len(links))):
        return False
    return not any(place.island.problems or len(place.island.nodes) != 1 for place in islands[:-1])


def _pieces(analysis: Analysis, links: Sequence[Link]) -> list[tuple[int, int]]:
    """Return where each link with the comments above and beside it begins and ends."""
    first = analysis.syntax.island_at(analysis.resolver.span(links[0])[0]).index
    before = analysis.syntax.island(first - 1)
    ends = [_end_of_line(analysis.text, before.start + before.island.nodes[-1].end)]
    ends += [_end_of_line(analysis.text, analysis.resolver.span(link)[1]) for link in links]
    return list(pairwise(ends))


def _end_of_line(text: str, offset: int) -> int:
    rest = _REST_OF_LINE.match(text, offset)
    assert rest is not None
    return rest.end()


def renumber_links(analysis: Analysis, start: int, _end: int) -> Iterator[CodeAction]:
    """Offer to renumber, at the head of a link and at its id, if a number would change."""
    found = token_at(analysis.syntax, start)
    if found is None or not found.path or found.path[-1].kind not in (*_WHERE, "id"):
        return
    fix = renumbering(analysis.model)
    if fix is not None:
        yield CodeAction(fix.title, REWRITE, analysis.resolver.edits(fix))
