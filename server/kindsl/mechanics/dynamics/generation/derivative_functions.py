"""Derivatives of inverse and forward dynamics, and the inertial-parameter regressor.

A floating base's six rows come first: the wrench on the base, or its spatial acceleration. Its
six columns are small displacements of the base, in base coordinates: a turn, which only gravity
feels, and a shift, which nothing does. Velocity and acceleration of the base keep their
coordinates in the base while it is displaced.
"""

from dataclasses import replace

from kindsl.mechanics.dynamics.generation.composite_bodies import joint_space_inertia
from kindsl.mechanics.dynamics.generation.factorization import (
    Factorization,
    factorize,
    inverse,
    solve_factorized,
)
from kindsl.mechanics.dynamics.generation.force_derivatives import force_derivatives
from kindsl.mechanics.dynamics.generation.function import Function, Inputs, matrix
from kindsl.mechanics.dynamics.generation.inverse_dynamics import bias_torque, inverse_dynamics
from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.robot import Robot, massless
from kindsl.mechanics.dynamics.generation.vectors import (
    EYE,
    ZERO,
    Matrix,
    Vector,
    cross,
    scale,
    subtract,
    transpose,
)

# The order of a body's inertial parameters in the regressor's columns.
TENSOR_ENTRIES = ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))


def inverse_dynamics_derivatives(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record what the forces change by with positions, velocities and accelerations."""
    dq, dqd, M = force_derivatives(robot.tree, inputs)
    results = matrix("dtau_dq", dq), matrix("dtau_dqd", dqd), matrix("dtau_dqdd", M)
    summary = "the derivatives of the forces that a motion takes"
    arguments = inputs.motion("qdd", "a0")
    return [Function("inverse_dynamics_derivatives", summary, arguments, results)]


def forward_dynamics_derivatives(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record what the accelerations change by with positions, velocities and forces.

    At the solution, `M d qdd = -d tau` with the accelerations held. What a floating base's turn or
    linear velocity changes are accelerations of all points alike, which the base's undoes.
    """
    rest: Vector = [0.0] * len(inputs.q)
    bias = bias_torque(robot.tree, inputs)
    factors = factorize(joint_space_inertia(robot.tree, inputs.q))
    forces: Vector = [*[0.0] * (len(bias) - len(inputs.tau)), *inputs.tau]
    solution = solve_factorized(factors, subtract(forces, bias))
    n_base = len(bias) - len(inputs.q)
    base, joints = solution[:n_base] or [0.0] * 6, solution[n_base:]
    dq, dqd, _ = force_derivatives(robot.tree, replace(inputs, qdd=joints, a0=base))
    by_position, by_velocity = _solved(factors, dq), _solved(factors, dqd)
    if robot.tree.is_floating:
        for column, axis in enumerate(EYE):
            turn, moving = cross(inputs.g, axis), cross(axis, inputs.v0[:3])
            _set_column(by_position, column, [*ZERO, *turn, *rest])
            _set_column(by_velocity, 3 + column, [*ZERO, *moving, *rest])
    results = (
        matrix("dqdd_dq", by_position),
        matrix("dqdd_dqd", by_velocity),
        matrix("dqdd_dtau", inverse(factors)),
    )
    summary = "the derivatives of the accelerations under forces"
    return [Function("forward_dynamics_derivatives", summary, inputs.motion("tau"), results)]


def regressor(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record `Y`, with the forces of a motion `Y @ (inertial parameters of all bodies)`.

    Columns are ten a body, a floating base's first: mass, mass times CoM, then the entries
    xx, xy, yy, xz, yz, zz of the inertia tensor about the body's origin.
    """
    tree, x = robot.tree, replace(inputs, external=[])
    columns = []
    for body in range(0 if tree.is_floating else 1, len(tree.parents)):
        for unit in unit_bodies():
            alone = [massless() for _ in tree.parents]
            alone[body] = unit
            columns.append(inverse_dynamics(replace(tree, masses=alone, drives=None), x))
    Y = matrix("Y", transpose(columns))
    summary = "the matrix that takes the bodies' inertial parameters to the forces of a motion"
    return [Function("regressor", summary, inputs.motion("qdd", "a0"), (Y,))]


def unit_bodies() -> list[MassMoments]:
    """Return bodies with one inertial parameter of one each, in the regressor's order."""
    none = massless()
    units = [replace(none, mass=1.0)]
    units += [replace(none, first=[*axis]) for axis in EYE]
    for row, column in TENSOR_ENTRIES:
        tensor: list[list[float]] = [[0.0] * 3 for _ in range(3)]
        tensor[row][column] = tensor[column][row] = 1.0
        half = 0.5 * (tensor[0][0] + tensor[1][1] + tensor[2][2])
        second: Matrix = [[half * (i == j) - tensor[i][j] for j in range(3)] for i in range(3)]
        units.append(replace(none, second=second))
    return units


def _solved(factors: Factorization, rates: Matrix) -> Matrix:
    columns = [solve_factorized(factors, scale(-1.0, column)) for column in transpose(rates)]
    return transpose(columns)


def _set_column(matrix: Matrix, column: int, entries: Vector) -> None:
    for row, entry in zip(matrix, entries, strict=True):
        row[column] = entry
