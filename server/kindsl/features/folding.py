"""What can be folded away: blocks, runs of comments."""

from collections.abc import Iterator
from typing import NamedTuple

from kindsl.analysis.analysis import Analysis
from kindsl.syntax.tree import Island, Node, Token

_BLOCKS = frozenset(
    ("base", "link", "joint", "inertia", "children", "frame_group", "frame", "joint_frame")
)
_HOLDERS = _BLOCKS | {"frames"}


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
    for island, start in zip(syntax.islands, syntax.starts, strict=False):
        found += [Fold(start + f.start, start + f.end, f.kind) for f in _island_folds(island)]
    found += _robot(analysis)
    return tuple(sorted(found))


def _island_folds(island: Island) -> tuple[Fold, ...]:
    known = island.facts.get("folds")
    if not isinstance(known, tuple):
        blocks = [fold for node in island.nodes for fold in _blocks(node)]
        found = [f for f in (*blocks, *_comments(island)) if _is_tall(island.text, f.start, f.end)]
        known = island.facts["folds"] = tuple(found)
    return known


def _blocks(node: Node) -> Iterator[Fold]:
    if node.kind in _BLOCKS:
        signs = [t for t in node.children if isinstance(t, Token) and not t.is_missing]
        opening = next((t for t in signs if t.kind == "{"), None)
        closing = next((t for t in signs if t.kind == "}"), None)
        if opening is not None and closing is not None:
            yield Fold(opening.end, closing.start, "block")
    for child in node.children:
        if child.kind in _HOLDERS and isinstance(child, Node):
            yield from _blocks(child)


def _comments(island: Island) -> Iterator[Fold]:
    """Yield block comments, and runs of comments with nothing but blanks between them."""
    start = end = -1
    for first, last in island.comments:
        if start >= 0 and not island.text[end:first].strip() and _is_tall(island.text, end, first):
            end = last
            continue
        if start >= 0:
            yield Fold(start, end, "comment")
        start, end = first, last
    if start >= 0:
        yield Fold(start, end, "comment")


def _robot(analysis: Analysis) -> Iterator[Fold]:
    syntax = analysis.syntax
    first, last = syntax.island(0), syntax.island(len(syntax) - 1)
    opening = next((t for t in _of(first.island, "head") if t.kind == "{"), None)
    closing = next((t for t in _of(last.island, "end") if t.kind == "}"), None)
    if opening is not None and closing is not None:
        yield Fold(first.start + opening.end, last.start + closing.start, "block")


def _of(island: Island, kind: str) -> Iterator[Token]:
    for node in island.nodes:
        if node.kind == kind:
            yield from (t for t in node.tokens() if not t.is_missing)


def _is_tall(text: str, start: int, end: int) -> bool:
    return "\n" in text[start:end] or "\r" in text[start:end]
