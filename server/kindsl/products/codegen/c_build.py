"""The build descriptions of libraries in C and C++."""

from collections.abc import Sequence

from kindsl.products.codegen.c_text import macro
from kindsl.products.codegen.filling import fill, template
from kindsl.products.codegen.library import Library


def cmake_lists(library: Library, language: str, header: str, sources: Sequence[str] = ()) -> str:
    """Return the CMakeLists.txt: a library to build, test, install and find.

    Args:
        library: The library.
        language: As CMake calls it, C or CXX.
        header: The name of the file that programs include.
        sources: The names of those that are compiled.
    """
    values = {
        "PREFIX": library.prefix, "MACRO": macro(library), "SOURCES": "\n  ".join(sources),
        "ORIGIN": library.stamp.origin, "LICENCE": library.stamp.licence,
        "VERSION": library.version, "LANGUAGE": language, "HEADER": header,
    }  # fmt: skip
    own = fill(template(f"cmake/{language}.cmake"), **values)
    return fill(template("cmake/CMakeLists.txt"), **values, LIBRARY=own)
