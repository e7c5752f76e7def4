"""Computes a trace with plain floats."""

import math
import operator
from collections.abc import Callable, Mapping, Sequence

from kindsl.mechanics.dynamics.generation.emitters.straight_line import computed
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar, Term

OPERATIONS: dict[str, Callable[..., float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "neg": operator.neg,
    "sin": math.sin,
    "cos": math.cos,
    "sign": lambda x: float((x > 0.0) - (x < 0.0)),
}


def evaluate(graph: Graph, inputs: Mapping[int, float], values: Sequence[Scalar]) -> list[float]:
    """Return values for given inputs, by their nodes.

    Raises:
        ZeroDivisionError: A value is not defined.
    """
    numbers = dict(inputs)
    for index in computed(graph, values, numbers):
        operation, *operands = graph.nodes[index]
        words = [numbers[o] if isinstance(o, int) else o for o in operands]
        numbers[index] = OPERATIONS[operation](*words)
    return [numbers[v.index] if isinstance(v, Term) else v for v in values]
