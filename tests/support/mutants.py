"""Documents with one mistake, and what must be left of them."""

import random
from collections.abc import Iterator
from typing import NamedTuple

from kindsl.language.syntax.document import SyntaxDocument, parse
from kindsl.language.syntax.tree import Node, Token

_WORDS = ["@", "#", "foo", '"x"', ";", "1.5", "-", "Link", "chidren"]


class Mutant(NamedTuple):
    """A document with one mistake.

    Attributes:
        kind: `delete`, `duplicate`, `substitute`, `brace` or `truncate`.
        text: The document.
        offset: Where the mistake is.
        touched: Names of the blocks that the mistake lies in.
    """

    kind: str
    text: str
    offset: int
    touched: frozenset[str]


def mutants(text: str, seed: int = 5, substitutions: int = 300) -> Iterator[Mutant]:
    """Yield the document with every token deleted and doubled, some replaced, cut at each line."""
    document = parse(text)
    tokens = _tokens(document)
    spans = _block_spans(document)
    for start, end, word in tokens:
        touched = _touched(spans, start)
        yield Mutant("delete", text[:start] + text[end:], start, touched)
        yield Mutant("duplicate", f"{text[:end]} {word}{text[end:]}", end, touched)
        if word in "{}":
            yield Mutant("brace", text[:start] + text[end:], start, touched)
    generator = random.Random(seed)
    words = sorted({word for _, _, word in tokens}) + _WORDS
    for _ in range(substitutions):
        start, end, word = generator.choice(tokens)
        new = generator.choice([other for other in words if other != word])
        yield Mutant("substitute", text[:start] + new + text[end:], start, _touched(spans, start))
    position = 0
    for line in text.splitlines(keepends=True):
        if position:
            touched = frozenset(name for _, end, name in spans if end > position)
            yield Mutant("truncate", text[:position], position, touched)
        position += len(line)


def lumps(text: str, generator: random.Random) -> Iterator[Mutant]:
    """Yield without end the document with up to four neighbouring tokens lost, doubled or swapped.

    Or with one token that became a bracket.
    """
    document = parse(text)
    tokens = _tokens(document)
    spans = _block_spans(document)
    while True:
        kind = generator.choice(("lose", "lose", "double", "swap", "bracket"))
        count = 1 if kind == "bracket" else generator.randint(2, 4)
        first = generator.randrange(len(tokens) - count)
        lump = tokens[first : first + count]
        start, end = lump[0][0], lump[-1][1]
        cut = lump[generator.randrange(count)][0]
        new = {
            "lose": "",
            "double": f"{text[start:end]} {text[start:end]}",
            "swap": f"{text[cut:end]} {text[start:cut]}",
            "bracket": generator.choice("{}()[]"),
        }[kind]
        yield Mutant(kind, text[:start] + new + text[end:], start, _touched(spans, start))


def links_and_joints(document: SyntaxDocument) -> dict[str, object]:
    """Return the edges of each base and link by its name, and the kind of each joint."""
    found: dict[str, object] = {}
    for island in document.islands:
        for node in island.nodes:
            if node.kind in ("base", "link"):
                found.setdefault(_text(node, 1), _edges(node))
            elif node.kind == "joint":
                found.setdefault(_text(node, 1), _text(node, 0))
    return found


def messages(document: SyntaxDocument) -> list[tuple[int, str, str]]:
    """Return offset, code and message of all that is wrong, in order."""
    found = [
        (start + problem.start, problem.code, problem.message)
        for start, island in zip(document.starts, document.islands, strict=True)
        for problem in island.problems
    ]
    found += [
        (
            document.starts[placed.number] + placed.problem.start,
            placed.problem.code,
            placed.problem.message,
        )
        for placed in document.problems
    ]
    return sorted(found)


def _edges(node: Node) -> list[tuple[str, str]]:
    return [
        (_text(child, 0), _text(child, 2))
        for children in node.nodes("children")
        for child in children.nodes("child")
    ]


def _text(node: Node, index: int) -> str:
    token = node.children[index]
    return token.text if isinstance(token, Token) else ""


def _tokens(document: SyntaxDocument) -> list[tuple[int, int, str]]:
    return [
        (start + token.start, start + token.end, token.text)
        for start, island in zip(document.starts, document.islands, strict=True)
        for token in island.tokens
    ]


def _block_spans(document: SyntaxDocument) -> list[tuple[int, int, str]]:
    return [
        (start + node.start, start + node.end, _text(node, 1))
        for start, island in zip(document.starts, document.islands, strict=True)
        for node in island.nodes
        if node.kind in ("base", "link", "joint")
    ]


def _touched(spans: list[tuple[int, int, str]], offset: int) -> frozenset[str]:
    return frozenset(name for start, end, name in spans if start <= offset < end)
