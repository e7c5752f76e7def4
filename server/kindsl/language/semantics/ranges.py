"""Values over ranges of parameters: their bounds, and whether they are affine in each parameter."""

from collections.abc import Callable, Mapping
from math import pi
from typing import TypeAlias

from kindsl.language.semantics.expressions import Expression
from kindsl.language.syntax.arithmetic import Arithmetic, evaluate, name_of
from kindsl.language.syntax.tree import Node

Interval: TypeAlias = tuple[float, float]
Degrees: TypeAlias = Mapping[str, int]

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
        known: Bounds of parameters by name, and of constants by `<name>`.
        written: Gives the bounds of a number by its text.

    Source: natural interval extension, Moore 1966.
    """
    by = Arithmetic(written, (pi, pi), _negative, _OPERATIONS)
    return evaluate(expression.node, known, by)


def degrees_of(expression: Expression, names: frozenset[str]) -> Degrees | None:
    """Return the degree of a value in each of some parameters, None where it is no polynomial."""
    return _degrees(expression.node, names)


def product_degrees(left: Degrees, right: Degrees) -> Degrees:
    """Return the degrees of a product."""
    return {name: left.get(name, 0) + right.get(name, 0) for name in {**left, **right}}


def sum_of(left: Interval, right: Interval) -> Interval:
    """Return the bounds of a sum."""
    return left[0] + right[0], left[1] + right[1]


def difference_of(left: Interval, right: Interval) -> Interval:
    """Return the bounds of a difference."""
    return left[0] - right[1], left[1] - right[0]


def product_of(left: Interval, right: Interval) -> Interval:
    """Return the bounds of a product."""
    products = [a * b for a in left for b in right]
    return min(products), max(products)


def _quotient(left: Interval, right: Interval) -> Interval | None:
    has_zero = right[0] <= 0.0 <= right[1]
    return None if has_zero else product_of(left, (1.0 / right[1], 1.0 / right[0]))


def _negative(interval: Interval) -> Interval:
    return -interval[1], -interval[0]


_OPERATIONS = {
    "add": sum_of,
    "subtract": difference_of,
    "multiply": product_of,
    "divide": _quotient,
}


def _degrees(node: Node, names: frozenset[str]) -> Degrees | None:
    name = name_of(node) if node.kind in _USES else ""
    if name:
        return {name: 1} if name in names else {}
    if node.kind == "unsupported":
        return None
    found = [_degrees(part, names) for part in node.parts]
    parts = [degrees for degrees in found if degrees is not None]
    if len(parts) < len(found):
        return None
    if node.kind == "multiply":
        return product_degrees(*parts)
    if node.kind == "divide":
        return None if any(parts[1].values()) else parts[0]
    return {name: max(p[name] for p in parts if name in p) for part in parts for name in part}
