"""Writes a trace as calls of NumPy's ufuncs, for many configurations at a time.

Every value is a row with one entry per configuration. Results go to reused rows of a scratch
array, so that a chunk's working set stays in the processor's cache and nothing is allocated.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from kindsl.mechanics.dynamics.generation.terms import Term, operand_nodes
from kindsl.mechanics.dynamics.generation.trace import Trace
from kindsl.mechanics.spatial.arrays import Array

UFUNCS = {
    "+": ("add", np.add),
    "-": ("sub", np.subtract),
    "*": ("mul", np.multiply),
    "/": ("div", np.divide),
    "neg": ("neg", np.negative),
    "copy": ("copy", np.positive),
    "sign": ("sign", np.sign),
}


class BatchFunction(NamedTuple):
    """A compiled trace.

    Attributes:
        evaluate: Takes the arguments, cosines and sines of the first one, the output rows and the
            scratch rows. All are sequences of rows; arguments may hold numbers instead.
        n_scratch: Number of scratch rows that it needs.
        n_outputs: Number of output rows.
        constants: Values of those that it leaves alone, by their numbers.
    """

    evaluate: Callable[..., None]
    n_scratch: int
    n_outputs: int
    constants: dict[int, float]


def batch_function(trace: Trace) -> BatchFunction:
    """Compile a trace for rows."""
    source, n_scratch, names = batch_source(trace)
    namespace: dict[str, object] = dict(UFUNCS.values())
    # A ufunc takes a 0-d array a third faster than a float.
    namespace |= {name: np.array(value) for value, name in names.items()}
    exec(compile(source, "<generated mechanics>", "exec"), namespace)
    evaluate: Callable[..., None] = namespace["evaluate"]  # type: ignore[assignment]
    constants = {n: x for n, x in enumerate(trace.outputs) if isinstance(x, float)}
    return BatchFunction(evaluate, n_scratch, len(trace.outputs), constants)


def batch_source(trace: Trace) -> tuple[str, int, dict[float, str]]:
    """Return the source of `evaluate`, how many scratch rows it needs, and its names of numbers.

    Each value has its place in an output or a scratch row.
    """
    graph, order, blocks = trace.graph, trace.needed(), _blocks(trace)
    names = {node: f"{b}_{row}" for b, nodes in blocks.items() for row, node in enumerate(nodes)}
    outputs: dict[int, list[str]] = {}
    for number, output in enumerate(trace.outputs):
        if isinstance(output, Term):
            outputs.setdefault(output.index, []).append(f"o{number}")
    last_use = {operand: node for node in order for operand in operand_nodes(graph, node)}
    lines, constants, scratch, free = list[str](), dict[float, str](), set[str](), list[str]()
    for node in order:
        operation, *operands = graph.nodes[node]
        places = outputs.get(node, [])
        if operation in UFUNCS:
            words = [
                names[x] if isinstance(x, int) else constants.setdefault(x, f"k{len(constants)}")
                for x in operands
            ]
            # What is used for the last time may make place for the result.
            last = {x for x in operand_nodes(graph, node) if last_use[x] == node}
            free += [names[x] for x in sorted(last) if names[x] in scratch]
            if not places and not free:
                free.append(f"s{len(scratch)}")
                scratch.update(free)
            names[node] = places.pop(0) if places else free.pop()
            lines.append(f"{UFUNCS[operation][0]}({','.join([*words, names[node]])})")
        lines += [f"copy({names[node]},{place})" for place in places]
    unpacked = [",".join(names[x] for x in nodes) for nodes in blocks.values()]
    heads = [f"{given},={block}" for given, block in zip(unpacked, blocks, strict=True) if given]
    rows = ",".join(f"s{n}" for n in range(len(scratch)))
    heads += [f"{rows},=scratch"] if scratch else []
    heads.append(f"{','.join(f'o{n}' for n in range(len(trace.outputs)))},=out")
    head = f"def evaluate({','.join(blocks)},out,scratch):"
    return "\n ".join([head, *heads, *lines, "return\n"]), len(scratch), constants


def run_in_chunks(
    function: BatchFunction, arguments: list[Array | list[float]], size: int, chunk: int
) -> Array:
    """Evaluate a batch.

    Args:
        function: The compiled trace.
        arguments: Each a vector of numbers, or an array (size, components).
        size: Number of configurations.
        chunk: Greatest number of configurations to work on at a time.

    Returns:
        Shape (outputs, size).
    """
    out = np.empty((function.n_outputs, size))
    out[list(function.constants)] = np.array(list(function.constants.values()))[:, None]
    n_chunks = max(1, math.ceil(size / chunk))
    chunk = math.ceil(size / n_chunks)
    scratch = np.empty((function.n_scratch, chunk))
    for start in range(0, size, max(1, chunk)):
        stop = min(start + chunk, size)
        rows = [_rows(argument, start, stop) for argument in arguments]
        cosines, sines = _cosines_and_sines(np.asarray(rows[0]))
        function.evaluate(*rows, cosines, sines, out[:, start:stop], scratch[:, : stop - start])
    return out


def _rows(argument: Array | list[float], start: int, stop: int) -> Array | list[float]:
    if isinstance(argument, list):
        return argument
    return np.ascontiguousarray(argument[start:stop].T)


def _cosines_and_sines(angles: Array) -> tuple[Array, Array]:
    """Return both from `t = tan(angle / 2)`: `2 / (1 + t^2) - 1` and `2 t / (1 + t^2)`.

    NumPy's tangent takes a third of the time of its sine. The error is some 2e-16.
    """
    sines = np.tan(0.5 * angles)
    cosines = sines * sines
    cosines += 1.0
    np.divide(2.0, cosines, out=cosines)
    sines *= cosines
    cosines -= 1.0
    return cosines, sines


def _blocks(trace: Trace) -> dict[str, list[int]]:
    """Return the nodes that lie in the blocks of rows that `evaluate` is called with."""
    blocks = {
        f"a{number}": [component.index for component in argument]
        for number, argument in enumerate(trace.arguments)
    }
    angles = trace.arguments[0]
    blocks["cosines"] = [angle.graph.record("cos", angle.index).index for angle in angles]
    blocks["sines"] = [angle.graph.record("sin", angle.index).index for angle in angles]
    return blocks
