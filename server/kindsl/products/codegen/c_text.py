"""Pieces of text that all C files of a library share."""

from collections.abc import Sequence
from textwrap import wrap

from kindsl.mechanics.dynamics.generation.emitters.c import Dialect
from kindsl.mechanics.dynamics.generation.function import Function
from kindsl.products.codegen.filling import fill, template
from kindsl.products.codegen.library import Library

# Arguments of a fixed length, whatever the robot.
FIXED_LENGTHS = {"v0": "6", "a0": "6", "g": "3", "f0": "6"}
EXTERNAL = "fext"
_NO_BREAK = "\u00a0"


def stamp_comment(library: Library, what: str) -> str:
    """Return the comment that a file begins with."""
    stamp = library.stamp
    return (
        f"/* {what}\n"
        f" *\n"
        f" * {stamp.origin}\n"
        f" * {stamp.licence}\n"
        f" * SHA-256 of the document: {stamp.sha256}\n"
        f" * Options: {stamp.options}\n"
        f" */\n"
    )


def dialect(library: Library) -> Dialect:
    """Return how the library writes numbers."""
    suffix = "f" if library.options.real == "float" else ""
    return Dialect(real(library), suffix, f"{macro(library)}_NOINLINE ")


def real(library: Library) -> str:
    """Return the name of the type of numbers."""
    return f"{library.prefix}_real"


def macro(library: Library) -> str:
    """Return the prefix of macros and of enumerated values."""
    return library.prefix.upper()


def parameters(library: Library, function: Function, qualifier: str = "") -> dict[str, str]:
    """Return the declarations of a function's parameters, by their names.

    Args:
        qualifier: `restrict ` in definitions.
    """
    number = real(library)
    declared = {"m": f"const {library.prefix}_model *m"}
    for name, _ in function.arguments:
        declared[name] = f"const {number} {name}[{_bound(name, qualifier)}]"
    if function.loaded is not None:
        declared[EXTERNAL] = f"const {number} *{EXTERNAL}"
    for name, *_ in function.results:
        declared[name] = f"{number} {name}[{_bound(name, qualifier)}]"
    return declared


def declaration(library: Library, function: Function) -> str:
    """Return a function's declaration, without qualifiers or semicolon."""
    name = library.function_names[function.key]
    return _wrapped(f"void {library.prefix}_{name}", [*parameters(library, function).values()])


def batch_declaration(library: Library, function: Function) -> str:
    """Return the declaration of a function for many configurations."""
    number, name = real(library), library.function_names[function.key]
    arguments = [
        f"const {number} {a.name}[{3 if a.name == 'g' else ''}]" for a in function.arguments
    ]
    external = [f"const {number} *{EXTERNAL}"] if function.loaded is not None else []
    results = [f"{number} {result.name}[]" for result in function.results]
    head = f"void {library.prefix}_{name}_batch"
    return _wrapped(
        head, ["long n", f"const {library.prefix}_model *m", *arguments, *external, *results]
    )


def cmake_lists(library: Library, language: str, header: str, sources: Sequence[str] = ()) -> str:
    """Return the CMakeLists.txt: a library to build, test, install and find.

    Args:
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


def _bound(name: str, qualifier: str) -> str:
    return f"{qualifier}{FIXED_LENGTHS.get(name, '')}".strip()


def _wrapped(head: str, parts: Sequence[str]) -> str:
    """Return a head with parts in brackets, in lines of at most 100 characters."""
    kept = (text.replace(" ", _NO_BREAK) for text in (head, *parts))
    text = f"{next(kept)}({', '.join(kept)})"
    lines = wrap(text, 100, subsequent_indent="    ", break_long_words=False)
    return "\n".join(lines).replace(_NO_BREAK, " ")
