"""Foldable ranges: blocks, runs of comments."""

from collections.abc import Iterator
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.vocabulary import of_kind
from kindsl.language.text.facts import kept

_BLOCKS = of_kind("block", "pose", "list", "groups", "group")


class Fold(NamedTuple):
    """A stretch to fold, from the opening sign to the closing one.

    Attributes:
        start: Offset after `{`, or the start of a comment.
        end: Offset of `}`, or the end of a comment.
        kind: `block` or `comment`.
    """

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
    """Yield block comments, and runs of comments with nothing but blanks between them."""
    runs: list[tuple[int, int]] = []
    for start, end in island.comments:
        if runs and _is_blank(island.text[runs[-1][1] : start]):
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


def _is_blank(text: str) -> bool:
    return not text.strip() and _is_tall(text)


def _is_tall(text: str) -> bool:
    return "\n" in text or "\r" in text
