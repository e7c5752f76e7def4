"""The growing selections around an offset: word, value, vector, section, block, robot, document."""

from collections.abc import Iterator

from kindsl.frontends.features.tree_path import path_at, tokens_touching
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.syntax.tree import Node
from kindsl.language.text.span import Span

_OPENING = frozenset("{([<")


def selection_ranges(analysis: Analysis, offset: int) -> tuple[Span, ...]:
    """Return spans that hold the offset, the smallest first, each inside the next."""
    offset = min(max(offset, 0), analysis.syntax.length)
    place = analysis.syntax.island_at(offset)
    local = offset - place.start
    found = [Span(t.start, t.end) for t in tokens_touching(place.island, local)[-1:]]
    found += [Span(*comment) for comment in place.island.comments]
    for node in reversed(path_at(place.island, local)):
        found += _inside(node)
        found.append(Span(node.start, node.end))
    spans = [Span(place.start + s.start, place.start + s.end) for s in found]
    return _nested((*spans, Span(0, analysis.syntax.length)), offset)


def _inside(node: Node) -> Iterator[Span]:
    """Yield what lies between a construct's brackets."""
    opening = next((child for child in node.children if child.kind in _OPENING), None)
    if opening is not None:
        inner = [child for child in node.children if child.start >= opening.start][1:-1]
        if inner:
            yield Span(inner[0].start, inner[-1].end)


def _nested(spans: tuple[Span, ...], offset: int) -> tuple[Span, ...]:
    nested: list[Span] = []
    for span in sorted(spans, key=lambda s: s.end - s.start):
        if not span.start <= offset <= span.end:
            continue
        if not nested or (
            span != nested[-1] and span.start <= nested[-1].start and nested[-1].end <= span.end
        ):
            nested.append(span)
    return tuple(nested)
