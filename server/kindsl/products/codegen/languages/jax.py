"""A module in Python that computes with JAX."""

from kindsl.mechanics.dynamics.generation.emitters.python_lines import python_function
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.products.codegen.filling import template
from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.python_text import module_text
from kindsl.products.codegen.reference import Reference

OWN = (
    "import jax.numpy as np\nimport numpy\nfrom jax import jit, lax, tree\n"
    "from jax.numpy import cos, sign, sin\n",
    "poses_in_arrays",
    "vectors",
    "jax_answer",
)
HOW = """\
Needs JAX only; pure functions for jit, grad and vmap. Leading dimensions are batches, which a
function takes at once: call it in jit. Numbers are 64 bits wide only with
jax.config.update('jax_enable_x64', True)."""

# What is computed with arrays; all else is written as operations on the components of vectors.
IN_ARRAYS = frozenset(
    ("poses", "joint_space_inertia", "inverse_dynamics", "inverse_dynamics_actuated",
     "forward_dynamics", "gravity_torque", "bias_torque")
)  # fmt: skip


def _files(library: Library, _: Reference) -> dict[str, str]:
    text = module_text(library, HOW, OWN, without=IN_ARRAYS)
    return {f"{library.prefix}.py": f"{text}\n{_tables(library)}\n{template(ARRAYS)}"}


ARRAYS = "python/bodies_in_arrays.txt"


def _tables(library: Library) -> str:
    """Return the numbers of the bodies and frames, as functions of parameters."""
    robot, tree = library.robot, library.robot.tree
    parameters: dict[str, list[Scalar]] = {"p": [*robot.parameters.values()]}
    bodies: list[list[Scalar]] = []
    for R, r, body in zip(tree.rotations, tree.positions, tree.masses, strict=True):
        tensor = [x for row in body.inertia() for x in row]
        bodies.append([*(x for row in R for x in row), *r, body.mass, *body.first, *tensor])
    frames: list[list[Scalar]] = [
        [*(x for row in frame.R for x in row), *frame.r] for frame in robot.targets
    ]
    drives = tree.drives
    friction = (drives.armature, drives.damping, drives.friction) if drives is not None else ()
    return "\n".join(
        (
            f"PARENTS = {tuple(tree.parents)!r}",
            f"KINDS = {tuple(tree.kinds[1:])!r}",
            f"CARRIERS = {tuple(frame.body for frame in robot.targets)!r}",
            f"# Rotors, viscous and Coulomb friction of the joints.\nDRIVES = {friction!r}\n\n",
            python_function(robot.graph, "_numbers", parameters, bodies),
            "",
            python_function(robot.graph, "_frames", parameters, frames),
        )
    )


LANGUAGE = Language(_files, renamed=lambda library: library.renamed_in_python)
