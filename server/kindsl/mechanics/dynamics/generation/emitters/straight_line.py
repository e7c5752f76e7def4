"""Operations as a language writes them, in an order, cut into parts that a compiler can take in."""

import math
from collections.abc import Callable, Collection, Iterable, Sequence
from itertools import count
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.terms import (
    Graph,
    Operand,
    Scalar,
    Term,
    needed,
    operand_nodes,
)

OPERATORS = ("+", "-", "*", "/")


def in_python(number: float) -> str:
    """Return a number as an operand in Python."""
    return repr(number) if number >= 0.0 else f"({number!r})"


class Notation(NamedTuple):
    """The notation of a language.

    Attributes:
        number: Returns the text of a number.
        call: How a function is called, by its name and argument.
        sign: How the sign of a value is computed, where that is no call.
        blank: What stands around an operator.
    """

    number: Callable[[float], str] = in_python
    call: str = "{0}({1})"
    sign: str = ""
    blank: str = " "

    def word(self, value: Operand | Scalar, text: Callable[[int], str]) -> str:
        """Return a number, or the text of a node."""
        node = value.index if isinstance(value, Term) else value
        return text(node) if isinstance(node, int) else self.number(node)

    def operation(self, graph: Graph, node: int, text: Callable[[int], str]) -> str:
        """Return the operation of a node, its operands by the texts of their nodes."""
        operation, *operands = graph.nodes[node]
        words = [self.word(operand, text) for operand in operands]
        if operation in OPERATORS:
            return f"{words[0]}{self.blank}{operation}{self.blank}{words[1]}"
        if operation == "neg":
            return f"-{words[0]}"
        if operation == "sign" and self.sign:
            return self.sign.format(words[0])
        return self.call.format(operation, words[0])


class Part(NamedTuple):
    """Some operations, one after the other.

    Attributes:
        nodes: The operations.
        kept: Those whose results later parts need, each with its place among kept values.
    """

    nodes: list[int]
    kept: dict[int, int]


class Parts(NamedTuple):
    """All operations of a function.

    Attributes:
        parts: In order.
        n_kept: How many places kept values take.
    """

    parts: list[Part]
    n_kept: int


def computed(graph: Graph, values: Iterable[Scalar | None], known: Iterable[int]) -> list[int]:
    """Return the nodes to compute for values, operands first, when some nodes are known."""
    return [i for i in needed(graph, values, known) if graph.nodes[i][0] != "input"]


def depth_first(
    graph: Graph, values: Iterable[Scalar | None], known: Iterable[int]
) -> list[int]:  # fmt: skip
    """Return the same nodes, each shortly before it is used first."""
    order: list[int] = []
    seen = set(known)
    for value in values:
        waiting = [(value.index, False)] if isinstance(value, Term) else []
        while waiting:
            node, is_ready = waiting.pop()
            if is_ready:
                order.append(node)
            elif node not in seen:
                seen.add(node)
                waiting.append((node, True))
                waiting += [(o, False) for o in reversed(operand_nodes(graph, node))]
    return [node for node in order if graph.nodes[node][0] != "input"]


def cut(
    graph: Graph, order: Sequence[int], size: int, results: Collection[int] = ()
) -> Parts:  # fmt: skip
    """Cut operations into parts of a size; a place is used again when its value is not needed.

    Args:
        graph: Where they are recorded.
        order: The operations.
        size: Of a part.
        results: Those that are needed behind all parts.
    """
    pieces = [list(order[start : start + size]) for start in range(0, len(order), size)]
    last_use: dict[int, int] = {}
    for number, piece in enumerate(pieces):
        for node in piece:
            last_use.update((o, number) for o in operand_nodes(graph, node))
    last_use.update((node, len(pieces)) for node in results)
    parts, free, n_kept = [], list[int](), 0
    leaving: dict[int, list[int]] = {}
    for number, piece in enumerate(pieces):
        free += leaving.pop(number - 1, [])
        kept = {}
        for node in piece:
            if last_use.get(node, number) > number:
                if not free:
                    free.append(n_kept)
                    n_kept += 1
                kept[node] = free.pop()
                leaving.setdefault(last_use[node], []).append(kept[node])
        parts.append(Part(piece, kept))
    return Parts([_scattered(part, n_kept) for part in parts] or [Part([], {})], n_kept)


def _scattered(part: Part, n_kept: int) -> Part:
    """Return a part whose places do not lie side by side.

    Neighbours are what compilers pack into vectors, which slows straight lines down: with gcc -O2
    inverse dynamics of an arm of 7 takes a fifth less time so, forward dynamics of HyQ a tenth.
    """
    step = next(step for step in count(n_kept * 5 // 8 + 1) if math.gcd(step, n_kept) == 1)
    return part._replace(kept={node: place * step % n_kept for node, place in part.kept.items()})


def setup_nodes(graph: Graph, parameters: Iterable[int], order: Iterable[int]) -> set[int]:
    """Return the nodes that depend on parameters only, these among them."""
    found = set(parameters)
    for index in order:
        operands = operand_nodes(graph, index)
        if operands and all(operand in found for operand in operands):
            found.add(index)
    return found
