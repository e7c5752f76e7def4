"""Values over ranges of parameters: their bounds, and whether they are affine in each parameter."""

from collections.abc import Callable, Mapping
from math import pi
from typing import TypeAlias, cast

from kindsl.language.semantics.expressions import Expression, name_of, number_of
from kindsl.language.syntax.tree import Node, Token

Interval: TypeAlias = tuple[float, float]
Degrees: TypeAlias = Mapping[str, int]

_PASSING = ("group", "plus", "constant")
_USES = ("parameter", "defaulted", "juxtaposed_parameter")


def exactly(text: str) -> Interval:
    """Return a number as written, taken to be exact."""
    return float(text), float(text)


def bounds_of(
    expression: Expression,
    known: Mapping[str, Interval],
    written: Callable[[str], Interval] = exactly,
) -> Interval | None:
    """Return bounds of a value, None where a name is unbound or a divisor may be zero.

    Args:
        expression: The value.
        known: Bounds of parameters by name, and of constants by `<name>`.
        written: Gives the bounds of a number by its text.

    Source: natural interval extension, Moore 1966.
    """
    return _bounds(expression.node, known, written)


def degrees_of(expression: Expression, names: frozenset[str]) -> Degrees | None:
    """Return the degree of a value in each of some parameters, None where it is no polynomial."""
    return _degrees(expression.node, names)


def product_degrees(left: Degrees, right: Degrees) -> Degrees:
    """Return the degrees of a product."""
    return {name: left.get(name, 0) + right.get(name, 0) for name in {**left, **right}}


def _bounds(
    node: Node, known: Mapping[str, Interval], written: Callable[[str], Interval]
) -> Interval | None:
    kind = node.kind
    if kind == "number":
        return _number(node, written)
    if kind == "pi":
        return pi, pi
    if kind == "juxtaposed_pi":
        return _times(_number(node, written), (pi, pi))
    if kind == "constant_use":
        return known.get(f"<{name_of(node)}>")
    if kind == "juxtaposed_parameter":
        return _times(_number(node, written), known.get(name_of(node)))
    parts = [_bounds(child, known, written) for child in node.children if isinstance(child, Node)]
    if kind in ("parameter", "defaulted"):
        return known.get(name_of(node)) or (parts[0] if parts else None)
    if kind in _PASSING:
        return parts[0]
    if kind == "negate":
        return _times((-1.0, -1.0), parts[0])
    return None if kind == "unsupported" else _combined(kind, *parts)


def _combined(kind: str, left: Interval | None, right: Interval | None) -> Interval | None:
    if left is None or right is None:
        return None
    if kind == "add":
        return left[0] + right[0], left[1] + right[1]
    if kind == "subtract":
        return left[0] - right[1], left[1] - right[0]
    if kind == "divide":
        has_zero = right[0] <= 0.0 <= right[1]
        return None if has_zero else _times(left, (1.0 / right[1], 1.0 / right[0]))
    return _times(left, right)


def _times(left: Interval | None, right: Interval | None) -> Interval | None:
    if left is None or right is None:
        return None
    products = [a * b for a in left for b in right]
    return min(products), max(products)


def _degrees(node: Node, names: frozenset[str]) -> Degrees | None:
    name = name_of(node) if node.kind in _USES else ""
    if name:
        return {name: 1} if name in names else {}
    if node.kind == "unsupported":
        return None
    parts: list[Degrees] = []
    for child in node.children:
        if isinstance(child, Node):
            degrees = _degrees(child, names)
            if degrees is None:
                return None
            parts.append(degrees)
    if node.kind == "multiply":
        return product_degrees(*parts)
    if node.kind == "divide":
        return None if any(parts[1].values()) else parts[0]
    return {name: max(p[name] for p in parts if name in p) for part in parts for name in part}


def _number(node: Node, written: Callable[[str], Interval]) -> Interval | None:
    token = node.children[0]
    return None if number_of(token) is None else written(cast(Token, token).text)
