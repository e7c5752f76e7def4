"""Writes a trace as calls of NumPy's ufuncs, for many configurations at a time.

Every value is a row with one entry per configuration. Results go to reused rows of a scratch
array, so that a chunk's working set stays in the processor's cache and nothing is allocated.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from kindsl.mechanics.dynamics.generation.terms import Operand, Term, operand_nodes
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


@dataclass(frozen=True, slots=True)
class BatchFunction:
    """A compiled trace.

    Attributes:
        evaluate: Takes the arguments, cosines and sines of the first one, the output rows and the
            scratch rows. All are sequences of rows; arguments may hold numbers instead.
        n_scratch: Number of scratch rows that it needs.
        n_outputs: Number of output rows.
        constant_rows: Which of them it leaves alone, shape (k,).
        constants: Values of these, shape (k, 1).
    """

    evaluate: Callable[..., None]
    n_scratch: int
    n_outputs: int
    constant_rows: npt.NDArray[np.intp]
    constants: Array


def batch_function(trace: Trace) -> BatchFunction:
    """Compile a trace for rows."""
    source, rows = batch_source(trace)
    namespace: dict[str, object] = dict(UFUNCS.values())
    # A ufunc takes a 0-d array a third faster than a float.
    namespace |= {name: np.array(value) for value, name in rows.constants.items()}
    exec(compile(source, "<generated mechanics>", "exec"), namespace)
    evaluate: Callable[..., None] = namespace["evaluate"]  # type: ignore[assignment]
    constants = {n: o for n, o in enumerate(trace.outputs) if not isinstance(o, Term)}
    return BatchFunction(
        evaluate,
        rows.n_scratch,
        len(trace.outputs),
        np.array(list(constants), dtype=np.intp),
        np.array(list(constants.values()))[:, None],
    )


def batch_source(trace: Trace) -> tuple[str, "Rows"]:
    """Return the source of a function `evaluate`, and what the names in it stand for."""
    rows = Rows(trace)
    lines: list[str] = []
    for index in trace.needed():
        operation, *operands = trace.graph.nodes[index]
        if operation not in UFUNCS:
            continue
        words = ",".join(rows.word(operand) for operand in operands)
        # What is used for the last time may make place for the result.
        rows.release(index)
        lines.append(f"{UFUNCS[operation][0]}({words},{rows.claim(index)})")
    arguments = ",".join(f"a{number}" for number in range(len(trace.arguments)))
    head = f"def evaluate({arguments},cosines,sines,out,scratch):"
    return "\n ".join([head, *rows.unpacked(), *lines, *rows.copied(), "return\n"]), rows


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
    out[function.constant_rows] = function.constants
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


class Rows:
    """The place of each value of a trace: in an argument, an output or a scratch row.

    Attributes:
        constants: The names of constants.
    """

    def __init__(self, trace: Trace) -> None:
        self.constants: dict[float, str] = {}
        self._trace = trace
        self._scratch: set[str] = set()
        self._free: list[str] = []
        self._names: dict[int, str] = {}
        self._blocks = _blocks(trace)
        for block, indices in self._blocks.items():
            self._names.update((node, f"{block}_{row}") for row, node in enumerate(indices))
        self._outputs: dict[int, int] = {}
        for number, output in enumerate(trace.outputs):
            if isinstance(output, Term) and output.index not in self._names:
                self._outputs.setdefault(output.index, number)
        self._last_use = {
            operand: index
            for index in trace.needed()
            for operand in operand_nodes(trace.graph, index)
        }

    @property
    def n_scratch(self) -> int:
        """Number of scratch rows claimed so far."""
        return len(self._scratch)

    def word(self, operand: Operand) -> str:
        """Return how to write an operand."""
        if isinstance(operand, int):
            return self._names[operand]
        return self.constants.setdefault(operand, f"k{len(self.constants)}")

    def claim(self, index: int) -> str:
        """Return the row that a node's result goes to."""
        if index in self._outputs:
            name = f"o{self._outputs[index]}"
        elif self._free:
            name = self._free.pop()
        else:
            name = f"s{self.n_scratch}"
            self._scratch.add(name)
        self._names[index] = name
        return name

    def release(self, index: int) -> None:
        """Free the scratch rows that no node after this one uses."""
        for operand in set(operand_nodes(self._trace.graph, index)):
            if self._last_use[operand] == index and self._names[operand] in self._scratch:
                self._free.append(self._names[operand])

    def unpacked(self) -> list[str]:
        """Return lines that give the rows their names."""
        needed = set(self._trace.needed())
        scratch = [f"s{number}" for number in range(self.n_scratch)]
        lines = [f"{','.join(scratch)},=scratch"] if scratch else []
        for block, indices in self._blocks.items():
            if not needed.isdisjoint(indices):
                names = ",".join(self._names[index] for index in indices)
                lines.append(f"{names},={block}")
        outputs = ",".join(f"o{number}" for number in range(len(self._trace.outputs)))
        return [*lines, f"{outputs},=out"]

    def copied(self) -> list[str]:
        """Return lines that fill the rows that are neither computed in place nor constant."""
        return [
            f"copy({self._names[output.index]},o{number})"
            for number, output in enumerate(self._trace.outputs)
            if isinstance(output, Term) and self._outputs.get(output.index) != number
        ]


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
