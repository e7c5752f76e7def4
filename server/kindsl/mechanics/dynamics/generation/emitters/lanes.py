"""Writes functions in C for several configurations at once, in the lanes of wide registers."""

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

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


class Wide(NamedTuple):
    """A function for lanes.

    Attributes:
        name: What follows `constants_` and `wide_` in the names of its two parts.
        takes: The components of its arguments by their names, joint positions first.
        gives: The entries of its results by their names.
        known: Texts of nodes that are given otherwise, for all lanes alike.
        context: Name and declaration of a parameter that `known` reads, if any.
    """

    name: str
    takes: Mapping[str, Sequence[Scalar]]
    gives: Mapping[str, Sequence[Scalar]]
    known: Mapping[int, str] = {}
    context: tuple[str, str] | None = None


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


def wide_functions(graph: Graph, wide: Wide, noinline: str) -> str:
    """Return `constants_NAME(results)` and `wide_NAME(arguments, cosines, sines, results)`."""
    angles = [x for x in next(iter(wide.takes.values())) if isinstance(x, Term)]
    trigonometry = {
        "cosines": [graph.record("cos", x.index) for x in angles],
        "sines": [graph.record("sin", x.index) for x in angles],
    }
    dialect = Dialect("lanes", "", noinline, "spread({})", "signs({})")
    takes = dialect.arrays({**wide.takes, **trigonometry}, are_given=True)
    gives = dialect.arrays(wide.gives, are_given=False)
    varying, constant = (
        [
            a._replace(entries=[e if isinstance(e, Term) == varies else None for e in a.entries])
            for a in gives
        ]
        for varies in (True, False)
    )
    bodies = (
        CBody(f"constants_{wide.name}", [], constant),
        CBody(f"wide_{wide.name}", takes, varying, wide.known, wide.context),
    )
    return "\n".join(c_definition(graph, body, dialect, "static ") for body in bodies)


def wide_loop(
    wide: Wide, rows: Mapping[str, str], stores: Sequence[str], condition: str = "i < n"
) -> str:
    """Return the statements that compute configurations from `i` on, `width` at a time.

    Args:
        wide: What `wide_functions` computes.
        rows: Where each argument's row `i` begins, and how far rows lie apart; others are shared.
        stores: What is done with the results, which are `NAME_lanes`.
        condition: While it holds there are further configurations.
    """
    angles, *_ = wide.takes
    n, arrays = len(wide.takes[angles]), {**wide.takes, **wide.gives}
    context = [wide.context[0]] if wide.context else []
    results = ", ".join(f"{name}_lanes" for name in wide.gives)
    given = ", ".join([*context, *(f"{name}_lanes" for name in wide.takes), "cosines", "sines"])
    lines = [f"lanes {name}_lanes[{len(x)}];" for name, x in arrays.items()]
    lines += [f"lanes cosines[{n}], sines[{n}];", f"constants_{wide.name}({results});"]
    for name, x in wide.takes.items():
        if name not in rows:
            lines += [f"{name}_lanes[{k}] = spread({name}[{k}]);" for k in range(len(x))]
    lines += [
        f"for (; {condition}; i += LANES) {{",
        "    const ptrdiff_t width = n - i < LANES ? n - i : LANES;",
        *(f"    gather({name}_lanes, {row}, {len(wide.takes[name])}, width);"
          for name, row in rows.items()),
        f"    sines_and_cosines({angles}_lanes, sines, cosines, {n});",
        f"    wide_{wide.name}({given}, {results});",
        *(f"    {store}" for store in stores),
        "}",
    ]  # fmt: skip
    return "".join(f"    {line}\n" for line in lines)
