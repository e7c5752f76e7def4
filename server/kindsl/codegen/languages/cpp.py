"""A thin header in C++17 over a library in C: Eigen's types, nothing to compute of its own."""

from kindsl.codegen.c_library import OPTIONS, Wrapper, c_files
from kindsl.codegen.c_text import EXTERNAL, macro, stamp_comment
from kindsl.codegen.language import Language
from kindsl.codegen.library import Library
from kindsl.codegen.names_in_code import RESERVED, identifier
from kindsl.codegen.reference import Reference
from kindsl.dynamics.generation.function import Function, Result

FIXED = {"v0": 6, "a0": 6, "g": 3}


def cpp_header(library: Library) -> str:
    """Return the header."""
    p, P = library.prefix, macro(library)
    bound = f"    Model() noexcept : model_({p}_default_model) {{}}\n" if library.is_bound else ""
    methods = "\n".join(_method(library, function) for function in library.all_functions)
    return f"""\
{stamp_comment(library, f"{library.robot_name} in C++17, with Eigen.")}#pragma once
#include "{p}.h"

#include <Eigen/Core>

namespace {namespace(library)} {{

constexpr int n_joints = {P}_NJ;
constexpr int n_velocities = {P}_NV;
constexpr int n_bodies = {P}_NB;

/* By rows, but for columns. */
template <int rows, int columns>
using Matrix =
    Eigen::Matrix<{p}_real, rows, columns, columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
template <int rows>
using Vector = Matrix<rows, 1>;
using JointVector = Vector<n_joints>;
/* One column a body: the wrench on it in its own coordinates. */
using ExternalForces = Eigen::Matrix<{p}_real, 6, n_bodies>;

class Model {{
public:
{bound}    explicit Model(const {p}_parameters &parameters) noexcept {{ set(parameters); }}

    void set(const {p}_parameters &parameters) noexcept {{ {p}_model_init(&model_, &parameters); }}

{methods}
private:
    {p}_model model_;
}};

}} // namespace {namespace(library)}
"""


def namespace(library: Library) -> str:
    """Return a namespace's name."""
    return identifier(library.prefix) if library.prefix not in RESERVED else f"{library.prefix}_"


def _method(library: Library, function: Function) -> str:
    name = library.function_names[function.name]
    takes = [
        f"const Vector<{FIXED.get(a.name, len(a.components))}> &{a.name}"
        for a in function.arguments
    ]
    passed = ["&model_", *(f"{a.name}.data()" for a in function.arguments)]
    load = []
    if function.loaded is not None:
        passed.append(f"{EXTERNAL} != nullptr ? {EXTERNAL}->data() : nullptr")
        load = [f"const ExternalForces *{EXTERNAL} = nullptr"]
    passed += [f"{result.name}.data()" for result in function.results]
    call = f"{library.prefix}_{name}({', '.join(passed)});"
    head = f"    /* {function.summary[0].upper()}{function.summary[1:]}. */\n"
    if len(function.results) == 1:
        (result,) = function.results
        kind = _type(result)
        return (
            f"{head}    {kind} {name}({', '.join([*takes, *load])}) const noexcept\n    {{\n"
            f"        {kind} {result.name};\n        {call}\n"
            f"        return {result.name};\n    }}\n"
        )
    gives = [f"{_type(result)} &{result.name}" for result in function.results]
    return (
        f"{head}    void {name}({', '.join([*takes, *gives, *load])}) const noexcept\n    {{\n"
        f"        {call}\n    }}\n"
    )


def _type(result: Result) -> str:
    """Return the type of a result; poses are one below the other."""
    *outer, columns = (*result.shape, 1) if len(result.shape) == 1 else result.shape
    rows = 1
    for dimension in outer:
        rows *= dimension
    return f"Matrix<{rows}, {columns}>"


def _usage(library: Library) -> str:
    p, space = library.prefix, namespace(library)
    given = "" if library.is_bound else "(parameters)"
    return f"""\

`{p}.hpp` has the functions as methods in C++17, with Eigen's types. A single result is returned,
several are filled in, and `fext` comes last and may be left out:

```cpp
#include <{p}.hpp>

const {space}::Model model{given};
const {space}::JointVector q = {space}::JointVector::Zero();
```
"""


def _files(library: Library, reference: Reference, parameters: dict[str, float]) -> dict[str, str]:
    wrapper = Wrapper({f"{library.prefix}.hpp": cpp_header(library)}, _usage(library))
    return c_files(library, reference, parameters, wrapper)


LANGUAGE = Language(_files, OPTIONS)
