"""Quantities for controllers of the whole body: momentum, motions of frames, contacts.

Base coordinates, angular part first; a floating base adds its six rows and columns in front.
"""

from dataclasses import replace

from kindsl.mechanics.dynamics.generation import masses
from kindsl.mechanics.dynamics.generation.composite_bodies import (
    base_reactions,
    joint_space_inertia,
)
from kindsl.mechanics.dynamics.generation.factorization import (
    Factorization,
    factorize,
    half_solved,
    inverse,
    solve_factorized,
)
from kindsl.mechanics.dynamics.generation.force_derivatives import force_derivatives
from kindsl.mechanics.dynamics.generation.frame_motion import (
    body_velocities,
    frame_accelerations,
    frame_velocity,
)
from kindsl.mechanics.dynamics.generation.function import Argument, Function, Inputs, Result, matrix
from kindsl.mechanics.dynamics.generation.inverse_dynamics import bias_torque, newton_euler
from kindsl.mechanics.dynamics.generation.jacobians import body_poses, feet, frame_pose, jacobian
from kindsl.mechanics.dynamics.generation.robot import Robot
from kindsl.mechanics.dynamics.generation.terms import Scalar, Term
from kindsl.mechanics.dynamics.generation.vectors import (
    EYE,
    Matrix,
    Vector,
    add,
    cross,
    dot,
    multiply,
    scale,
    subtract,
    transform,
    transpose,
)


def centroidal_momentum(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record the centroidal momentum matrix, and the rate of momentum at zero acceleration."""
    com = masses.center_of_mass(robot, body_poses(robot.tree, inputs.q))

    def about_com(moment: Vector, force: Vector) -> Vector:
        return [*subtract(moment, cross(com, force)), *force]

    columns = [about_com(*wrench) for wrench in base_reactions(robot.tree, inputs.q)]
    w, v = inputs.v0[:3], inputs.v0[3:]
    _, wrench = newton_euler(robot.tree, inputs.unaccelerated(), cross(w, v))
    *moving, _ = inputs.motion()
    return [
        Function(
            "centroidal_momentum_matrix",
            "the matrix that takes velocities to the momentum about the centre of mass",
            inputs.positions,
            (matrix("A", transpose(columns)),),
        ),
        Function(
            "centroidal_momentum_drift",
            "the rate of the momentum about the centre of mass at zero acceleration",
            tuple(moving),
            (Result("rate", (6,), about_com(wrench[:3], wrench[3:])),),
        ),
    ]


def frame_motions(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record velocity and acceleration of each link and frame, in its own coordinates."""
    velocities = body_velocities(robot.tree, inputs)
    accelerations = frame_accelerations(robot.tree, inputs, robot.targets)
    drifts = frame_accelerations(robot.tree, inputs.unaccelerated(), robot.targets)
    *moving, _ = inputs.motion()
    *accelerating, _ = inputs.motion("qdd", "a0")
    functions = []
    for frame, acceleration, drift in zip(robot.targets, accelerations, drifts, strict=True):
        where = f"of {frame.name}'s origin relative to the world, in own coordinates"
        velocity = frame_velocity(velocities, frame)
        for kind, summary, arguments, entries in (
            ("velocity", f"the velocity {where}", moving, velocity),
            ("acceleration", f"the acceleration {where}", accelerating, acceleration),
            ("acceleration_drift", f"the acceleration at zero accelerations {where}",
             moving, drift),
        ):  # fmt: skip
            functions.append(
                Function(
                    f"{kind}_{frame.name}", summary, tuple(arguments),
                    (Result("v" if kind == "velocity" else "a", (6,), entries),),
                    about=(frame.name,),
                )
            )  # fmt: skip
    return functions


def inertia_inverse(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record the inverse of the joint-space inertia."""
    found = inverse(factorize(joint_space_inertia(robot.tree, inputs.q)))
    summary = "the inverse of the joint-space inertia"
    result = matrix("Minv", found)
    return [Function("joint_space_inertia_inverse", summary, inputs.positions, (result,))]


def coriolis_matrix(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record the Coriolis matrix.

    It is half the derivative of the bias, but for a floating base's columns: their coordinates turn
    with the base.
    """
    still = replace(inputs.unaccelerated(), g=[0.0] * 3)
    _, dqd, M = force_derivatives(replace(robot.tree, drives=None), still)
    doubled = [list(row) for row in dqd]
    if robot.tree.is_floating:
        turning = multiply([row[:6] for row in M], _motion_cross(inputs.v0))
        for row, added in zip(doubled, turning, strict=True):
            row[:6] = add(row[:6], added)
    C = [scale(0.5, row) for row in doubled]
    summary = "C, with the bias torque C v and gravity's; C + C^T is the rate of M"
    *moving, _ = inputs.motion()
    return [Function("coriolis_matrix", summary, tuple(moving), (matrix("C", C),))]


def contact_dynamics(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record forward dynamics while some of the feet are held; nothing for a robot without feet.

    A contact whose input `active` is one keeps its foot's origin from accelerating; one at zero
    does nothing, so all sets of contacts share the code.
    """
    contacts = feet(robot)
    if not contacts:
        return []
    x, tree, k = inputs, robot.tree, 6 if robot.tree.is_floating else 0
    active = robot.graph.vector(len(contacts))
    switches = [switch for switch in active for _ in range(3)]
    found, J, drifts = body_poses(tree, x.q), list[Vector](), list[Scalar]()
    accelerations = frame_accelerations(tree, x.unaccelerated(), contacts)
    for contact, drift in zip(contacts, accelerations, strict=True):
        J += jacobian(robot, found, contact, EYE)[3:]
        drifts += transform(frame_pose(found, contact)[0], drift[3:])
    factors = factorize(joint_space_inertia(tree, x.q))
    zeros: Vector = [0.0] * k
    free = subtract([*zeros, *x.tau], bias_torque(tree, x))
    forces, Lambda = _contact_forces(factors, J, drifts, free, switches)
    pulled = add(free, transform(transpose(J), forces))
    a = solve_factorized(factors, pulled)
    results = [
        Result("qdd", (len(x.q),), a[k:]),
        Result("a0", (6,), a[:k]),
        Result("f", (len(contacts), 3), forces),
        matrix("Lambda", Lambda),
    ]
    q, qd, tau, *others = inputs.motion("tau")
    arguments = (q, qd, tau, Argument("active", active), *others)
    names = ", ".join(contact.name for contact in contacts)
    summary = (
        f"the accelerations while contacts hold the origins of {names}, those at which active is "
        "1.0 and not 0.0; the forces on them in base coordinates, and the inertia that these meet"
    )
    about = tuple(contact.name for contact in contacts)
    given = tuple(result for result in results if result.entries)
    return [Function("contact_dynamics", summary, arguments, given, about=about)]


def _contact_forces(
    factors: Factorization, J: Matrix, drifts: Vector, free: Vector, switches: list[Term]
) -> tuple[Vector, Matrix]:
    """Return the forces of contacts, and the inertia that they meet."""
    halves = [half_solved(factors, row) for row in J]
    scaled = [_each(half, factors.inverse_pivots) for half in halves]
    unconstrained = half_solved(factors, free)
    size = len(J)
    system: Matrix = [[0.0] * size for _ in range(size)]
    for i in range(size):
        for j in range(i + 1):
            entry = switches[i] * (dot(halves[i], scaled[j]) * switches[j])
            system[i][j] = system[j][i] = entry
        system[i][i] = system[i][i] + (1.0 - switches[i])
    along = [dot(row, unconstrained) + drift for row, drift in zip(scaled, drifts, strict=True)]
    of_contacts = factorize(system)
    forces = solve_factorized(of_contacts, [0.0 - x for x in _each(switches, along)])
    Lambda = inverse(of_contacts)
    for i in range(size):
        Lambda[i][i] = Lambda[i][i] * switches[i]
    return forces, Lambda


def _each(a: Vector | list[Term], b: Vector) -> Vector:
    return [x * y for x, y in zip(a, b, strict=True)]


def _motion_cross(v: Vector) -> Matrix:
    """Return the 6x6 matrix that takes a motion vector to its cross product with `v`."""
    turning, moving = (
        transpose([cross(part, axis) for axis in EYE]) for part in (v[:3], v[3:])
    )  # fmt: skip
    upper = [[*row, 0.0, 0.0, 0.0] for row in turning]
    lower = [[*a, *b] for a, b in zip(moving, turning, strict=True)]
    return [*upper, *lower]
