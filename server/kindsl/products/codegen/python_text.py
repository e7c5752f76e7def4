"""Text that generated modules in Python share, whatever they compute with."""

from collections.abc import Collection, Iterator

from kindsl.mechanics.dynamics.generation.emitters.python_lines import python_function
from kindsl.mechanics.dynamics.generation.function import Function
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.quantities import KEYWORDS, STANDARD_GRAVITY
from kindsl.products.codegen.filling import template
from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library

EXTERNAL = "external_forces"


def python_language(how: str, own: tuple[str, ...]) -> Language:
    """Return a language whose library is one module; the arguments are those of `module_text`."""
    return Language(
        lambda library, _: {f"{library.prefix}.py": module_text(library, how, own)},
        renamed=lambda library: library.renamed_in_python,
    )


def module_text(
    library: Library, how: str, own: tuple[str, ...], without: Collection[str] = ()
) -> str:
    """Return a whole module.

    Args:
        how: Requirements and use of the module, for its docstring.
        own: Its imports, the template of its `forward_kinematics`, and those of its `_answer`.
        without: The functions whose code on components is not written.
    """
    imports, *templates = own
    poses, *texts = (template(f"python/{t}.txt") + "\n" for t in (*templates, "parameters"))
    parts = [
        docstring(library, how), imports, constants(library), "", *texts,
        *(public_function(library, function) + "\n" for function in library.all_functions),
    ]  # fmt: skip
    if "poses" in library.functions:
        parts.append(poses)
    if "jacobians" in library.functions:
        parts += [jacobian_table(library), "", template("python/jacobian.txt"), ""]
    return "\n".join([*parts, *(text + "\n" for text in straight_lines(library, without))])


def docstring(library: Library, how: str) -> str:
    """Return the text that a module begins with."""
    stamp = library.stamp
    return f'''\
"""Kinematics and dynamics of {library.robot_name}.

{stamp.origin}
{stamp.licence}
SHA-256 of the document: {stamp.sha256}
Options: {stamp.options}

{how}
SI units and radians, angular part first, base coordinates; a floating base's six rows and columns
come first. Joints are in the order of `JOINTS`. External forces are
a wrench on each of `BODIES` in its own coordinates, (..., bodies, 6).
"""
'''


def constants(library: Library) -> str:
    """Return names and defaults."""
    robot = library.robot
    targets = tuple(target.name for target in robot.targets)
    return (
        f"JOINTS = {robot.joint_names!r}\n"
        f"BODIES = {(robot.base_name, *robot.link_names)!r}\n"
        f"POSES = {targets!r}\n"
        f"IS_FLOATING = {robot.tree.is_floating}\n"
        f"STANDARD_GRAVITY = {STANDARD_GRAVITY!r}\n"
        "# Values of parameters, None where unbound.\n"
        f"PARAMETERS = {dict(library.defaults)!r}\n"
        f"DOCUMENT_SHA256 = {library.stamp.sha256!r}\n"
    )


def straight_lines(library: Library, without: Collection[str]) -> Iterator[str]:
    """Yield the code of functions, on scalars."""
    parameters: list[Scalar] = [*library.robot.parameters.values()]
    for function in library.all_functions:
        if function.name in without:
            continue
        name = library.function_names[function.key]
        arguments: dict[str, list[Scalar]] = {"p": parameters}
        arguments.update((a.name, [*a.components]) for a in function.arguments)
        results = [result.entries for result in function.results]
        yield python_function(library.robot.graph, f"_{name}", arguments, results)
        if function.loaded is not None:
            loaded = [result.entries for result in function.loaded]
            arguments["fext"] = library.external
            yield python_function(library.robot.graph, f"_{name}_loaded", arguments, loaded)


def public_function(library: Library, function: Function) -> str:
    """Return a function with the arguments of kindsl's own interface."""
    name = library.function_names[function.key]
    names = [KEYWORDS.get(a.name, a.name) for a in function.arguments]
    defaults = {"gravity": "STANDARD_GRAVITY", "base_velocity": "None", "base_acceleration": "None"}
    declared = [f"{n}={defaults[n]}" if n in defaults else n for n in names]
    has_load = function.loaded is not None
    if has_load:
        declared.append(f"{EXTERNAL}=None")
    both = zip(names, function.arguments, strict=True)
    vectors = ", ".join(f"({n}, {len(a.components)})" for n, a in both)
    shapes = tuple(_shape(function, result.shape) for result in function.results)
    call = f"_answer(_{name}, {shapes!r}, parameters, {vectors})"
    loaded = (
        f"    if {EXTERNAL} is not None:\n        return _answer(_{name}_loaded, {shapes!r}, "
        f"parameters, {vectors}, (_flat({EXTERNAL}), {len(library.external)}))\n"
    )
    summary = function.summary[0].upper() + function.summary[1:]
    return (
        f"def {name}({', '.join([*declared, 'parameters=None'])}):\n"
        f'    """{summary}."""\n{loaded if has_load else ""}    return {call}\n'
    )


def _shape(function: Function, shape: tuple[int, ...]) -> tuple[int, ...]:
    return () if function.name in ("kinetic_energy", "potential_energy") else shape


def jacobian_table(library: Library) -> str:
    """Return functions by the names of frames, in own and in base coordinates."""
    tables: dict[str, list[str]] = {"_JACOBIANS": [], "_JACOBIANS_IN_BASE": []}
    for function in library.functions.get("jacobians", ()):
        frame = function.about[0]
        table = "_JACOBIANS" if function.name == f"jacobian_{frame}" else "_JACOBIANS_IN_BASE"
        tables[table].append(f"    {frame!r}: {library.function_names[function.key]},\n")
    return "".join(f"{name} = {{\n{''.join(rows)}}}\n" for name, rows in tables.items())
