"""A module in Python that computes with CasADi, on its numbers and symbols alike."""

from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.python_text import module_text
from kindsl.products.codegen.reference import Reference

HOW = """\
Needs CasADi only. Arguments and results are its matrices (DM, SX or MX); vectors are columns, and
poses are 4x4 matrices by name. Wrap a call in casadi.Function to differentiate or to compile it."""

ANSWER = '''\
def _answer(function, shapes, parameters, *vectors):
    """Call a function of scalars with the components of vectors; None stands for zeros."""
    parts = []
    for x, n in vectors:
        column = casadi.vertcat(*x) if isinstance(x, (list, tuple)) else x
        column = casadi.DM.zeros(n) if column is None else column
        column = column if hasattr(column, "numel") else casadi.DM(column)
        if column.numel() != n:
            raise ValueError(f"an argument has shape {column.shape}, expected ({n}, 1)")
        parts.append([column[i] for i in range(n)])
    results = []
    for entries, shape in zip(function(_values(parameters), *parts), shapes):
        rows, columns = (shape if len(shape) == 2 else (len(entries), 1))
        results.append(casadi.reshape(casadi.vertcat(*entries), columns, rows).T)
    return tuple(results) if len(results) > 1 else results[0]
'''

POSES = '''\
def forward_kinematics(q, parameters=None):
    """Return `base_T_x` (4, 4) of each link and frame x by name."""
    entries = poses(q, parameters=parameters)
    last = casadi.DM([[0.0, 0.0, 0.0, 1.0]])
    return {
        name: casadi.vertcat(casadi.reshape(entries[12 * k : 12 * k + 12], 4, 3).T, last)
        for k, name in enumerate(POSES)
    }
'''


def _files(library: Library, _: Reference, _parameters: dict[str, float]) -> dict[str, str]:
    imports = "import casadi\nfrom casadi import cos, sign, sin\n"
    return {f"{library.prefix}.py": module_text(library, HOW, (imports, ANSWER, POSES))}


LANGUAGE = Language(_files)
