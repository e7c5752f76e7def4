"""The generators that take a value, by the grammar's rule `value`."""

from collections.abc import Sequence
from functools import lru_cache

from kindsl.language.syntax.builder import build
from kindsl.language.syntax.scanner import word_kind
from kindsl.language.syntax.tables import NEITHER, ONLY
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.vocabulary import NAMES, VALUE_HOLDERS
from kindsl.language.text.facts import kept

TARGETS_OF_ALL = frozenset({"robcogen", "robcogen2"})

_LONGEST = 12
_MOST_KNOWN = 4096


def accepted_by(tokens: Sequence[Token]) -> frozenset[str]:
    """Return the targets that take an expression of these tokens.

    An integer that stands where both targets need a decimal point is taken by none.
    """
    return kinds_accepted_by(tuple(form_kind(token) for token in tokens))


@lru_cache(_MOST_KNOWN)
def kinds_accepted_by(kinds: tuple[str, ...]) -> frozenset[str]:
    """Return the targets that take an expression of tokens of these kinds.

    They are those that no rule and no terminal on the way excludes.
    """
    built = build([Token(kind, "", 0, 0, 0) for kind in kinds[:_LONGEST]], "value")
    if built.node is None or built.read < len(kinds):
        return frozenset()
    parts: list[Node | Token] = [built.node]
    targets = TARGETS_OF_ALL
    for part in parts:
        targets &= targets_of(part.kind)
        parts += part.children if isinstance(part, Node) else ()
    return targets


def form_kind(token: Token) -> str:
    """Return the grammar's terminal for a token of an expression, names by their spelling."""
    if token.kind != "NAME":
        return token.kind
    if token.text.startswith("^"):
        return "ESCAPED_NAME"
    kind = word_kind(token.text)
    return kind if kind in NAMES else "KEYWORD_NAME"


@kept
def formed_values(island: Island) -> list[Node]:
    """Return the values of an island that are more than a decimal, in order; kept with it."""
    found: list[Node] = []
    pending = [*island.nodes]
    for node in pending:
        nodes = found if node.kind in VALUE_HOLDERS else pending
        for child in node.children:
            if child.__class__ is Node and not (nodes is found and is_decimal(child)):
                nodes.append(child)
    found.sort(key=lambda node: node.start)
    return found


def is_decimal(value: Node) -> bool:
    """Return whether a value is a decimal number and nothing else."""
    return value.kind == "number" and value.children[0].kind == "FLOAT"


def is_signed_product(node: Node) -> bool:
    """Return whether an expression is `2.0 - PI`, which robcogen takes for 2.0 times -PI."""
    if node.kind != "subtract":
        return False
    left, _, right = node.children
    if not (isinstance(left, Node) and isinstance(right, Node) and left.kind == "number"):
        return False
    return left.children[0].kind == "FLOAT" and right.kind in ("pi", "parameter")


def targets_of(name: str) -> frozenset[str]:
    """Return the targets that take a construct, a form of a value or a terminal as such."""
    if name in NEITHER:
        return frozenset()
    return frozenset({ONLY[name]}) if name in ONLY else TARGETS_OF_ALL
