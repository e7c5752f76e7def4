"""A document as a row of tokens and comments, with the blanks between them left out."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Island, Node, Token

_LINE_END = re.compile(r"\r\n|\n|\r")


class Lexeme(NamedTuple):
    """A token or a comment.

    Attributes:
        start: Absolute offset.
        end: Absolute offset, without a comment's trailing blanks.
        kind: The token's kind; `//` or `/*` for comments.
        path: Kinds of the nodes that the token begins, outermost first.
        parent: Kind of the innermost node that holds it.
        lines_before: Line ends between the piece before and this one.
    """

    start: int
    end: int
    kind: str
    path: tuple[str, ...]
    parent: str
    lines_before: int


def pieces(document: SyntaxDocument) -> Iterator[Lexeme]:
    """Yield the tokens and comments of a document without problems, in order."""
    done = 0
    text = document.text
    for island, origin in zip(document.islands, document.starts, strict=True):
        for start, end, kind, path, parent in sorted(_in_island(island)):
            start, end = start + origin, end + origin
            yield Lexeme(start, end, kind, path, parent, len(_LINE_END.findall(text, done, start)))
            done = end


def _in_island(island: Island) -> Iterator[tuple[int, int, str, tuple[str, ...], str]]:
    for node in island.nodes:
        yield from _in_node(node, ())
    for start, end in island.comments:
        comment = island.text[start:end].rstrip()
        yield start, start + len(comment), comment[:2], (), ""


def _in_node(
    node: Node, outer: tuple[str, ...]
) -> Iterator[tuple[int, int, str, tuple[str, ...], str]]:
    """Yield the tokens below; the first carries the kinds of all nodes that begin with it."""
    path = (*outer, node.kind)
    for child in node.children:
        if isinstance(child, Token):
            yield child.start, child.end, child.kind, path, node.kind
        else:
            yield from _in_node(child, path)
        path = ()
