"""RobCoGen's C++ classes: the same files, names and signatures, with other code in them."""

from kindsl.products.codegen.language import Language
from kindsl.products.codegen.robcogen.files import robot_files
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

LANGUAGE = Language(
    lambda library, _: robot_files(library),
    frozenset(("--name", "--real", "--runtime", "--layout", "--namespace", "--sources")),
    parameters="all",
    makes_transforms=True,
    is_rigid=True,
    quantities=("inverse_dynamics", "forward_dynamics"),
    renamed=lambda library: GeneratedRobot(library).renamed,
)
