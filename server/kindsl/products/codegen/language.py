"""The languages of generated code, found by walking `languages`: each module holds one."""

from collections.abc import Callable, Mapping
from importlib import import_module
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple

from kindsl.language.text.modules import module_names
from kindsl.products.codegen import languages

if TYPE_CHECKING:
    from kindsl.products.codegen.library import Library
    from kindsl.products.codegen.reference import Reference

Files = dict[str, str]
COMMON_OPTIONS = frozenset(("--name", "--quantities", "--derivatives", "--control"))


class Language(NamedTuple):
    """A language; its module is called as the command line calls it, and holds it as `LANGUAGE`.

    Attributes:
        files: Takes a library and the right answers; returns the text of each file by its name.
        options: Of the options of `kindsl generate` that not every language heeds, those that this
            one does.
        parameters: Which parameters stay inputs where that is not said.
        makes_transforms: Whether it has transforms where no transforms document lists them.
        is_rigid: Whether rotors and friction of joints are left out.
        has_loops: Whether long functions are loops over bodies.
        quantities: What it always has, whatever is chosen; empty if that decides.
        renamed: Takes a library; returns the names that are others in the code.
    """

    files: "Callable[[Library, Reference], Files]"
    options: frozenset[str] = COMMON_OPTIONS
    parameters: str = "unbound"
    makes_transforms: bool = False
    is_rigid: bool = False
    has_loops: bool = False
    quantities: tuple[str, ...] = ()
    renamed: "Callable[[Library], Mapping[str, str]]" = attrgetter("renamed")


def language_names() -> list[str]:
    """Return the names of all languages, without loading one."""
    return module_names(languages)


def language_named(name: str) -> Language:
    """Return a language."""
    found = import_module(f"kindsl.products.codegen.languages.{name}").LANGUAGE
    assert isinstance(found, Language)
    return found
