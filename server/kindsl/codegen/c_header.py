"""The header of a library in C."""

from collections.abc import Mapping

from kindsl.codegen.c_text import batch_declaration, declaration, macro, stamp_comment
from kindsl.codegen.library import Library
from kindsl.dynamics.generation.function import Function

CONVENTIONS = """\
/* SI units and radians. Vectors are in base coordinates unless said otherwise; spatial vectors hold
 * the angular part first. Matrices are stored by rows. Joints are in the order of the links' ids.
 * With a floating base its six rows and columns come first.
 *
 * Functions are pure: no allocation, no global state, no errno. Arguments must not overlap results.
 * What is not finite, or a motion that nothing resists, gives results that are not finite.
 */
"""


def header(library: Library) -> str:
    """Return the header."""
    P, p = macro(library), library.prefix
    return f"""\
{stamp_comment(library, f"Kinematics and dynamics of {library.robot_name}.")}
{CONVENTIONS}#ifndef {P}_H
#define {P}_H
#ifdef __cplusplus
extern "C" {{
#endif

#define {P}_DOCUMENT_SHA256 "{library.stamp.sha256}"
#define {P}_NJ {len(library.robot.joint_names)} /* joints */
#define {P}_NV {library.robot.n_velocities} /* velocity variables */
#define {P}_NB {len(library.body_names)} /* bodies, base first */
#define {P}_NPOSES {len(library.pose_names)} /* links, then frames */

typedef {library.options.real} {p}_real;

{_enumeration(library, "joint", library.joint_names)}
{_enumeration(library, "body", library.body_names)}
{_enumeration(library, "pose", library.pose_names)}
{_parameter_struct(library)}
/* What depends on parameters only, computed once. */
typedef struct {p}_model {{
    {p}_real c[{max(1, len(library.setup))}];
}} {p}_model;

{_setup_declarations(library)}
{_functions(library)}
/* The same for n configurations: arguments and results hold n of them one after the other, but
 * there is one g for all. */
{_batches(library)}
#ifdef __cplusplus
}}
#endif
#endif
"""


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


def _batches(library: Library) -> str:
    return "".join(f"{batch_declaration(library, f)};\n" for f in library.all_functions)
