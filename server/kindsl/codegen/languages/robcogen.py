"""RobCoGen's C++ classes: the same files, names and signatures, with other code in them."""

from kindsl.codegen.language import Language
from kindsl.codegen.library import Library
from kindsl.codegen.reference import Reference
from kindsl.codegen.robcogen.files import robot_files


def _files(library: Library, _: Reference, _parameters: dict[str, float]) -> dict[str, str]:
    return robot_files(library)


LANGUAGE = Language(
    _files,
    frozenset(("--runtime", "--layout")),
    parameters="all",
    makes_transforms=True,
    is_rigid=True,
)
