"""Writes a trace as a Python function of floats, for one configuration."""

import math
from collections import Counter
from collections.abc import Callable
from typing import TypeAlias

from kindsl.dynamics.generation.expressions import Expression, Operand
from kindsl.dynamics.generation.trace import Trace

ScalarFunction: TypeAlias = Callable[..., list[float]]

# A value used once is written where it is used, unless the line grows longer than this.
LONGEST_INLINED = 160


def scalar_function(trace: Trace) -> ScalarFunction:
    """Compile a trace: the function takes the arguments as lists and returns the outputs."""
    namespace: dict[str, object] = {"sin": math.sin, "cos": math.cos}
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
    body = "\n ".join([*lines, f"return [{','.join(outputs)}]"])
    return f"def evaluate({names}):\n {body}\n"


def _unpacked_arguments(trace: Trace, texts: dict[int, str]) -> list[str]:
    needed = set(trace.needed())
    lines = []
    for number, argument in enumerate(trace.arguments):
        indices = [component.index for component in argument if isinstance(component, Expression)]
        if needed.isdisjoint(indices):
            continue
        texts.update((index, f"v{index}") for index in indices)
        lines.append(f"{','.join(texts[index] for index in indices)},=a{number}")
    return lines


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
