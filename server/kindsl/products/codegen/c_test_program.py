"""A program that compares a library in C with numbers computed when it was generated."""

from collections.abc import Iterable

from kindsl.mechanics.dynamics.generation.function import Function
from kindsl.mechanics.spatial.arrays import Array
from kindsl.products.codegen.c_text import EXTERNAL, real, stamp_comment
from kindsl.products.codegen.filling import fill, template
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.reference import Reference
from kindsl.products.codegen.resistance import magnification

# Of the greatest number of a result, or of one.
TOLERANCES = {"double": 1e-9, "float": 2e-3}
# A body adds no more roundings to a result than this; the worst of 70 random trees has 6 a body.
ROUNDINGS_PER_BODY = 30
ROUNDINGS = {"double": 2.0**-53, "float": 2.0**-24}


def test_program(library: Library, reference: Reference, include: str) -> str:
    """Return the program.

    Args:
        library: The functions under test.
        reference: The right answers.
        include: The lines that include the library.
    """
    p, number = library.prefix, real(library)
    tests = [_test(library, reference, function) for function in library.all_functions]
    used = sorted({name for function in library.all_functions for name, _ in function.arguments})
    if any(function.loaded is not None for function in library.all_functions):
        used.append(EXTERNAL)
    values = "\n".join(_array(number, name, reference.values[name]) for name in used)
    given = "\n".join(
        f"    parameters.{library.parameter_names[name]} = ({number}){value!r};"
        for name, value in reference.parameters.items()
    )
    names = library.function_names.values()
    calls = "\n".join(f"    failures += {p}_test_{name}(&model);" for name in names)
    summary = f"Compares the library of {library.robot_name} with reference numbers."
    return fill(
        template("test_program.c"),
        STAMP=stamp_comment(library, summary),
        INCLUDE=include,
        VALUES=values,
        REAL=number,
        TESTS="".join(tests),
        PREFIX=p,
        GIVEN=given,
        CALLS=calls,
    )


def _test(library: Library, reference: Reference, function: Function) -> str:
    number, name = real(library), library.function_names[function.key]
    results, tolerance = function.results, _tolerance(library, reference, function)
    lines = [f"    {number} {r.name}_[{len(r.entries)}];" for r in results]
    lines.append("    int failures = 0;")
    arguments = ["model", *(argument.name for argument in function.arguments)]
    tables, cases = [], [("", "NULL", reference.results(function))]
    if function.loaded is not None:
        cases.append((" with forces", EXTERNAL, reference.loaded_results(function)))
    for suffix, external, answers in cases:
        given = [*arguments, *([external] if function.loaded is not None else [])]
        call = ", ".join([*given, *(f"{r.name}_" for r in results)])
        lines.append(f"    {library.prefix}_{name}({call});")
        for result, answer in zip(results, answers, strict=True):
            table = f"{name}_{result.name}{suffix.replace(' ', '_')}"
            tables.append(_array("double", table, answer))
            what = f'"{name}: {result.name}{suffix}"'
            lines.append(
                f"    failures += differs({what}, {result.name}_, {table}, {len(result.entries)}, "
                f"{tolerance:.1e});"
            )
    head = f"static int {library.prefix}_test_{name}(const {library.prefix}_model *model)"
    body = "\n".join([*lines, "    return failures;"])
    return "\n".join([*tables, "", f"{head}\n{{\n{body}\n}}\n\n"])


def _tolerance(library: Library, reference: Reference, function: Function) -> float:
    """Return what rounding may change a result by, relative to its greatest number or to one."""
    kind = library.options.real
    bodies = reference.mechanics.bodies
    M = reference.mechanics.joint_space_inertia(reference.values["q"])
    roundings = ROUNDINGS_PER_BODY * (bodies.n_links + 1)
    magnified = magnification(function.name, M, bodies.n_links) * ROUNDINGS[kind]
    found = min(TOLERANCES["float"], roundings * magnified)
    # Of long chains accelerations are worth less than other numbers in double.
    return max(TOLERANCES["double"], found) if kind == "double" else found


def _array(number: str, name: str, values: Array) -> str:
    flat = values.ravel().tolist()
    cast = "" if number == "double" else f"({number})"
    lines = [", ".join(f"{cast}{x!r}" for x in flat[k : k + 4]) for k in range(0, len(flat), 4)]
    rows = ",\n    ".join(lines)
    return f"static const {number} {name}[{len(flat)}] = {{\n    {rows}}};"


def parameter_values(defaults: Iterable[tuple[str, float | None]]) -> dict[str, float]:
    """Return values of parameters to test with: the defaults, any others where unbound."""
    return {
        name: 0.3 + 0.05 * number if value is None else value
        for number, (name, value) in enumerate(defaults)
    }
