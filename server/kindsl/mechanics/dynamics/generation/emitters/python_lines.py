"""Writes functions of scalars as straight lines of Python, for any type with arithmetic.

Whoever calls them decides what a scalar is: a NumPy or JAX array over a batch, or a symbol of
CasADi. The names `sin`, `cos` and `sign` are to be there.
"""

from collections.abc import Mapping, Sequence

from kindsl.mechanics.dynamics.generation.emitters.straight_line import computed, operation_text
from kindsl.mechanics.dynamics.generation.terms import Graph, Operand, Scalar, Term


def python_function(
    graph: Graph,
    name: str,
    arguments: Mapping[str, Sequence[Scalar]],
    results: Sequence[Sequence[Scalar]],
) -> str:
    """Return a function that takes sequences of scalars and returns a list for each result."""
    lines, texts = [], dict[int, str]()
    for argument, components in arguments.items():
        names = [f"{argument}_{number}" for number in range(len(components))]
        if names:
            lines.append(f"{', '.join(names)}, = {argument}")
        texts.update(
            (x.index, text)
            for x, text in zip(components, names, strict=True)
            if isinstance(x, Term)
        )
    for node in computed(graph, [entry for result in results for entry in result], texts):
        lines.append(f"x{node} = {_operation(graph, node, texts)}")
        texts[node] = f"x{node}"
    given = [f"[{', '.join(_text(entry, texts) for entry in result)}]" for result in results]
    body = "\n".join(f"    {line}" for line in [*lines, f"return {', '.join(given)},"])
    return f"def {name}({', '.join(arguments)}):\n{body}\n"


def _operation(graph: Graph, node: int, texts: Mapping[int, str]) -> str:
    operation, *operands = graph.nodes[node]
    words = [_operand(operand, texts) for operand in operands]
    return operation_text(operation, words)


def _text(entry: Scalar, texts: Mapping[int, str]) -> str:
    return _operand(entry.index if isinstance(entry, Term) else entry, texts)


def _operand(operand: Operand, texts: Mapping[int, str]) -> str:
    if isinstance(operand, int):
        return texts[operand]
    return repr(operand) if operand >= 0.0 else f"({operand!r})"
