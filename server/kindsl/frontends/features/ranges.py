"""Foldable ranges, and the growing selections around an offset."""

from collections.abc import Iterator
from typing import NamedTuple

from kindsl.frontends.features.tree_path import path_at, tokens_touching
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.vocabulary import of_kind
from kindsl.language.text.facts import kept
from kindsl.language.text.span import Span

_BLOCKS = of_kind("block", "pose", "list", "groups", "group")


_OPENING = frozenset("{([<")


class Fold(NamedTuple):
    """A stretch to fold: a `block` between its braces, or a `comment` with its signs."""

    start: int
    end: int
    kind: str


def folds(analysis: Analysis) -> tuple[Fold, ...]:
    """Return the folds that span more than one line, in the order of the text."""
    syntax = analysis.syntax
    found: list[Fold] = []
    for island, start in zip(syntax.islands, syntax.starts, strict=True):
        found += [Fold(start + f.start, start + f.end, f.kind) for f in _island_folds(island)]
    found += _robot(analysis)
    return tuple(sorted(found))


@kept
def _island_folds(island: Island) -> list[Fold]:
    blocks = [fold for node in island.nodes for fold in _blocks(node)]
    return [f for f in (*blocks, *_comments(island)) if _is_tall(island.text[f.start : f.end])]


def _blocks(node: Node) -> Iterator[Fold]:
    signs = {t.kind: t for t in node.children if isinstance(t, Token) and not t.is_missing}
    if "{" in signs and "}" in signs:
        yield Fold(signs["{"].end, signs["}"].start, "block")
    for child in node.children:
        if child.kind in _BLOCKS and isinstance(child, Node):
            yield from _blocks(child)


def _comments(island: Island) -> Iterator[Fold]:
    runs: list[tuple[int, int]] = []
    for start, end in island.comments:
        between = island.text[runs[-1][1] : start] if runs else ""
        if _is_tall(between) and not between.strip():
            start, _ = runs.pop()
        runs.append((start, end))
    return (Fold(start, end, "comment") for start, end in runs)


def _robot(analysis: Analysis) -> Iterator[Fold]:
    syntax = analysis.syntax
    first, last = syntax.island(0), syntax.island(len(syntax) - 1)
    opening = next((t for t in _of(first.island, "head") if t.kind == "{"), None)
    closing = next(_of(last.island, "end"), None)
    if opening is not None and closing is not None:
        fold = Fold(first.start + opening.end, last.start + closing.start, "block")
        if _is_tall(analysis.text[fold.start : fold.end]):
            yield fold


def _of(island: Island, kind: str) -> Iterator[Token]:
    for node in island.nodes:
        if node.kind == kind:
            yield from (t for t in node.tokens() if not t.is_missing)


def _is_tall(text: str) -> bool:
    return "\n" in text or "\r" in text


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
