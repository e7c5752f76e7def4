"""A module in Python that computes with CasADi, on its numbers and symbols alike."""

from kindsl.products.codegen.language import Language
from kindsl.products.codegen.python_text import module_text

HOW = """\
Needs CasADi only. Arguments and results are its matrices (DM, SX or MX); vectors are columns, and
poses are 4x4 matrices by name. Wrap a call in casadi.Function to differentiate or to compile it."""

OWN = "import casadi\nfrom casadi import cos, sign, sin\n", "casadi_poses", "casadi_answer"

LANGUAGE = Language(
    lambda library, _: {f"{library.prefix}.py": module_text(library, HOW, OWN)},
    renamed=lambda library: library.renamed_in_python,
)
