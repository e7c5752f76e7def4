"""Expressions that record the arithmetic done on them.

An algorithm that is run on `Term` inputs leaves a graph of what it computed. Operations on
constants are folded, zeros and ones drop out, multiples of one value become one, negations move
outwards, and equal operations are recorded once. The graph's nodes are tuples
`(operation, operand, ...)`; an operand is the index of an earlier node, or a float.
"""

import math
from collections.abc import Iterable
from typing import TypeAlias, Union

Scalar: TypeAlias = Union["Term", float]
Operand: TypeAlias = int | float
Node: TypeAlias = tuple[str, *tuple[Operand, ...]]


class Graph:
    """The operations so far, each once, operands before results.

    Attributes:
        nodes: The operations.
        inputs: Indices of the nodes that are inputs.
    """

    __slots__ = ("_indices", "inputs", "nodes")

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.inputs: list[int] = []
        self._indices: dict[tuple[object, ...], int] = {}

    def input(self) -> "Term":
        """Add an input value; inputs are numbered in the order in which they are added."""
        index = len(self.nodes)
        self.nodes.append(("input", len(self.inputs)))
        self.inputs.append(index)
        return Term(self, index)

    def vector(self, length: int) -> "list[Term]":
        """Add several input values."""
        return [self.input() for _ in range(length)]

    def record(self, *node: Operand | str) -> "Term":
        """Return the expression of an operation, which is recorded if it is a new one."""
        # 1.0 == 1 as a key, so an operand's type belongs to it.
        key = (*node, *map(type, node))
        index = self._indices.get(key)
        if index is None:
            index = self._indices[key] = len(self.nodes)
            self.nodes.append(node)  # type: ignore[arg-type]
        return Term(self, index)


class Term:
    """A value that is known only when the generated code runs."""

    __slots__ = ("graph", "index")

    def __init__(self, graph: Graph, index: int) -> None:
        self.graph = graph
        self.index = index

    def __add__(self, other: Scalar) -> Scalar:
        if isinstance(other, float):
            return self if other == 0.0 else self.graph.record("+", self.index, other)
        (value, factor), (other_value, other_factor) = self._term(), other._term()
        if value == other_value:
            return self._operand(value) * (factor + other_factor)
        negated_self, negated_other = self._negated(), other._negated()
        if negated_other is not None:
            return self - negated_other
        if negated_self is not None:
            return other - negated_self
        first, second = sorted((self.index, other.index))
        return self.graph.record("+", first, second)

    __radd__ = __add__

    def __sub__(self, other: Scalar) -> Scalar:
        if isinstance(other, float):
            return self + -other
        (value, factor), (other_value, other_factor) = self._term(), other._term()
        if value == other_value:
            return self._operand(value) * (factor - other_factor)
        negated_self, negated_other = self._negated(), other._negated()
        if negated_other is not None:
            return self + negated_other
        if negated_self is not None:
            return -(negated_self + other)
        return self.graph.record("-", self.index, other.index)

    def __rsub__(self, other: float) -> Scalar:
        return -self if other == 0.0 else self.graph.record("-", other, self.index)

    def __mul__(self, other: Scalar) -> Scalar:
        if isinstance(other, float):
            return self._scaled(other)
        negated_self, negated_other = self._negated(), other._negated()
        if negated_self is not None:
            return -(negated_self * other)
        if negated_other is not None:
            return -(self * negated_other)
        first, second = sorted((self.index, other.index))
        return self.graph.record("*", first, second)

    __rmul__ = __mul__

    def __truediv__(self, other: Scalar) -> Scalar:
        if isinstance(other, float):
            return self * (1.0 / other)
        return self.graph.record("/", self.index, other.index)

    def __rtruediv__(self, other: float) -> Scalar:
        return self.graph.record("/", other, self.index)

    def __neg__(self) -> "Term":
        operation, *operands = self.graph.nodes[self.index]
        if operation == "neg":
            return self._operand(operands[0])
        if operation == "-":
            return self.graph.record("-", operands[1], operands[0])
        if operation == "*" and isinstance(operands[1], float):
            return self.graph.record("*", operands[0], -operands[1])
        return self.graph.record("neg", self.index)

    def _scaled(self, factor: float) -> Scalar:
        if factor == 0.0:
            return 0.0
        if factor == 1.0:
            return self
        if factor == -1.0:
            return -self
        operation, *operands = self.graph.nodes[self.index]
        if operation == "neg":
            return self._operand(operands[0])._scaled(-factor)
        if operation == "*" and isinstance(operands[1], float):
            return self._operand(operands[0])._scaled(operands[1] * factor)
        return self.graph.record("*", self.index, factor)

    def _term(self) -> tuple[int, float]:
        """Return a node and the constant that this is its product with."""
        operation, *operands = self.graph.nodes[self.index]
        if operation == "*" and isinstance(operands[1], float):
            return int(operands[0]), operands[1]
        return self.index, 1.0

    def _negated(self) -> "Term | None":
        """Return what this is the negative of, if it is recorded so."""
        operation, *operands = self.graph.nodes[self.index]
        return self._operand(operands[0]) if operation == "neg" else None

    def _operand(self, operand: Operand) -> "Term":
        return Term(self.graph, int(operand))


def needed(graph: Graph, values: Iterable[Scalar | None], known: Iterable[int] = ()) -> list[int]:
    """Return the nodes that values depend on, operands first, as far as some are not known."""
    given = frozenset(known)
    found = set(given)
    waiting = [value.index for value in values if isinstance(value, Term)]
    while waiting:
        index = waiting.pop()
        if index not in found:
            found.add(index)
            waiting += operand_nodes(graph, index)
    return sorted(found - given)


def operations(graph: Graph, values: Iterable[Scalar]) -> int:
    """Return how many operations values take."""
    return sum(graph.nodes[index][0] != "input" for index in needed(graph, values))


def operand_nodes(graph: Graph, index: int) -> list[int]:
    """Return the nodes that a node depends on directly."""
    operation, *operands = graph.nodes[index]
    if operation == "input":
        return []
    return [operand for operand in operands if isinstance(operand, int)]


def sign(value: Scalar) -> Scalar:
    """Record the sign of a value: -1, 0 or 1."""
    if isinstance(value, float):
        return math.copysign(1.0, value) if value else 0.0
    return value.graph.record("sign", value.index)


def cosine_and_sine(angle: Scalar) -> tuple[Scalar, Scalar]:
    """Record the cosine and the sine of an angle, radians."""
    if isinstance(angle, float):
        return math.cos(angle), math.sin(angle)
    return angle.graph.record("cos", angle.index), angle.graph.record("sin", angle.index)
