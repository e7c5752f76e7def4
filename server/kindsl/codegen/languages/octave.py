"""RobCoGen's functions in Octave, which MATLAB takes as well."""

from kindsl.codegen.language import Language
from kindsl.codegen.library import Library
from kindsl.codegen.reference import Reference
from kindsl.codegen.robcogen.octave import octave_files
from kindsl.codegen.robcogen.robot import GeneratedRobot


def _files(library: Library, _: Reference, _parameters: dict[str, float]) -> dict[str, str]:
    return octave_files(library)


def _renamed(library: Library) -> dict[str, str]:
    return GeneratedRobot(library).renamed


LANGUAGE = Language(
    _files, parameters="all", makes_transforms=True, is_rigid=True, renamed=_renamed
)
