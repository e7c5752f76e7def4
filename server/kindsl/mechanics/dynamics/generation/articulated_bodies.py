"""Forward dynamics by articulated bodies, for tracing: operations grow with the number of bodies.

The motion is that of joints that do not accelerate, and a change that is linear in their
accelerations: no products of velocities enter the second part, which is traced here.

Source: Featherstone 2008, sec. 7.3.
"""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.factorization import is_zero, solve_symmetric
from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.tree import JointMotion, Tree, Wrench
from kindsl.mechanics.dynamics.generation.vectors import (
    ZERO,
    Matrix,
    Vector,
    add,
    add_matrices,
    cross,
    dot,
    scale,
    subtract,
    symmetric,
    transpose,
)
from kindsl.mechanics.dynamics.quantities import SingularInertiaError


class ArticulatedInertia(NamedTuple):
    """A symmetric 6x6 inertia by its blocks: `moment = A wd + B a`, `force = B^T wd + C a`."""

    A: Matrix
    B: Matrix
    C: Matrix

    def column(self, kind: str) -> Wrench:
        """Return the wrench of a unit acceleration along the joint."""
        block = (self.A, transpose(self.B)) if kind == "revolute" else (self.B, self.C)
        return Wrench(*([row[2] for row in part] for part in block))


class _Joint(NamedTuple):
    """What a joint takes up: moment and force of a unit acceleration, their inverse, its force."""

    moment: Vector
    force: Vector
    inverse: Scalar
    u: Scalar


def accelerations(
    tree: Tree, joints: Sequence[JointMotion], tau: Vector, wrenches: Sequence[Wrench]
) -> tuple[Vector, Vector]:
    """Return what the joints accelerate by, and a floating base more than it did.

    Args:
        tree: The mechanism.
        joints: The motion across each joint.
        tau: The joint forces, less those of drives.
        wrenches: What each body's motion takes while the joints do not accelerate, less what acts
            on it from outside.

    Raises:
        SingularInertiaError: If a joint certainly moves no mass.
    """
    inertias = [body_inertia(body) for body in tree.masses]
    moments, forces = ([*part] for part in zip(*wrenches, strict=True))
    taken: dict[int, _Joint] = {}
    for i in tree.links_leaves_first():
        joint, parent, kind = joints[i], tree.parents[i], joints[i].kind
        rotor = tree.drives.armature[i - 1] if tree.drives is not None else 0.0
        moment, force = inertias[i].column(kind)
        along, load = (moment, moments[i]) if kind == "revolute" else (force, forces[i])
        pivot = along[2] + rotor
        if is_zero(pivot):
            raise SingularInertiaError
        at = taken[i] = _Joint(moment, force, 1.0 / pivot, tau[i - 1] - load[2])
        share = at.inverse * at.u
        passed = _let_through(inertias[i], at, kind, is_rigid=is_zero(rotor))
        inertias[parent] = _sum(inertias[parent], _in_parent(joint, passed))
        pulled = joint.to_parent(add(forces[i], scale(share, force)))
        turned = joint.to_parent(add(moments[i], scale(share, moment)))
        forces[parent] = add(forces[parent], pulled)
        moments[parent] = add(moments[parent], add(turned, cross(joint.offset, pulled)))
    base: Vector = [0.0] * 6
    if tree.is_floating:
        A, B, C = inertias[0]
        rows = [[*a, *b] for a, b in zip(A, B, strict=True)]
        rows += [[*b, *c] for b, c in zip(transpose(B), C, strict=True)]
        base = solve_symmetric(rows, scale(-1.0, [*moments[0], *forces[0]]))
    wd, a = [base[:3]], [base[3:]]
    found: Vector = []
    for i in tree.links():
        joint, parent, at = joints[i], tree.parents[i], taken[i]
        a_i = joint.to_link(add(a[parent], cross(wd[parent], joint.offset)))
        wd_i = joint.to_link(wd[parent])
        qdd = at.inverse * (at.u - (dot(at.moment, wd_i) + dot(at.force, a_i)))
        found.append(qdd)
        step: Vector = [0.0, 0.0, qdd]
        wd.append(add(wd_i, step if joint.kind == "revolute" else ZERO))
        a.append(add(a_i, ZERO if joint.kind == "revolute" else step))
    return found, base


def body_inertia(body: MassMoments) -> ArticulatedInertia:
    """Return the inertia of a rigid body about its frame's origin."""
    (x, y, z), m = body.first, body.mass
    B: Matrix = [[0.0, 0.0 - z, y], [z, 0.0, 0.0 - x], [0.0 - y, x, 0.0]]
    return ArticulatedInertia(body.inertia(), B, [[m, 0.0, 0.0], [0.0, m, 0.0], [0.0, 0.0, m]])


def _let_through(
    inertia: ArticulatedInertia, joint: _Joint, kind: str, *, is_rigid: bool
) -> ArticulatedInertia:
    """Return what an inertia resists where its joint gives way."""
    turned, pulled = scale(joint.inverse, joint.moment), scale(joint.inverse, joint.force)
    A = _less_square(inertia.A, turned, joint.moment)
    B = [subtract(row, scale(x, joint.force)) for row, x in zip(inertia.B, turned, strict=True)]
    C = _less_square(inertia.C, pulled, joint.force)
    if not is_rigid:
        return ArticulatedInertia(A, B, C)
    # Without a rotor nothing resists along the joint, which rounding would hide.
    if kind == "revolute":
        return ArticulatedInertia(_without_axis(A), [*B[:2], ZERO], C)
    return ArticulatedInertia(A, [[*row[:2], 0.0] for row in B], _without_axis(C))


def _in_parent(joint: JointMotion, inertia: ArticulatedInertia) -> ArticulatedInertia:
    """Return an inertia about the parent's origin, in its coordinates."""
    A, C = joint.symmetric_in_parent(inertia.A), joint.symmetric_in_parent(inertia.C)
    rows = transpose([joint.to_parent(row) for row in inertia.B])
    B, r = transpose([joint.to_parent(row) for row in rows]), joint.offset
    moved = add_matrices(B, transpose([cross(r, column) for column in C]))
    turned = symmetric(lambda i, j: A[i][j] + (cross(r, moved[j])[i] - cross(B[i], r)[j]))
    return ArticulatedInertia(turned, moved, C)


def _sum(one: ArticulatedInertia, other: ArticulatedInertia) -> ArticulatedInertia:
    return ArticulatedInertia(*(add_matrices(a, b) for a, b in zip(one, other, strict=True)))


def _less_square(M: Matrix, scaled: Vector, v: Vector) -> Matrix:
    """Return `M - scaled v^T`, which is symmetric."""
    return symmetric(lambda i, j: M[i][j] - scaled[i] * v[j])


def _without_axis(M: Matrix) -> Matrix:
    return [[M[0][0], M[0][1], 0.0], [M[1][0], M[1][1], 0.0], [0.0, 0.0, 0.0]]
