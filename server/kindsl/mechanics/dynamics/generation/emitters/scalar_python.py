"""Writes a trace as a Python function of floats, for one configuration."""

import math
import struct
from collections import Counter
from collections.abc import Callable
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from kindsl.mechanics.dynamics.generation.emitters.numbers import OPERATIONS
from kindsl.mechanics.dynamics.generation.emitters.straight_line import Notation
from kindsl.mechanics.dynamics.generation.factorization import is_zero
from kindsl.mechanics.dynamics.generation.terms import Term, operand_nodes
from kindsl.mechanics.dynamics.generation.trace import Trace
from kindsl.mechanics.spatial.arrays import Array

ScalarFunction: TypeAlias = Callable[..., Array]

# A value used once is written where it is used, unless the line grows longer than this.
LONGEST_INLINED = 160
_COMPACT = Notation(blank="")


def scalar_function(trace: Trace) -> ScalarFunction:
    """Compile a trace.

    The function takes each argument as a vector of float64 and returns the outputs as an array.
    It raises TypeError, ValueError or AttributeError for anything else, OverflowError if the sum
    of all numbers is not finite, and ZeroDivisionError.
    """
    # Packing takes half the time that an array takes to convert a list; pad bytes are zeros.
    layout = "".join("8x" if is_zero(output) else "d" for output in trace.outputs)
    namespace: dict[str, Any] = {
        "sin": math.sin,
        "cos": math.cos,
        "sign": OPERATIONS["sign"],
        "float64": np.dtype(np.float64),
        "pack": struct.Struct(layout).pack_into,
        "empty": partial(np.empty, len(trace.outputs)),
    }
    exec(compile(scalar_source(trace), "<generated mechanics>", "exec"), namespace)
    function: ScalarFunction = namespace["evaluate"]
    return function


def scalar_source(trace: Trace) -> str:
    """Return the source of `evaluate`, one local variable for each shared value."""
    texts: dict[int, str] = {}
    lines = _unpacked_arguments(trace, texts)
    uses = _uses(trace)
    for index in trace.needed():
        if index in texts:
            continue
        text = _COMPACT.operation(trace.graph, index, texts.__getitem__)
        if uses[index] == 1 and len(text) < LONGEST_INLINED:
            texts[index] = f"({text})"
        else:
            texts[index] = f"v{index}"
            lines.append(f"v{index}={text}")
    given = [
        texts[output.index] if isinstance(output, Term) else repr(output)
        for output in trace.outputs
        if not is_zero(output)
    ]
    names = ",".join(f"a{number}" for number in range(len(trace.arguments)))
    packed = ",".join(["out", "0", *given])
    body = "\n ".join([*lines, "out=empty()", f"pack({packed})", "return out"])
    return f"def evaluate({names}):\n {body}\n"


def _unpacked_arguments(trace: Trace, texts: dict[int, str]) -> list[str]:
    lines = []
    for number, argument in enumerate(trace.arguments):
        texts.update((component.index, f"v{component.index}") for component in argument)
        name = f"a{number}"
        lines.append(f"if {name}.dtype is not float64 or {name}.ndim!=1: raise TypeError")
        names = ",".join(texts[component.index] for component in argument)
        lines.append(f"{names},={name}.tolist()")
    # What is not finite leaves no zero when taken from itself.
    return [*lines, f"total={'+'.join(texts.values())}", "if total-total: raise OverflowError"]


def _uses(trace: Trace) -> Counter[int]:
    nodes = (operand_nodes(trace.graph, index) for index in trace.needed())
    uses = Counter(operand for operands in nodes for operand in operands)
    uses.update(output.index for output in trace.outputs if isinstance(output, Term))
    return uses
