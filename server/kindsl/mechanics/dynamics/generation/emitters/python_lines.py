"""Writes functions of scalars as straight lines of Python, for any type with arithmetic.

Whoever calls them decides what a scalar is: a NumPy or JAX array over a batch, or a symbol of
CasADi. The names `sin`, `cos` and `sign` are to be there.
"""

from collections.abc import Mapping, Sequence

from kindsl.mechanics.dynamics.generation.emitters.straight_line import Notation, computed
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar, Term

_PYTHON = Notation()


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
        lines.append(f"x{node} = {_PYTHON.operation(graph, node, texts.__getitem__)}")
        texts[node] = f"x{node}"
    words = [[_PYTHON.word(entry, texts.__getitem__) for entry in result] for result in results]
    given = [f"[{', '.join(entries)}]" for entries in words]
    body = "\n".join(f"    {line}" for line in [*lines, f"return {', '.join(given)},"])
    return f"def {name}({', '.join(arguments)}):\n{body}\n"
