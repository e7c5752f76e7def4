"""The token at an offset, and the constructs that hold it."""

from bisect import bisect_right
from collections.abc import Callable, Sequence
from itertools import takewhile
from typing import NamedTuple

from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Island, Node, Token


class TokenAt(NamedTuple):
    """A token and where it stands.

    Attributes:
        origin: The island's absolute offset.
        path: The constructs that hold it, the outermost first; empty for a skipped token.
    """

    token: Token
    island: Island
    origin: int
    path: tuple[Node, ...]

    @property
    def start(self) -> int:
        """Absolute start of the token."""
        return self.origin + self.token.start

    @property
    def end(self) -> int:
        """Absolute end of the token."""
        return self.origin + self.token.end


def token_at(syntax: SyntaxDocument, offset: int) -> TokenAt | None:
    """Return the token that an offset touches; of two neighbours the word, then the second."""
    place = syntax.island_at(offset)
    local = min(max(offset, 0), syntax.length) - place.start
    touching = tokens_touching(place.island, local)
    if not touching:
        return None
    token = next((t for t in reversed(touching) if is_word(t)), touching[-1])
    return TokenAt(token, place.island, place.start, path_to(place.island, token))


def tokens_touching(island: Island, local: int) -> list[Token]:
    """Return the tokens, missing ones left out, that an offset of the island lies in or beside."""
    before = reversed(island.tokens[: index_after(island, local)])
    touching = takewhile(lambda token: token.end >= local, before)
    return [token for token in touching if not token.is_missing][::-1]


def index_after(island: Island, local: int) -> int:
    """Return the index of the first token that begins behind an offset of the island."""
    return bisect_right(island.tokens, local, key=lambda token: token.start)


def path_to(island: Island, token: Token) -> tuple[Node, ...]:
    """Return the constructs that hold a token, the outermost first."""
    path = _path(island, lambda node: node.start <= token.start and token.end <= node.end)
    return path if path and any(child is token for child in path[-1].children) else ()


def path_at(island: Island, local: int) -> tuple[Node, ...]:
    """Return the constructs around an offset of the island, the outermost first.

    An offset at a construct's edge lies in it, unless a neighbour begins there.
    """
    return _path(island, lambda node: node.start <= local <= node.end)


def _path(island: Island, holds: Callable[[Node], bool]) -> tuple[Node, ...]:
    """Return the last constructs that hold something, each in the one before it."""
    path: list[Node] = []
    row: Sequence[Node | Token] = island.nodes
    while True:
        around = (c for c in reversed(row) if isinstance(c, Node) and c.children and holds(c))
        node = next(around, None)
        if node is None:
            return tuple(path)
        path.append(node)
        row = node.children


def is_word(token: Token) -> bool:
    """Return whether a token is a name, a keyword or a number, not a sign."""
    first = token.text[:1]
    return first.isalnum() or first in ("_", "^") or token.text[-1:].isdigit()
