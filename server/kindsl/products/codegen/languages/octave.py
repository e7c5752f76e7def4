"""RobCoGen's functions in Octave, which MATLAB takes as well."""

from kindsl.products.codegen.language import Language
from kindsl.products.codegen.robcogen.octave import octave_files
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

LANGUAGE = Language(
    lambda library, _: octave_files(library),
    parameters="all",
    makes_transforms=True,
    is_rigid=True,
    renamed=lambda library: GeneratedRobot(library).renamed,
)
