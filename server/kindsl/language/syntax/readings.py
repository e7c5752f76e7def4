"""Values that both generators read, and not as the same.

`1.0e3` is 1000 for robcogen2 and the product of 1.0 and a parameter `e3` for robcogen; `pi` is a
parameter for robcogen. What `2.0 - PI` looks like, a difference, no generator reads: robcogen takes
it for a product.
"""

import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

from kindsl.language.syntax.document import Chunk, SyntaxDocument
from kindsl.language.syntax.portability import ROBCOGEN, ROBCOGEN2
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.value_forms import formed_values, is_signed_product
from kindsl.language.syntax.vocabulary import VALUE_HOLDERS
from kindsl.language.text.facts import Fact, kept

_POWER = r"([-+]?[0-9]*\.[0-9]+)([eE][0-9]+)"
_Rewrite = Callable[[Node, bool], Node | None]
_AS_READ: "Fact[dict[_Rewrite, Island]]" = Fact("as read")


class TwoReadings(NamedTuple):
    """A value that means something else to one generator than to the other, or than it looks like.

    Attributes:
        kind: `power`, `product` or `pi`.
        other: The reading of robcogen2, or of a person.
    """

    start: int
    end: int
    kind: str
    text: str
    robcogen: str
    other: str


_READINGS = Fact[tuple[TwoReadings, ...]]("two readings")


def two_readings(island: Island) -> tuple[TwoReadings, ...]:
    """Return the values of an island that are read in two ways; kept with the island."""
    known = island.facts.get(_READINGS)
    if known is None:
        known = island.facts.keep(_READINGS, tuple(_read_in_two_ways(island)))
    return known


def as_read_for(document: SyntaxDocument, targets: frozenset[str]) -> SyntaxDocument:
    """Return a document with the values as its targets read them.

    For robcogen alone `1.0e3` and `pi` have parameters in them. Where the targets do not decide
    what `1.0e3` is, it is a node `undecided`, which has no value.
    """
    if targets == {ROBCOGEN2}:
        return document
    if not any(map(_is_read_in_two_ways, document.chunks)):
        return document
    rewrite = _for_robcogen if targets == {ROBCOGEN} else _undecided
    chunks = tuple(_chunk_as_read(chunk, rewrite) for chunk in document.chunks)
    return SyntaxDocument(chunks, document.versions)


@kept
def _is_read_in_two_ways(chunk: Chunk) -> bool:
    return any(map(two_readings, chunk.islands))


def _chunk_as_read(chunk: Chunk, rewrite: _Rewrite) -> Chunk:
    if not _is_read_in_two_ways(chunk):
        return chunk
    return Chunk(tuple(_island_as_read(island, rewrite) for island in chunk.islands))


def _island_as_read(island: Island, rewrite: _Rewrite) -> Island:
    found = two_readings(island)
    if not found:
        return island
    as_read = island.facts.get(_AS_READ) or island.facts.keep(_AS_READ, {})
    known = as_read.get(rewrite)
    if known is None:
        known = as_read[rewrite] = _rewritten_island(island, rewrite)
        known.facts.keep(_READINGS, found)
    return known


def _rewritten_island(island: Island, rewrite: _Rewrite) -> Island:
    nodes = tuple(_rewritten(node, rewrite) for node in island.nodes)
    tokens = [*island.skipped]
    for node in nodes:
        tokens += node.tokens()
    tokens.sort(key=lambda token: (token.start, token.end))
    return Island(
        island.text, nodes, tuple(tokens), island.skipped, island.comments, island.problems
    )


def _rewritten(node: Node, rewrite: _Rewrite, is_value: bool = False) -> Node:
    new = rewrite(node, is_value)
    if new is not None:
        return new
    holds = node.kind in VALUE_HOLDERS
    children = [
        _rewritten(child, rewrite, holds) if isinstance(child, Node) else child
        for child in node.children
    ]
    if all(new is old for new, old in zip(children, node.children, strict=True)):
        return node
    return Node(node.kind, children)


def _undecided(node: Node, is_value: bool) -> Node | None:
    return Node("undecided", node.children) if is_value and _power(node) else None


def _for_robcogen(node: Node, is_value: bool) -> Node | None:
    first, last = node.children[0], node.children[-1]
    if not (isinstance(first, Token) and isinstance(last, Token)):
        return None
    if last.kind == "LOWER_PI" and node.kind in ("pi", "juxtaposed_pi"):
        name = Token("NAME", last.text, last.lead, last.start, last.end)
        kind = "parameter" if first is last else "juxtaposed_parameter"
        return Node(kind, [name] if first is last else [first, name])
    # Within an expression robcogen refuses `1.0e3`.
    power = _power(node) if is_value else None
    if power is None:
        return None
    middle = first.start + power.end(1)
    factor = Token("FLOAT", power[1], first.lead, first.start, middle)
    name = Token("NAME", power[2], middle, middle, first.end)
    return Node("juxtaposed_parameter", [factor, name])


def _power(node: Node) -> re.Match[str] | None:
    token = node.children[0]
    if node.kind != "number" or not isinstance(token, Token) or token.kind != "POWER_FLOAT":
        return None
    return re.fullmatch(_POWER, token.text)


def _read_in_two_ways(island: Island) -> Iterator[TwoReadings]:
    for node in formed_values(island):
        start, end = node.start, node.end
        written = island.text[start:end]
        power = _power(node)
        if power is not None:
            meaning = f"{power[1]} times a parameter '{power[2]}'"
            yield TwoReadings(start, end, "power", written, meaning, f"{float(written):.15g}")
        elif is_signed_product(node):
            left, _, right = (island.text[c.start : c.end] for c in node.children)
            meaning = f"the product of {left} and -{right}"
            yield TwoReadings(start, end, "product", written, meaning, "a difference")
        else:
            for token in node.tokens():
                if token.kind == "LOWER_PI":
                    meaning = f"a parameter '{token.text}'"
                    yield TwoReadings(
                        token.start, token.end, "pi", token.text, meaning, "the number pi"
                    )
