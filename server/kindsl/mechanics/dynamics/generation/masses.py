"""Centre of mass, its Jacobian, and energies, for tracing; with the bodies as they are given."""

from kindsl.mechanics.dynamics.generation.frame_motion import body_velocities
from kindsl.mechanics.dynamics.generation.function import Inputs
from kindsl.mechanics.dynamics.generation.jacobians import BodyPoses
from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.robot import Robot
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import (
    EYE,
    Matrix,
    Vector,
    add,
    cross,
    dot,
    scale,
    subtract,
    transform,
)


def total_mass(robot: Robot) -> Scalar:
    """Return the mass of all bodies, a floating base included."""
    mass: Scalar = 0.0
    for body in robot.bodies:
        mass = mass + body.mass
    return mass


def first_moments(robot: Robot, poses: BodyPoses) -> list[tuple[Scalar, Vector]]:
    """Return mass and first moment of each body with all it carries, in base coordinates."""
    sums = [
        (body.mass, add(transform(R, body.first), scale(body.mass, r)))
        for body, R, r in zip(robot.bodies, poses.rotations, poses.positions, strict=True)
    ]
    for i in robot.tree.links_leaves_first():
        mass, moment = sums[robot.tree.parents[i]]
        sums[robot.tree.parents[i]] = (mass + sums[i][0], add(moment, sums[i][1]))
    return sums


def center_of_mass(robot: Robot, poses: BodyPoses) -> Vector:
    """Return the centre of mass of all bodies, whose mass is not zero."""
    mass, moment = first_moments(robot, poses)[0]
    return scale(1.0 / mass, moment)


def center_of_mass_jacobian(robot: Robot, poses: BodyPoses) -> Matrix:
    """Return `J` (3, nv) of the centre of mass, a floating base's six columns first."""
    tree, sums = robot.tree, first_moments(robot, poses)
    per_mass = 1.0 / sums[0][0]
    com = scale(per_mass, sums[0][1])
    columns = [*(cross(axis, com) for axis in EYE), *EYE] if tree.is_floating else []
    for i in tree.links():
        mass, moment = sums[i]
        axis = [row[2] for row in poses.rotations[i]]
        moved = scale(mass, axis)
        if tree.kinds[i] == "revolute":
            moved = cross(axis, subtract(moment, scale(mass, poses.positions[i])))
        columns.append(scale(per_mass, moved))
    return [list(row) for row in zip(*columns, strict=True)]


def potential_energy(robot: Robot, poses: BodyPoses, gravity: Vector) -> Scalar:
    """Return the potential energy, zero for all mass at the base's origin."""
    return 0.0 - dot(first_moments(robot, poses)[0][1], gravity)


def kinetic_energy(robot: Robot, x: Inputs) -> Scalar:
    """Return the kinetic energy of all bodies."""
    velocities = body_velocities(robot.tree, x)
    energy: Scalar = 0.0
    for body, (w, v) in zip(robot.bodies, velocities, strict=True):
        energy = energy + _energy(body, w, v)
    if robot.tree.drives is not None:
        for rotor, rate in zip(robot.tree.drives.armature, x.qd, strict=True):
            energy = energy + 0.5 * rotor * (rate * rate)
    return energy


def _energy(body: MassMoments, w: Vector, v: Vector) -> Scalar:
    about_origin = dot(w, transform(body.inertia(), w)) + body.mass * dot(v, v)
    return 0.5 * about_origin + dot(v, cross(w, body.first))
