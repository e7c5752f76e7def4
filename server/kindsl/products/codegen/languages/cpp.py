"""A header in C++14 with Eigen's types, a template of the type of numbers."""

import re
from collections.abc import Sequence

from kindsl.mechanics.dynamics.generation.emitters.c import CBody, Dialect, c_definition
from kindsl.mechanics.dynamics.generation.emitters.loops import loop_call, loops_text
from kindsl.mechanics.dynamics.generation.function import Function, Result
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.products.codegen.c_test_program import test_program
from kindsl.products.codegen.c_text import EXTERNAL, cmake_lists, stamp_comment
from kindsl.products.codegen.filling import fill, template
from kindsl.products.codegen.language import COMMON_OPTIONS, Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.readme import readme
from kindsl.products.codegen.reference import Reference

# The argument that holds what parameters decide.
CONSTANTS = "constants"
DIALECT = Dialect("S", sign="", number="S({})", scope="detail::", parameter="S", scalar="S")


def cpp_header(library: Library) -> str:
    """Return the header."""
    functions = _functions(library)
    methods = "\n".join(_methods(library, function) for function in library.all_functions)
    bound = "    BasicModel() { set(Parameters()); }\n" if library.is_bound else ""
    fields = "".join(f"    double {n} = {v};\n" for n, v in _defaults(library).items())
    given = "".join(f"parameters.{name}, " for name in library.parameter_names.values())
    values = f"const double given[] = {{{given[:-2]}}};" if given else ""
    n_given, n_constants = len(library.parameter_names), len(library.setup)
    setting = (
        f"        {values}\n        S p[{n_given}];\n"
        f"        for (int i = 0; i < {n_given}; i++) {{\n"
        "            p[i] = S(given[i]);\n        }\n"
        "        detail::set_up(p, c_);\n"
    )
    return fill(
        template("library.hpp"),
        STAMP=stamp_comment(library, f"{library.robot_name} in C++14, with Eigen."),
        PREFIX=library.prefix,
        NJ=len(library.robot.joint_names),
        NV=library.robot.n_velocities,
        NB=len(library.body_names),
        FIELDS=fields,
        SIGN=template("sign.hpp") if "detail::sign(" in functions else "",
        FUNCTIONS=functions,
        BOUND=bound,
        SETTING=setting if given and n_constants else "        (void)parameters;\n",
        METHODS=methods,
        SIZE=max(1, n_constants),
        REAL=library.options.real,
    )


def _defaults(library: Library) -> dict[str, str]:
    nothing = "std::numeric_limits<double>::quiet_NaN()"
    return {
        safe: nothing if library.defaults[name] is None else repr(library.defaults[name])
        for name, safe in library.parameter_names.items()
    }


def _functions(library: Library) -> str:
    """Return the functions of pointers, of all that parameters decide first."""
    graph, constants = library.robot.graph, list[Scalar](library.setup)
    parameters: list[Scalar] = [*library.robot.parameters.values()]
    texts = []
    if library.has_loops:
        places = {value.index: f"{CONSTANTS}[{k}]" for k, value in enumerate(library.setup)}
        given = f"const S* {CONSTANTS}, "
        texts.append(loops_text(library.robot.tree, DIALECT, "", given, lambda x: places[x.index]))
    if parameters and constants:
        body = CBody("set_up", {"p": parameters}, {CONSTANTS: constants})
        texts.append(c_definition(graph, body, DIALECT))
    for function in library.all_functions:
        name = library.function_names[function.key]
        takes: dict[str, Sequence[Scalar]] = {CONSTANTS: constants}
        takes |= {argument.name: argument.components for argument in function.arguments}
        if function.loaded is not None:
            takes[EXTERNAL] = library.external
        gives = {r.name: r.entries for r in function.loaded or function.results}
        body = CBody(name, takes, gives)
        if function.is_loop:
            declared = ", ".join(DIALECT.declarations(body).values())
            statements = loop_call(function, DIALECT, "", CONSTANTS)
            texts.append(f"{DIALECT.template}void {name}({declared})\n{{\n{statements}}}\n")
        else:
            texts.append(c_definition(graph, body, DIALECT))
    return "\n".join(texts)


def _load(function: Function) -> list[str]:
    """Return the name of the external forces where these matter."""
    return [EXTERNAL] if function.loaded is not None else []


def _methods(library: Library, function: Function) -> str:
    """Return a function of pointers, and one of Eigen's vectors."""
    name, load = library.function_names[function.key], _load(function)
    names = [argument.name for argument in function.arguments]
    results = [result.name for result in function.results]
    declared = [f"const S* {n}" for n in names + load] + [f"S* {n}" for n in results]
    zeros = f"        static const S none[{len(library.external)}] = {{}};\n" if load else ""
    given = [f"{n} != nullptr ? {n} : none" for n in load]
    call = f"detail::{name}({', '.join(['c_', *names, *given, *results])});"
    raw = f"    void {name}({', '.join(declared)}) const\n    {{\n{zeros}        {call}\n    }}\n"
    return f"{raw}{_of_vectors(function, name)}"


def _of_vectors(function: Function, name: str) -> str:
    takes = [f"const Vector<{len(a.components)}>& {a.name}" for a in function.arguments]
    passed = [f"{argument.name}.data()" for argument in function.arguments]
    load = []
    if function.loaded is not None:
        passed.append(
            f"{EXTERNAL} != nullptr ? {EXTERNAL}->data() : static_cast<const S*>(nullptr)"
        )
        load = [f"const ExternalForces* {EXTERNAL} = nullptr"]
    passed += [f"{result.name}.data()" for result in function.results]
    call = f"{name}({', '.join(passed)});"
    head = f"    /* {function.summary[0].upper()}{function.summary[1:]}. */\n"
    if len(function.results) == 1:
        (result,) = function.results
        kind = _type(result)
        return (
            f"{head}    {kind} {name}({', '.join([*takes, *load])}) const\n    {{\n"
            f"        {kind} {result.name};\n        {call}\n"
            f"        return {result.name};\n    }}\n"
        )
    gives = [f"{_type(result)}& {result.name}" for result in function.results]
    return (
        f"{head}    void {name}({', '.join([*takes, *gives, *load])}) const\n    {{\n"
        f"        {call}\n    }}\n"
    )


def _type(result: Result) -> str:
    """Return the type of a result; poses are one below the other."""
    *outer, columns = (*result.shape, 1) if len(result.shape) == 1 else result.shape
    rows = 1
    for dimension in outer:
        rows *= dimension
    return f"Matrix<{rows}, {columns}>"


def _test(library: Library, reference: Reference) -> str:
    """Return the test program of C, which calls a model's functions of pointers."""
    p = library.prefix
    calls = "".join(
        f"template <class... A>\nvoid {p}_{name}(const {p}_model *m, A... a)\n"
        f"{{\n    m->{name}(a...);\n}}\n"
        for name in library.function_names.values()
    )
    include = fill(template("test_model.hpp"), PREFIX=p, CALLS=calls)
    text = test_program(library, reference, include)
    start = f"{p}_model model" + ("" if library.is_bound else f"{{{p}_parameters()}}")
    return re.sub(r"\bNULL\b", "nullptr", text).replace(f"    {p}_model model;", f"    {start};")


def _files(library: Library, reference: Reference) -> dict[str, str]:
    given = "" if library.is_bound else "(parameters)"
    usage = fill(template("usage/cpp.md"), PREFIX=library.prefix, GIVEN=given)
    return {
        f"{library.prefix}.hpp": cpp_header(library),
        f"{library.prefix}_test.cpp": _test(library, reference),
        "CMakeLists.txt": cmake_lists(library, "CXX", f"{library.prefix}.hpp"),
        "README.md": readme(library, usage),
    }


LANGUAGE = Language(_files, COMMON_OPTIONS | {"--real"}, has_loops=True)
