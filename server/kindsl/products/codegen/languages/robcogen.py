"""RobCoGen's C++ classes: the same files, names and signatures, with other code in them."""

from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.reference import Reference
from kindsl.products.codegen.robcogen.files import robot_files
from kindsl.products.codegen.robcogen.robot import GeneratedRobot


def _files(library: Library, _: Reference, _parameters: dict[str, float]) -> dict[str, str]:
    return robot_files(library)


def _renamed(library: Library) -> dict[str, str]:
    return GeneratedRobot(library).renamed


LANGUAGE = Language(
    _files,
    frozenset(("--real float", "--runtime", "--layout", "--namespace", "--sources")),
    parameters="all",
    makes_transforms=True,
    is_rigid=True,
    renamed=_renamed,
)
