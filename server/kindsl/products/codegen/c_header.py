"""The header of a library in C."""

from collections.abc import Mapping

from kindsl.mechanics.dynamics.generation.function import Function
from kindsl.products.codegen.c_text import batch_declaration, declaration, macro, stamp_comment
from kindsl.products.codegen.filling import fill, template
from kindsl.products.codegen.library import Library


def header(library: Library) -> str:
    """Return the header."""
    return fill(
        template("library.h"),
        STAMP=stamp_comment(library, f"Kinematics and dynamics of {library.robot_name}."),
        MACRO=macro(library),
        SHA256=library.stamp.sha256,
        NJ=len(library.robot.joint_names),
        NV=library.robot.n_velocities,
        NB=len(library.body_names),
        NPOSES=len(library.pose_names),
        REAL=library.options.real,
        PREFIX=library.prefix,
        JOINTS=_enumeration(library, "joint", library.joint_names),
        BODIES=_enumeration(library, "body", library.body_names),
        POSES=_enumeration(library, "pose", library.pose_names),
        PARAMETERS=_parameter_struct(library),
        SIZE=max(1, len(library.setup)),
        SETUP=_setup_declarations(library),
        FUNCTIONS=_functions(library),
        BATCHES="".join(f"{batch_declaration(library, f)};\n" for f in library.all_functions),
    )


def _enumeration(library: Library, kind: str, names: Mapping[str, str]) -> str:
    head = f"{macro(library)}_{kind.upper()}"
    values = "".join(f"    {head}_{name} = {i},\n" for i, name in enumerate(names.values()))
    return f"enum {library.prefix}_{kind} {{\n{values[:-2]}\n}};\n"


def _parameter_struct(library: Library) -> str:
    p = library.prefix
    fields = [
        f"    {p}_real {name};{_default_comment(library.defaults[parameter])}\n"
        for parameter, name in library.parameter_names.items()
    ]
    text = "".join(fields) or f"    {p}_real none; /* there are no parameters */\n"
    return f"typedef struct {p}_parameters {{\n{text}}} {p}_parameters;\n"


def _default_comment(value: float | None) -> str:
    return " /* unbound */" if value is None else f" /* {value!r} */"


def _setup_declarations(library: Library) -> str:
    p = library.prefix
    unbound = "" if library.is_bound else ", NaN for those that are unbound"
    lines = [
        f"/* The values of parameters when this was generated{unbound}. */",
        f"{p}_parameters {p}_default_parameters(void);",
        f"void {p}_model_init({p}_model *model, const {p}_parameters *parameters);",
    ]
    if library.is_bound:
        lines.append(f"extern const {p}_model {p}_default_model;")
    lines += [
        "/* The name in the document, NULL if there is none. */",
        f"const char *{p}_joint_name(int joint);",
    ]
    return "\n".join(lines) + "\n"


def _functions(library: Library) -> str:
    texts = []
    for function in library.all_functions:
        shapes = ", ".join(
            f"{result.name}[{' * '.join(map(str, result.shape))}]" for result in function.results
        )
        summary = function.summary[0].upper() + function.summary[1:]
        texts.append(
            f"/* {summary}.\n * Fills {shapes}.{_fext(library, function)} */\n"
            f"{declaration(library, function)};\n"
        )
    return "\n".join(texts)


def _fext(library: Library, function: Function) -> str:
    if function.loaded is None:
        return ""
    shape = f"[{macro(library)}_NB][6]"
    return f"\n * fext{shape}: the wrench on each body in its own coordinates, or NULL."
