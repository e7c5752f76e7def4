"""A module in Python that computes with CasADi, on its numbers and symbols alike."""

from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.python_text import module_text
from kindsl.products.codegen.reference import Reference

HOW = """\
Needs CasADi only. Arguments and results are its matrices (DM, SX or MX); vectors are columns, and
poses are 4x4 matrices by name. Wrap a call in casadi.Function to differentiate or to compile it."""

OWN = "import casadi\nfrom casadi import cos, sign, sin\n", "casadi_answer", "casadi_poses"


def _files(library: Library, _: Reference) -> dict[str, str]:
    return {f"{library.prefix}.py": module_text(library, HOW, OWN)}


LANGUAGE = Language(_files)
