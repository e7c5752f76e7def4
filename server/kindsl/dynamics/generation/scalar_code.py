"""Writes a trace as a Python function of floats, for one configuration."""

import math
import struct
from collections import Counter
from collections.abc import Callable
from functools import partial
from typing import TypeAlias

import numpy as np

from kindsl.dynamics.generation.expressions import Expression, Operand
from kindsl.dynamics.generation.trace import Trace
from kindsl.spatial.arrays import Array

ScalarFunction: TypeAlias = Callable[..., Array]

# A value used once is written where it is used, unless the line grows longer than this.
LONGEST_INLINED = 160


def scalar_function(trace: Trace) -> ScalarFunction:
    """Compile a trace.

    The function takes the arguments as lists of floats and returns the outputs as an array. It
    raises OverflowError if the sum of all numbers is not finite, and ZeroDivisionError.
    """
    # Packing takes half the time that an array takes to convert a list.
    n_outputs = len(trace.outputs)
    namespace: dict[str, object] = {
        "sin": math.sin,
        "cos": math.cos,
        "isfinite": math.isfinite,
        "pack": struct.Struct(f"{n_outputs}d").pack_into,
        "empty": partial(np.empty, n_outputs),
    }
    exec(compile(scalar_source(trace), "<generated mechanics>", "exec"), namespace)
    function: ScalarFunction = namespace["evaluate"]  # type: ignore[assignment]
    return function


def scalar_source(trace: Trace) -> str:
    """Return the source of a function `evaluate`, one local variable for each shared value."""
    texts: dict[int, str] = {}
    lines = _unpacked_arguments(trace, texts)
    uses = _uses(trace)
    for index in trace.needed():
        if index in texts:
            continue
        text = _operation(trace, index, texts)
        if uses[index] == 1 and len(text) < LONGEST_INLINED:
            texts[index] = f"({text})"
        else:
            texts[index] = f"v{index}"
            lines.append(f"v{index}={text}")
    outputs = [
        texts[output.index] if isinstance(output, Expression) else repr(output)
        for output in trace.outputs
    ]
    names = ",".join(f"a{number}" for number in range(len(trace.arguments)))
    lines += ["out=empty()", f"pack(out,0,{','.join(outputs)})", "return out"]
    body = "\n ".join(lines)
    return f"def evaluate({names}):\n {body}\n"


def _unpacked_arguments(trace: Trace, texts: dict[int, str]) -> list[str]:
    lines = []
    for number, argument in enumerate(trace.arguments):
        texts.update((component.index, f"v{component.index}") for component in argument)
        lines.append(f"{','.join(texts[component.index] for component in argument)},=a{number}")
    total = "+".join(texts.values())
    return [*lines, f"if not isfinite({total}): raise OverflowError"]


def _uses(trace: Trace) -> Counter[int]:
    uses = Counter(operand for index in trace.needed() for operand in trace.operands(index))
    uses.update(output.index for output in trace.outputs if isinstance(output, Expression))
    return uses


def _operation(trace: Trace, index: int, texts: dict[int, str]) -> str:
    operation, *operands = trace.graph.nodes[index]
    words = [_operand(operand, texts) for operand in operands if not isinstance(operand, str)]
    if operation in ("sin", "cos"):
        return f"{operation}({words[0]})"
    if operation == "neg":
        return f"-{words[0]}"
    return f"{words[0]}{operation}{words[1]}"


def _operand(operand: Operand, texts: dict[int, str]) -> str:
    if isinstance(operand, int):
        return texts[operand]
    return repr(operand) if operand >= 0.0 else f"({operand!r})"
