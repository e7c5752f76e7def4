"""Writes functions in C for several configurations at once, in the lanes of wide registers."""

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from kindsl.mechanics.dynamics.generation.emitters.c import CBody, Dialect, c_definition
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar, Term, operations

_SHARED = Path(__file__).with_name("lanes.c")
_NAMES = re.compile(
    r"\b(LANES|NO_LANES|LARGEST_ANGLE|MIXED|(?:FIRST|SECOND)_IN_TURNS|lanes|bits|spread|signs|"
    r"small_sine_and_cosine|sines_and_cosines|transpose|gather|scatter)\b"
)

# In lanes is neither what costs less than to write it down, nor what takes compilers long or fills
# the stack.
LEAST_IN_LANES = 100
LEAST_PER_ENTRY = 1.5
MOST_OPERATIONS = 10_000
MOST_IN_LANES = 4096


def is_worth_lanes(graph: Graph, entries: Sequence[Scalar]) -> bool:
    """Return whether batches of a function gain from lanes and compilers take them in."""
    least = max(LEAST_IN_LANES, LEAST_PER_ENTRY * len(entries))
    count = operations(graph, entries)
    return len(entries) <= MOST_IN_LANES and least <= count <= MOST_OPERATIONS


def shared(prefix: str = "") -> str:
    """Return the text that all functions for lanes need; what it names gets a prefix."""
    text = _SHARED.read_text(encoding="utf-8")
    return prefixed(text, prefix) if prefix else text


def prefixed(text: str, prefix: str) -> str:
    """Return a text in which the names of lanes have a prefix, macros' in capitals."""
    return _NAMES.sub(lambda m: f"{prefix.upper() if m[0].isupper() else prefix}_{m[0]}", text)


def wide_functions(graph: Graph, body: CBody, noinline: str) -> str:
    """Return `constants_NAME(results)` and `wide_NAME(arguments, cosines, sines, results)`.

    Args:
        graph: Where values are recorded.
        body: The function by its name, joint positions first; `known` is alike for all lanes.
        noinline: The prefix of a function that is to stay one.
    """
    angles = [x for x in next(iter(body.takes.values())) if isinstance(x, Term)]
    trigonometry = {
        "cosines": [graph.record("cos", x.index) for x in angles],
        "sines": [graph.record("sin", x.index) for x in angles],
    }
    dialect = Dialect("lanes", "", noinline, "spread({})", "signs({})")
    varying, constant = (
        {
            name: [e if isinstance(e, Term) == varies else None for e in entries]
            for name, entries in body.gives.items()
        }
        for varies in (True, False)
    )
    takes = {**body.takes, **trigonometry}
    bodies = (
        CBody(f"constants_{body.name}", {}, constant),
        body._replace(name=f"wide_{body.name}", takes=takes, gives=varying),
    )
    return "\n".join(c_definition(graph, each, dialect, "static ") for each in bodies)


def wide_loop(
    body: CBody, rows: Mapping[str, str], stores: Sequence[str], condition: str = "i < n"
) -> str:
    """Return the statements that compute configurations from `i` on, `width` at a time.

    Args:
        body: What `wide_functions` computes.
        rows: Where each argument's row `i` begins, and how far rows lie apart; others are shared.
        stores: What is done with the results, which are `NAME_lanes`.
        condition: While it holds there are further configurations.
    """
    angles, *_ = body.takes
    n, arrays = len(body.takes[angles]), {**body.takes, **body.gives}
    context = [body.context[0]] if body.context else []
    results = ", ".join(f"{name}_lanes" for name in body.gives)
    given = ", ".join([*context, *(f"{name}_lanes" for name in body.takes), "cosines", "sines"])
    lines = [f"lanes {name}_lanes[{len(x)}];" for name, x in arrays.items()]
    lines += [f"lanes cosines[{n}], sines[{n}];", f"constants_{body.name}({results});"]
    for name, x in body.takes.items():
        if name not in rows:
            lines += [f"{name}_lanes[{k}] = spread({name}[{k}]);" for k in range(len(x))]
    lines += [
        f"for (; {condition}; i += LANES) {{",
        "    const ptrdiff_t width = n - i < LANES ? n - i : LANES;",
        *(f"    gather({name}_lanes, {row}, {len(body.takes[name])}, width);"
          for name, row in rows.items()),
        f"    sines_and_cosines({angles}_lanes, sines, cosines, {n});",
        f"    wide_{body.name}({given}, {results});",
        *(f"    {store}" for store in stores),
        "}",
    ]  # fmt: skip
    return "".join(f"    {line}\n" for line in lines)
