"""Values of expressions: one walk over the forms of the grammar, with any kind of numbers."""

import math
import operator
from collections.abc import Callable, Mapping
from typing import Generic, NamedTuple, TypeVar, cast

from kindsl.language.syntax.tree import Node, Token
from kindsl.language.syntax.value_forms import is_signed_product

T = TypeVar("T")


class Arithmetic(NamedTuple, Generic[T]):
    """Operations on some kind of numbers; what has no value is None.

    Attributes:
        number: Reads a decimal number as written.
        operations: Sums, differences, products and quotients by the forms of the grammar.
    """

    number: Callable[[str], T]
    pi: T
    negate: Callable[[T], T]
    operations: Mapping[str, Callable[[T, T], T | None]]


def number_of(token: Node | Token) -> float | None:
    """Return the value of a number token, or None if it is none (`0x10`, missing)."""
    try:
        return float(cast(Token, token).text)
    except ValueError:
        return None


def name_token(node: Node) -> Token | None:
    """Return the name directly in a node, None where there is none."""
    return cast(Token | None, next((c for c in node.children if c.kind == "NAME"), None))


def name_of(node: Node) -> str:
    """Return the text of the name directly in a node, empty where there is none."""
    token = name_token(node)
    return "" if token is None else token.text.lstrip("^")


def evaluate(node: Node, names: Mapping[str, T], by: Arithmetic[T]) -> T | None:
    """Return the value of an expression, None where a name is unbound or nothing is defined.

    Args:
        names: Values of parameters by name, and of constants by `<name>`.
    """
    if is_signed_product(node):
        left, right = (_value(cast(Node, child), names, by) for child in node.children[::2])
        product = _applied(by.operations["multiply"], left, right)
        return None if product is None else by.negate(product)
    return _value(node, names, by)


def _value(node: Node, names: Mapping[str, T], by: Arithmetic[T]) -> T | None:
    kind, first = node.kind, node.children[0]
    if kind == "number":
        return _number(first, by)
    if kind == "pi":
        return by.pi
    if kind == "juxtaposed_pi":
        return _applied(by.operations["multiply"], _number(first, by), by.pi)
    if kind == "juxtaposed_parameter":
        return _applied(by.operations["multiply"], _number(first, by), names.get(name_of(node)))
    if kind == "constant_use":
        return names.get(f"<{name_of(node)}>")
    known = names.get(name_of(node)) if kind in ("parameter", "defaulted") else None
    if known is not None or kind == "undecided":
        return known
    parts = [_value(part, names, by) for part in node.parts]
    if kind in by.operations and len(parts) == 2:
        return _applied(by.operations[kind], *parts)
    if kind == "negate" and parts[0] is not None:
        return by.negate(parts[0])
    return parts[0] if kind in ("group", "plus", "constant", "defaulted") else None


def _number(token: Node | Token, by: Arithmetic[T]) -> T | None:
    return None if number_of(token) is None else by.number(cast(Token, token).text)


def _applied(operation: Callable[[T, T], T | None], left: T | None, right: T | None) -> T | None:
    return None if left is None or right is None else operation(left, right)


FLOATS = Arithmetic[float](
    float,
    math.pi,
    operator.neg,
    {
        "add": operator.add,
        "subtract": operator.sub,
        "multiply": operator.mul,
        "divide": lambda left, right: left / right if right else None,
    },
)
