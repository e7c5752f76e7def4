"""Writes functions as a CPython extension that reads and fills NumPy arrays."""

import json
import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.emitters.c import CBody, Dialect, c_definition
from kindsl.mechanics.dynamics.generation.emitters.lanes import shared, wide_functions, wide_loop
from kindsl.mechanics.dynamics.generation.emitters.loops import loop_call, loops_text
from kindsl.mechanics.dynamics.generation.function import Function, Result
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar
from kindsl.mechanics.dynamics.generation.tree import Tree

MODULE = "compiled_mechanism"
RUNTIME = Path(__file__).with_name("extension_runtime.c")
TABLES = Path(__file__).with_name("extension_module.c")
PLAIN = Dialect("double", "", "KEPT_APART ")


class KernelArgument(NamedTuple):
    """A vector that a kernel takes.

    Attributes:
        name: Its keyword.
        components: The inputs of the graph; none for one that only Python may refuse.
        default: The value for None, in C; None for a required argument.
    """

    name: str
    components: Sequence[Scalar]
    default: str | None = None


class Kernel(NamedTuple):
    """One function of the extension.

    Attributes:
        arguments: Its arguments; the first is joint positions.
        accelerates: Whether a result that is not finite means that nothing resists a motion.
        is_wide: Whether batches are computed in lanes.
        documentation: What `help` shows, as CPython reads it.
        loop: What loops over bodies compute, with the names of its arguments; None for others.
    """

    name: str
    arguments: Sequence[KernelArgument]
    results: Sequence[Result]
    accelerates: bool
    is_wide: bool
    documentation: str | None = None
    loop: tuple[Function, Sequence[str]] | None = None


def extension_source(
    graph: Graph, tree: Tree, kernels: Sequence[Kernel], gravity: Sequence[float]
) -> str:
    """Return the source of a module with a function `bind(name, python, class, batches)`.

    It returns a function that answers as far as it can, and else calls `python`.

    Args:
        graph: Where the kernels are recorded.
        tree: Of the mechanism, all of whose numbers are known.
        kernels: Its functions.
        gravity: The default `GRAVITY`.
    """
    numbers = ", ".join(map(repr, gravity))
    texts = [
        RUNTIME.read_text(encoding="utf-8").replace("@LANES@", shared()),
        "#if defined(__GNUC__)\n#define KEPT_APART __attribute__((noinline))\n"
        "#else\n#define KEPT_APART\n#define restrict __restrict\n#endif\n",
        f"static const double GRAVITY[3] = {{{numbers}}};\n",
        loops_text(tree, PLAIN, "", "", repr) if any(kernel.loop for kernel in kernels) else "",
        *(_kernel_text(graph, number, kernel) for number, kernel in enumerate(kernels)),
        _tables(kernels),
    ]
    return "\n".join(texts)


def _kernel_text(graph: Graph, number: int, kernel: Kernel) -> str:
    """Return the code of one kernel: for one configuration and for many."""
    takes, gives = _named(kernel)
    body = CBody(f"scalar_{number}", takes, gives)
    places = [f"in[{i}]" for i, _ in _given(kernel)] + [f"out[{i}]" for i in range(len(gives))]
    many = _many(number, kernel)
    if kernel.loop is None:
        scalar = c_definition(graph, body, PLAIN, "static ")
    else:
        scalar = _loop(body, *kernel.loop)
    return f"""\
{scalar}
static void run_{number}(const double *const *in, double *const *out)
{{
    scalar_{number}({", ".join(places)});
}}

{_wide(graph, number, kernel) if kernel.is_wide else ""}
static void run_many_{number}(npy_intp n, const double *const *in, const npy_intp *strides,
                              double *const *out)
{{
    npy_intp i = 0;
{many}}}
"""


def _loop(body: CBody, function: Function, names: Sequence[str]) -> str:
    """Return a function that loops compute; names are those of its arguments in the text."""
    texts = dict(zip(names, body.takes, strict=True))
    texts |= {r.name: name for r, name in zip(function.results, body.gives, strict=True)}
    declared = ", ".join(PLAIN.declarations(body).values())
    statements = loop_call(function, PLAIN, "", "", texts)
    return f"static void {body.name}({declared})\n{{\n{statements}}}\n"


def _many(number: int, kernel: Kernel) -> str:
    given = [f"in[{i}] + i * strides[{i}]" for i, _ in _given(kernel)]
    given += [f"out[{i}] + i * {len(r.entries)}" for i, r in enumerate(kernel.results)]
    loop = f"    for (; i < n; i++) {{\n        scalar_{number}({', '.join(given)});\n    }}\n"
    if not kernel.is_wide:
        return loop
    rows = {f"a{i}": f"in[{i}] + i * strides[{i}], strides[{i}]" for i, _ in _given(kernel)}
    stores = [
        f"scatter(out[{i}] + i * {len(r.entries)}, o{i}_lanes, {len(r.entries)}, width);"
        for i, r in enumerate(kernel.results)
    ]
    wide = wide_loop(CBody(str(number), *_named(kernel)), rows, stores)
    return f"#if defined(LANES)\n{wide}#else\n{loop}#endif\n"


def _wide(graph: Graph, number: int, kernel: Kernel) -> str:
    text = wide_functions(graph, CBody(str(number), *_named(kernel)), PLAIN.noinline)
    return f"#if defined(LANES)\n{text}#endif\n"


def _named(kernel: Kernel) -> tuple[dict[str, Sequence[Scalar]], dict[str, Sequence[Scalar]]]:
    """Return what a kernel takes and gives, by the names in its text."""
    takes = {f"a{i}": argument.components for i, argument in _given(kernel)}
    return takes, {f"o{i}": result.entries for i, result in enumerate(kernel.results)}


def _given(kernel: Kernel) -> list[tuple[int, KernelArgument]]:
    """Return the arguments that matter, with their positions."""
    return [(i, a) for i, a in enumerate(kernel.arguments) if a.components]


def _tables(kernels: Sequence[Kernel]) -> str:
    rows = ",\n".join(_row(number, kernel) for number, kernel in enumerate(kernels))
    names = "".join(
        f'#define KERNELS_NAME_{i} "{k.name}"\n'
        f"#define KERNELS_HELP_{i} {json.dumps(k.documentation) if k.documentation else 'NULL'}\n"
        for i, k in enumerate(kernels)
    )
    entries = "".join(f"ENTRY({i})\n" for i in range(len(kernels)))
    methods = ",\n    ".join(f"METHOD({i})" for i in range(len(kernels)))
    texts = {
        "COUNT": str(len(kernels)), "ROWS": rows, "NAMES": names, "ENTRIES": entries,
        "METHODS": methods, "MODULE": MODULE,
    }  # fmt: skip
    return re.sub(r"@(\w+)@", lambda m: texts[m[1]], TABLES.read_text(encoding="utf-8"))


def _row(number: int, kernel: Kernel) -> str:
    arguments, results = kernel.arguments, kernel.results
    shapes = ", ".join(f"{{{', '.join(map(str, r.shape)) or '0'}}}" for r in results)
    return f"""\
    {{"{kernel.name}", {len(arguments)}, {int(kernel.accelerates)}, {len(results)},
     {{{", ".join(f'"{a.name}"' for a in arguments)}}},
     {{{", ".join(str(len(a.components)) for a in arguments)}}},
     {{{", ".join(a.default or "NULL" for a in arguments)}}},
     {{{", ".join(str(len(r.shape)) for r in results)}}}, {{{shapes}}},
     {{{", ".join(str(len(r.entries)) for r in results)}}}, run_{number}, run_many_{number}}}"""
