"""Derivatives of the forces of a motion, for tracing, in the links' own coordinates.

The equations are the book's (Singh, Russell, Wensing 2022) for points instead of
spatial vectors: a joint changes the accelerations of all that it carries by a field, which takes
forces there; where it is carried itself, the forces that it passes on change and turn with it.
"""

from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.carried_motion import (
    Field,
    Flow,
    flow_reaction,
    flows,
    wrench_of,
)
from kindsl.mechanics.dynamics.generation.composite_bodies import (
    composites,
    joint_reaction,
    joint_space_inertia,
)
from kindsl.mechanics.dynamics.generation.function import Inputs
from kindsl.mechanics.dynamics.generation.inverse_dynamics import (
    BodyMotions,
    body_motions,
    carried_wrenches,
)
from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.tree import JointMotion, Tree, Wrench, joint_motions
from kindsl.mechanics.dynamics.generation.vectors import (
    EYE,
    ZERO,
    Matrix,
    Vector,
    add,
    cross,
    dot,
    scale,
    subtract,
    transpose,
)


class _Mechanism(NamedTuple):
    """A mechanism in motion; all lists by body.

    Attributes:
        tree: The mechanism.
        joints: The motion across each joint.
        steps: The velocity of each link's origin less that of its parent's, in the parent.
        bodies: Each body with all that it carries, as if rigid.
        flows: How that moves.
        wrenches: The wrenches for that.
        by_position: How accelerations change with each joint's position.
        by_velocity: The same with its velocity.
    """

    tree: Tree
    joints: list[JointMotion]
    steps: list[Vector]
    bodies: list[MassMoments]
    flows: list[Flow]
    wrenches: list[Wrench]
    by_position: list[Field]
    by_velocity: list[Field]


def force_derivatives(tree: Tree, inputs: Inputs) -> tuple[Matrix, Matrix, Matrix]:
    """Return the derivatives of the forces with positions, velocities and accelerations.

    A floating base's rows, of its wrench, and columns come first.
    """
    mechanism = _in_motion(tree, inputs)
    first = 6 if tree.is_floating else 0
    size = first + len(tree.links())
    dq: Matrix = [[0.0] * size for _ in range(size)]
    dqd: Matrix = [[0.0] * size for _ in range(size)]
    for i in tree.links():
        _fill_joint(mechanism, i, inputs, dq, dqd)
    if tree.is_floating:
        turns, turning, moving = _base_columns(mechanism, inputs)
        for row in range(6):
            dq[row][:3] = turns[row]
            dqd[row][:6] = [*turning[row], *moving[row]]
    if tree.drives is not None:
        for row, damping in enumerate(tree.drives.damping, start=first):
            dqd[row][row] = dqd[row][row] + damping
    return dq, dqd, joint_space_inertia(tree, inputs.q)


def _in_motion(tree: Tree, inputs: Inputs) -> _Mechanism:
    joints, bodies = joint_motions(tree, inputs.q), composites(tree, inputs.q)
    w, v = inputs.v0[:3], inputs.v0[3:]
    a = subtract(add(inputs.a0[3:], cross(w, v)), inputs.g)
    motions = body_motions(tree, joints, inputs, a)
    steps = [ZERO, *(_step(tree, joints[i], motions, i, inputs.qd[i - 1]) for i in tree.links())]
    wrenches = carried_wrenches(tree, joints, motions.wrenches)
    fields = [_fields(joints[i], motions, tree.parents[i], i) for i in tree.links()]
    still = Field(ZERO, ZERO, ZERO)
    return _Mechanism(
        tree,
        joints,
        steps,
        bodies,
        flows(tree, joints, motions.w, steps, bodies),
        wrenches,
        [still, *(by_position for by_position, _ in fields)],
        [still, *(by_velocity for _, by_velocity in fields)],
    )


def _step(tree: Tree, joint: JointMotion, motions: BodyMotions, link: int, rate: Scalar) -> Vector:
    step = cross(motions.w[tree.parents[link]], joint.offset)
    return step if joint.kind == "revolute" else add(step, joint.to_parent([0.0, 0.0, rate]))


def _fields(
    joint: JointMotion, motions: BodyMotions, parent: int, link: int
) -> tuple[Field, Field]:
    """Return how a joint's position and velocity change accelerations, at the link's origin."""
    x, y, z = joint.to_link(motions.w[parent])
    turning_x, turning_y, _ = joint.to_link(motions.wd[parent])
    # Of the parent's motion, as the link sees it: w x z, and wd x z + w x (w x z).
    across: Vector = [y, 0.0 - x, 0.0]
    b = [turning_y + x * z, y * z - turning_x, 0.0 - (x * x + y * y)]
    if joint.kind == "prismatic":
        return Field(b, ZERO, ZERO), Field(scale(2.0, across), ZERO, ZERO)
    a = motions.a[link]
    return Field([a[1], 0.0 - a[0], 0.0], b, across), Field(ZERO, scale(2.0, across), EYE[2])


class _Column(NamedTuple):
    """A joint as its supporting bodies see it, at the origin of one of them.

    Attributes:
        by_position: Derivative of the wrench there by its position.
        by_velocity: The same with its velocity.
        reaction: The wrench when it accelerates by one.
        turning: Its `flow_reaction`.
    """

    by_position: Wrench
    by_velocity: Wrench
    reaction: Wrench
    turning: Vector

    def force_in(self, field: Field) -> Scalar:
        """Return the joint's force when a field, at the same origin, moves all that it carries."""
        reaction = [*self.reaction.force, *self.reaction.moment, *self.turning]
        return dot(reaction, [*field.a, *field.b, *field.o])


def _fill_joint(mechanism: _Mechanism, link: int, inputs: Inputs, dq: Matrix, dqd: Matrix) -> None:
    """Fill row and column of a joint, as far as those are concerned that carry it."""
    tree, joints = mechanism.tree, mechanism.joints
    first = 6 if tree.is_floating else 0
    here, column = first + link - 1, _own_column(mechanism, link)
    dq[here][here] = joints[link].along(column.by_position)
    dqd[here][here] = joints[link].along(column.by_velocity)
    while tree.parents[link] != 0:
        column, link = _in_parent(mechanism, link, column), tree.parents[link]
        there = first + link - 1
        dq[there][here] = joints[link].along(column.by_position)
        dqd[there][here] = joints[link].along(column.by_velocity)
        dq[here][there] = column.force_in(mechanism.by_position[link])
        dqd[here][there] = column.force_in(mechanism.by_velocity[link])
    if tree.is_floating:
        column = _in_parent(mechanism, link, column)
        for row in range(6):
            dq[row][here] = _entries(column.by_position)[row]
            dqd[row][here] = _entries(column.by_velocity)[row]
        turns, turning, moving = _base_fields(inputs)
        dq[here][:3] = [column.force_in(field) for field in turns]
        dqd[here][:6] = [column.force_in(field) for field in (*turning, *moving)]


def _own_column(mechanism: _Mechanism, link: int) -> _Column:
    kind, body, flow = mechanism.joints[link].kind, mechanism.bodies[link], mechanism.flows[link]
    by_position = wrench_of(mechanism.by_position[link], body, flow)
    return _Column(
        _turned(kind, by_position, mechanism.wrenches[link]),
        wrench_of(mechanism.by_velocity[link], body, flow),
        joint_reaction(kind, body),
        flow_reaction(kind, flow),
    )


def _in_parent(mechanism: _Mechanism, link: int, column: _Column) -> _Column:
    joint = mechanism.joints[link]
    by_position, by_velocity, reaction = (
        joint.wrench_in_parent(wrench) for wrench in column[:3]
    )  # fmt: skip
    moved = scale(2.0, cross(mechanism.steps[link], reaction.force))
    return _Column(by_position, by_velocity, reaction, add(joint.to_parent(column.turning), moved))


def _turned(kind: str, change: Wrench, wrench: Wrench) -> Wrench:
    """Return a wrench's change, and what it changes by as its link is moved."""
    (x, y, _), (moment_x, moment_y, _) = wrench.force, wrench.moment
    along: Vector = [0.0 - y, x, 0.0]
    if kind == "prismatic":
        return Wrench(add(change.moment, along), change.force)
    around: Vector = [0.0 - moment_y, moment_x, 0.0]
    return Wrench(add(change.moment, around), add(change.force, along))


def _base_fields(inputs: Inputs) -> tuple[list[Field], list[Field], list[Field]]:
    """Return how accelerations change with small turns of the base and with its velocity.

    Gravity is given in base coordinates: it turns the other way.
    """
    w, v = inputs.v0[:3], inputs.v0[3:]
    turns = [Field(cross(axis, inputs.g), ZERO, ZERO) for axis in EYE]
    turning = [Field(cross(axis, v), cross(w, axis), axis) for axis in EYE]
    moving = [Field(cross(w, axis), ZERO, ZERO) for axis in EYE]
    return turns, turning, moving


def _base_columns(mechanism: _Mechanism, inputs: Inputs) -> tuple[Matrix, Matrix, Matrix]:
    """Return what the base's wrench changes by, six rows and three columns each."""
    body, flow = mechanism.bodies[0], mechanism.flows[0]
    turns, turning, moving = (
        transpose([_entries(wrench_of(field, body, flow)) for field in fields])
        for fields in _base_fields(inputs)
    )
    return turns, turning, moving


def _entries(wrench: Wrench) -> Vector:
    return [*wrench.moment, *wrench.force]
