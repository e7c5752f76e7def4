"""RobCoGen's functions in Octave, which MATLAB takes as well."""

from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.reference import Reference
from kindsl.products.codegen.robcogen.octave import octave_files
from kindsl.products.codegen.robcogen.robot import GeneratedRobot


def _files(library: Library, _: Reference, _parameters: dict[str, float]) -> dict[str, str]:
    return octave_files(library)


def _renamed(library: Library) -> dict[str, str]:
    return GeneratedRobot(library).renamed


LANGUAGE = Language(
    _files, parameters="all", makes_transforms=True, is_rigid=True, renamed=_renamed
)
