"""Writes a trace as calls of NumPy's ufuncs, for many configurations at a time.

Every value is a row with one entry per configuration. Results go to reused rows of a scratch
array, so that a chunk's working set stays in the processor's cache and nothing is allocated.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from kindsl.dynamics.generation.expressions import Expression, Operand
from kindsl.dynamics.generation.trace import Trace
from kindsl.spatial.arrays import Array

UFUNCS = {
    "+": ("add", np.add),
    "-": ("sub", np.subtract),
    "*": ("mul", np.multiply),
    "/": ("div", np.divide),
    "neg": ("neg", np.negative),
    "sin": ("sin", np.sin),
    "cos": ("cos", np.cos),
    "tan": ("tan", np.tan),
}


@dataclass(frozen=True, slots=True)
class BatchFunction:
    """A compiled trace.

    Attributes:
        evaluate: Takes the arguments (each a sequence of rows or numbers), the output rows
            and the scratch rows.
        n_scratch: Number of scratch rows that it needs.
        n_outputs: Number of output rows that it fills.
    """

    evaluate: Callable[..., None]
    n_scratch: int
    n_outputs: int


def batch_function(trace: Trace) -> BatchFunction:
    """Compile a trace for rows."""
    source, n_scratch = batch_source(trace)
    namespace: dict[str, object] = dict(UFUNCS.values())
    exec(compile(source, "<generated mechanics>", "exec"), namespace)
    evaluate: Callable[..., None] = namespace["evaluate"]  # type: ignore[assignment]
    return BatchFunction(evaluate, n_scratch, len(trace.outputs))


def batch_source(trace: Trace) -> tuple[str, int]:
    """Return the source of a function `evaluate`, and the number of its scratch rows."""
    rows = _Rows(trace)
    lines: list[str] = []
    for index in trace.needed():
        operation, *operands = trace.graph.nodes[index]
        if operation == "input":
            continue
        words = [rows.word(operand) for operand in operands if not isinstance(operand, str)]
        rows.release(index)
        lines.append(f"{UFUNCS[operation][0]}({','.join(words)},{rows.claim(index)})")
    names = [f"a{number}" for number in range(len(trace.arguments))]
    scratch = ",".join(f"s{number}" for number in range(rows.n_scratch))
    body = [f"{scratch},=scratch"] if scratch else []
    body += rows.unpacked_inputs() + rows.named_outputs() + lines + rows.copied_outputs()
    return f"def evaluate({','.join([*names, 'out', 'scratch'])}):\n " + "\n ".join(
        [*body, "return"]
    ) + "\n", rows.n_scratch


class _Rows:
    """Where each value lies: in an argument, an output or a scratch row."""

    def __init__(self, trace: Trace) -> None:
        self.trace = trace
        self.n_scratch = 0
        self._free: list[str] = []
        self._names: dict[int, str] = {}
        self._inputs = set(trace.graph.inputs)
        self._outputs: dict[int, int] = {}
        self._last_use: dict[int, int] = {}
        for number, output in enumerate(trace.outputs):
            if isinstance(output, Expression) and output.index not in self._inputs:
                self._outputs.setdefault(output.index, number)
        for index in trace.needed():
            for operand in trace.operands(index):
                self._last_use[operand] = index
        for number, argument in enumerate(trace.arguments):
            for position, component in enumerate(argument):
                self._names[component.index] = f"a{number}_{position}"

    def word(self, operand: Operand) -> str:
        return self._names[operand] if isinstance(operand, int) else repr(operand)

    def claim(self, index: int) -> str:
        if index in self._outputs:
            name = f"o{self._outputs[index]}"
        elif self._free:
            name = self._free.pop()
        else:
            name = f"s{self.n_scratch}"
            self.n_scratch += 1
        self._names[index] = name
        return name

    def release(self, index: int) -> None:
        for operand in set(self.trace.operands(index)):
            name = self._names[operand]
            if self._last_use[operand] == index and name[0] == "s":
                self._free.append(name)

    def unpacked_inputs(self) -> list[str]:
        used = set(self.trace.needed())
        lines = []
        for number, argument in enumerate(self.trace.arguments):
            indices = [component.index for component in argument]
            if not used.isdisjoint(indices):
                lines.append(",".join(self._names[index] for index in indices) + f",=a{number}")
        return lines

    def named_outputs(self) -> list[str]:
        return [f"o{number}=out[{number}]" for number in self._outputs.values()]

    def copied_outputs(self) -> list[str]:
        lines = []
        for number, output in enumerate(self.trace.outputs):
            if not isinstance(output, Expression):
                lines.append(f"out[{number}]={output!r}")
            elif self._outputs.get(output.index) != number:
                lines.append(f"out[{number}]={self._names[output.index]}")
        return lines


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
    chunk = max(1, math.ceil(size / max(1, math.ceil(size / chunk))))
    scratch = np.empty((function.n_scratch, min(chunk, size)))
    for start in range(0, size, chunk):
        stop = min(start + chunk, size)
        rows = [_rows(argument, start, stop) for argument in arguments]
        function.evaluate(*rows, out[:, start:stop], scratch[:, : stop - start])
    return out


def _rows(argument: Array | list[float], start: int, stop: int) -> Array | list[float]:
    if isinstance(argument, list):
        return argument
    return np.ascontiguousarray(argument[start:stop].T)
