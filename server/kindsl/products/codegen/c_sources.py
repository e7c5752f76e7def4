"""The sources of a library in C: one file a quantity, and one for parameters and names."""

from collections.abc import Iterator, Sequence

from kindsl.mechanics.dynamics.generation.emitters.c import CBody, c_definition, literal
from kindsl.mechanics.dynamics.generation.emitters.lanes import (
    is_worth_lanes,
    prefixed,
    shared,
    wide_functions,
    wide_loop,
)
from kindsl.mechanics.dynamics.generation.emitters.loops import loop_call, loops_text
from kindsl.mechanics.dynamics.generation.function import Function
from kindsl.mechanics.dynamics.generation.terms import Scalar, Term
from kindsl.products.codegen.c_text import (
    EXTERNAL,
    batch_declaration,
    dialect,
    macro,
    parameters,
    real,
    stamp_comment,
)
from kindsl.products.codegen.filling import fill, template
from kindsl.products.codegen.library import Library


def sources(library: Library) -> Iterator[tuple[str, str]]:
    """Yield name and text of each file."""
    p = library.prefix
    includes = f'#include "{p}.h"\n\n#include <math.h>\n#include <stddef.h>\n\n'
    summary = f"Parameters and names of {library.robot_name}."
    head = f"{stamp_comment(library, summary)}{includes}{noinline(library)}\n"
    yield f"{p}_model.c", f"{head}{model_source(library)}"
    if has_lanes(library):
        about = stamp_comment(library, "What batches share; for the sources beside it alone.")
        yield f"{p}_lanes.h", f"{about}{shared(p)}"
    if library.has_loops:
        about = stamp_comment(
            library, "What long functions share; for the sources beside it alone."
        )
        yield f"{p}_loops.h", f"{about}{includes}{loops_source(library)}"
    for quantity, functions in library.functions.items():
        summary = f"Of {library.robot_name}: {quantity.replace('_', ' ')}."
        lanes = f'#include "{p}_lanes.h"\n\n' if has_lanes(library) else ""
        if any(function.is_loop for function in functions):
            lanes += f'#include "{p}_loops.h"\n\n'
        head = f"{stamp_comment(library, summary)}{includes}{lanes}{noinline(library)}\n"
        yield f"{p}_{quantity}.c", f"{head}{quantity_source(library, functions)}"


def loops_source(library: Library) -> str:
    """Return the code that long functions share."""
    places = {value.index: place for place, value in enumerate(library.setup)}

    def text(value: Term) -> str:
        return f"m->c[{places[value.index]}]"

    model = f"const {library.prefix}_model *m, "
    return loops_text(library.robot.tree, dialect(library), f"{library.prefix}_", model, text)


def noinline(library: Library) -> str:
    """Return the macro that keeps parts of long functions apart."""
    name = f"{macro(library)}_NOINLINE"
    return (
        f"#ifndef {name}\n#if defined(__GNUC__)\n#define {name} __attribute__((noinline))\n"
        f"#else\n#define {name}\n#endif\n#endif\n"
    )


def model_source(library: Library) -> str:
    """Return the code that sets parameters up."""
    p, number = library.prefix, real(library)
    names = list(library.parameter_names.values()) or ["none"]
    defaults = [library.defaults[name] for name in library.parameter_names] or [0.0]
    style = dialect(library)
    values = [f"({number})NAN" if v is None else literal(v, style) for v in defaults]
    fields = "\n".join(
        f"    parameters.{name} = {value};" for name, value in zip(names, values, strict=True)
    )
    known = {
        parameter.index: f"parameters->{library.parameter_names[name]}"
        for name, parameter in library.robot.parameters.items()
    }
    constants: dict[str, Sequence[Scalar]] = {"c": library.setup or [0.0]}
    context = ("parameters", f"const {p}_parameters *parameters")
    setup = c_definition(
        library.robot.graph, CBody(f"{p}_set_up", {}, constants, known, context), style, "static "
    )
    joints = ", ".join(f'"{name}"' for name in library.robot.joint_names)
    return fill(
        template("model.c"), PREFIX=p, MACRO=macro(library), FIELDS=fields, SETUP=setup,
        DEFAULT=_default_model(library), JOINTS=joints,
    )  # fmt: skip


def _default_model(library: Library) -> str:
    if not library.is_bound:
        return ""
    style = dialect(library)
    values = ", ".join(literal(value, style) for value in library.setup_values or [0.0])
    p = library.prefix
    return f"const {p}_model {p}_default_model = {{{{{values}}}}};\n\n"


def quantity_source(library: Library, functions: Sequence[Function]) -> str:
    """Return the code of some functions."""
    return "\n".join(
        f"{_definition(library, function)}\n{_batch(library, function)}" for function in functions
    )


def _definition(library: Library, function: Function) -> str:
    name = f"{library.prefix}_{library.function_names[function.key]}"
    style, graph = dialect(library), library.robot.graph
    declared = parameters(library, function, "restrict ")
    head = f"void {name}({', '.join(declared.values())})"
    if function.is_loop:
        return f"{head}\n{{\n{loop_call(function, style, f'{library.prefix}_', 'm')}}}\n"
    takes: dict[str, Sequence[Scalar]] = {a.name: a.components for a in function.arguments}
    known = {value.index: f"m->c[{place}]" for place, value in enumerate(library.setup)}
    context = ("m", declared.pop("m"))
    if function.loaded is None:
        gives = {r.name: r.entries for r in function.results}
        body = CBody(name, takes, gives, known, context, declared=declared)
        return c_definition(graph, body, style)
    takes[EXTERNAL], gives = library.external, {r.name: r.entries for r in function.loaded}
    body = CBody(f"{name}_loaded", takes, gives, known, context)
    loaded = c_definition(graph, body, style, "static ")
    # Forces that are zero cost at most a tenth of the time, a function without them the text again.
    zeros = f"static const {real(library)} none[{len(library.external)}] = {{0}};"
    given = ", ".join(f"{n} != NULL ? {n} : none" if n == EXTERNAL else n for n in ("m", *declared))
    return f"{loaded}\n{head}\n{{\n    {zeros}\n    {name}_loaded({given});\n}}\n"


def has_lanes(library: Library) -> bool:
    """Return whether batches are computed in lanes, which hold numbers in double."""
    return library.options.real == "double"


def _batch(library: Library, function: Function) -> str:
    name = f"{library.prefix}_{library.function_names[function.key]}"
    arguments = ["m"]
    for argument in function.arguments:
        is_shared = argument.name == "g"
        stride = len(argument.components)
        arguments.append(argument.name if is_shared else f"{argument.name} + i * {stride}")
    if function.loaded is not None:
        stride = len(library.external)
        arguments.append(f"{EXTERNAL} != NULL ? {EXTERNAL} + i * {stride} : NULL")
    arguments += [f"{r.name} + i * {len(r.entries)}" for r in function.results]
    loop = f"    for (; i < n; i++) {{\n        {name}({', '.join(arguments)});\n    }}\n"
    wide, wide_loop = _lanes(library, function) if _is_wide(library, function) else ("", "")
    return (
        f"{wide}{batch_declaration(library, function)}\n{{\n    long i = 0;\n{wide_loop}{loop}}}\n"
    )


def _is_wide(library: Library, function: Function) -> bool:
    if function.is_loop:
        return False
    entries = [entry for result in function.results for entry in result.entries]
    takes_angles = [argument.name for argument in function.arguments][:1] == ["q"]
    # A Jacobian may depend on no joint at all; lanes would be empty then.
    is_apt = takes_angles and not function.name.startswith("jacobian_")
    return has_lanes(library) and is_apt and is_worth_lanes(library.robot.graph, entries)


def _lanes(library: Library, function: Function) -> tuple[str, str]:
    """Return a function for several configurations, and the statements that call it for all."""
    name = library.function_names[function.key]
    wide = CBody(
        name,
        {argument.name: argument.components for argument in function.arguments},
        {result.name: result.entries for result in function.results},
        {value.index: f"spread(m->c[{place}])" for place, value in enumerate(library.setup)},
        ("m", f"const {library.prefix}_model *m"),
    )
    text = wide_functions(library.robot.graph, wide, f"{macro(library)}_NOINLINE ")
    sizes = {array: len(x) for array, x in {**wide.takes, **wide.gives}.items()}
    rows = {a: f"{a} + i * {sizes[a]}, {sizes[a]}" for a in wide.takes if a != "g"}
    stores = [f"scatter({a} + i * {sizes[a]}, {a}_lanes, {sizes[a]}, width);" for a in wide.gives]
    condition = f"i < n && {EXTERNAL} == NULL" if function.loaded is not None else "i < n"
    texts = f"{text}#endif\n\n", f"{wide_loop(wide, rows, stores, condition)}#endif\n"
    first, second = (prefixed(f"#if defined(LANES)\n{t}", library.prefix) for t in texts)
    return first, second
