"""A module in Python that computes with CasADi, on its numbers and symbols alike."""

from kindsl.products.codegen.python_text import python_language

HOW = """\
Needs CasADi only. Arguments and results are its matrices (DM, SX or MX); vectors are columns, and
poses are 4x4 matrices by name. Wrap a call in casadi.Function to differentiate or to compile it."""

OWN = "import casadi\nfrom casadi import cos, sign, sin\n", "casadi_poses", "casadi_answer"

LANGUAGE = python_language(HOW, OWN)
