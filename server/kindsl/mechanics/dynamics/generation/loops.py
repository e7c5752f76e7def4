"""Functions too long to be written as straight lines: loops over bodies compute them."""

from dataclasses import replace

from kindsl.mechanics.dynamics.generation.forward_dynamics import factorization_operations
from kindsl.mechanics.dynamics.generation.function import Function, Inputs, Result
from kindsl.mechanics.dynamics.generation.functions import QUANTITIES
from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.robot import Robot
from kindsl.mechanics.dynamics.generation.terms import Scalar, operations
from kindsl.mechanics.dynamics.generation.tree import Tree
from kindsl.mechanics.dynamics.generation.vectors import EYE, ZERO

# gcc -O2 takes 6 s and 2.6 MB of text for so many; up to there straight lines are up to three times
# as fast. Derivatives are no faster from half as many on: those of forward dynamics of a chain of
# 16 (32,000 operations) are as fast in loops, so are those of inverse dynamics of a tree of 18
# (27,000).
MOST_OPERATIONS = 50_000
# Loops keep two matrices at most on the stack: 4 MB of the 8 that threads usually have.
MOST_VELOCITIES = 500
# What there are loops for, with the least operations of each for one of the inertia's factors: they
# tell without recording that they are too many, where they are not zero. Derivatives of forward
# dynamics were 11 to 13 in chains and humanoids.
LOOPS = {
    "inverse_dynamics": 0, "inverse_dynamics_actuated": 0, "forward_dynamics": 0,
    "gravity_torque": 0, "bias_torque": 0, "joint_space_inertia": 0, "inertia_factorization": 1,
    "inverse_dynamics_derivatives": 1, "forward_dynamics_derivatives": 10, "regressor": 1,
    "joint_space_inertia_inverse": 1, "coriolis_matrix": 1,
}  # fmt: skip


def functions_of(
    robot: Robot, inputs: Inputs, name: str, *, has_loops: bool
) -> list[Function]:  # fmt: skip
    """Record the functions of a quantity, those that are too long as loops if there are such.

    Args:
        robot: The mechanism.
        name: The quantity.
        has_loops: Whether what is too long is to be loops.

    Raises:
        OverflowError: There is no room for what they compute with.
    """
    build = QUANTITIES[name].build
    if not has_loops or name not in LOOPS:
        return build(robot, inputs)
    if LOOPS[name] and robot.n_velocities > MOST_VELOCITIES:
        raise OverflowError(
            f"'{name}' is not generated for more than {MOST_VELOCITIES} velocities: "
            "its matrices do not fit on the stack"
        )
    most = MOST_OPERATIONS // 2 if name.endswith("_derivatives") else MOST_OPERATIONS
    if LOOPS[name] * factorization_operations(robot.tree) > most:
        return [_in_loops(function) for function in build(_flat(robot), inputs)]
    return [
        _in_loops(function) if _size(robot, function) > most else function
        for function in build(robot, inputs)
    ]


def table(tree: Tree) -> list[list[Scalar]]:
    """Return the numbers of each body that loops read, base first: see `emitters/loops.c`."""
    n, drives = len(tree.links()), tree.drives
    nothing = [0.0] * n
    own = (drives.armature, drives.damping, drives.friction) if drives else (nothing,) * 3
    rows: list[list[Scalar]] = []
    for body, R, r, drive in zip(
        tree.masses, tree.rotations, tree.positions, [ZERO, *zip(*own, strict=True)], strict=True
    ):
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = body.second
        turned = [x for row in R for x in row]
        rows.append([*turned, *r, body.mass, *body.first, xx, xy, xz, yy, yz, zz, *drive])
    return rows


def _size(robot: Robot, function: Function) -> int:
    entries = [entry for result in function.results for entry in result.entries]
    return operations(robot.graph, entries)


def _in_loops(function: Function) -> Function:
    """Return a function of whose results only the sizes are known."""
    results = _sizes(function.results)
    loaded = None if function.loaded is None else _sizes(function.loaded)
    return function._replace(results=results, loaded=loaded, is_loop=True)


def _sizes(results: tuple[Result, ...]) -> tuple[Result, ...]:
    return tuple(result._replace(entries=[0.0] * len(result.entries)) for result in results)


def _flat(robot: Robot) -> Robot:
    """Return a robot of as many joints whose functions are short."""
    size = len(robot.tree.parents)
    one = MassMoments(EYE, ZERO, 1.0)
    tree = replace(
        robot.tree, parents=[0] * size, rotations=[EYE] * size, positions=[ZERO] * size,
        masses=[one] * size,
    )  # fmt: skip
    return replace(robot, tree=tree)
