"""A library in C."""

from kindsl.mechanics.dynamics.generation.emitters.lanes import shared
from kindsl.products.codegen.c_header import header
from kindsl.products.codegen.c_sources import (
    has_lanes,
    loops_source,
    model_source,
    noinline,
    quantity_source,
    sources,
)
from kindsl.products.codegen.c_test_program import test_program
from kindsl.products.codegen.c_text import cmake_lists, macro
from kindsl.products.codegen.filling import fill, template
from kindsl.products.codegen.language import COMMON_OPTIONS, Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.readme import readme
from kindsl.products.codegen.reference import Reference


def c_files(library: Library, reference: Reference) -> dict[str, str]:
    """Return the text of each file by its name.

    Args:
        reference: The right answers, for the test program.
    """
    p = library.prefix
    if library.options.is_single_header:
        return {
            f"{p}.h": single_header(library),
            f"{p}_test.c": test_program(
                library, reference,
                f'#define {macro(library)}_IMPLEMENTATION\n#include "{p}.h"',
            ),
            "README.md": readme(library, _usage(library, "c_single_header.md")),
        }  # fmt: skip
    files = {f"{p}.h": header(library), **dict(sources(library))}
    names = [name for name in files if name.endswith(".c")]
    return {
        **files,
        f"{p}_test.c": test_program(library, reference, f'#include "{p}.h"'),
        "CMakeLists.txt": cmake_lists(library, "C", f"{p}.h", names),
        "README.md": readme(library, _usage(library, "c.md")),
    }


def single_header(library: Library) -> str:
    """Return header and code in one file; one source file is to ask for the code."""
    bodies = [quantity_source(library, functions) for functions in library.functions.values()]
    lanes = [shared(library.prefix)] if has_lanes(library) else []
    lanes += [loops_source(library)] if library.has_loops else []
    code = "\n".join([*lanes, noinline(library), model_source(library), *bodies])
    P = macro(library)
    return (
        f"{header(library)}\n#if defined({P}_IMPLEMENTATION) && !defined({P}_IMPLEMENTED)\n"
        f"#define {P}_IMPLEMENTED\n#if defined(__cplusplus)\n"
        f"#error {P}_IMPLEMENTATION belongs in a C source file\n#endif\n"
        f"#include <math.h>\n#include <stddef.h>\n\n{code}\n#endif\n"
    )


def _usage(library: Library, file: str) -> str:
    return fill(template(f"usage/{file}"), PREFIX=library.prefix, MACRO=macro(library))


LANGUAGE = Language(c_files, COMMON_OPTIONS | {"--real", "--single-header"}, has_loops=True)
