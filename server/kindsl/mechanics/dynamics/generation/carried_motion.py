"""Forces of a body and its subtree when the accelerations of their points change together.

Where a joint moves or speeds up a little, all that it carries takes part like one body: the point y
of it accelerates differently by a field of three vectors,

    dA(y) = a + b x y + 2 o x V(y),

with V(y) the point's velocity less that of the carrying link's origin. The wrench that such a field
takes follows from the carried bodies' moments of mass and two integrals of V.
"""

from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.tree import JointMotion, Tree, Wrench
from kindsl.mechanics.dynamics.generation.vectors import (
    Matrix,
    Vector,
    add,
    add_matrices,
    cross,
    scale,
    transform,
    transpose,
)


class Flow(NamedTuple):
    """The flow of mass about the origin of the link that carries it.

    Attributes:
        first: `integral V dm`, kg m/s.
        mixed: `integral y V^T dm`, 3x3, kg m^2/s.
    """

    first: Vector
    mixed: Matrix


class Field(NamedTuple):
    """A change of points' accelerations, see above."""

    a: Vector
    b: Vector
    o: Vector


def flows(
    tree: Tree,
    joints: list[JointMotion],
    w: list[Vector],
    steps: list[Vector],
    carried: list[MassMoments],
) -> list[Flow]:
    """Return the flow of each body with all that it carries, base first.

    Args:
        tree: The mechanism.
        joints: The motion across each joint.
        w: Angular velocities.
        steps: The velocity of each link's origin less that of its parent's, in the parent.
        carried: Each body with all that it carries, as if rigid.
    """
    found = [
        Flow(cross(turning, body.first), [cross(turning, row) for row in body.second])
        for body, turning in zip(tree.masses, w, strict=True)
    ]
    for i in tree.links_leaves_first():
        parent = tree.parents[i]
        moved = _in_parent(joints[i], found[i], carried[i], steps[i])
        first, mixed = found[parent]
        found[parent] = Flow(add(first, moved.first), add_matrices(mixed, moved.mixed))
    return found


def _in_parent(joint: JointMotion, flow: Flow, body: MassMoments, step: Vector) -> Flow:
    """Return the flow about the parent's origin, in its coordinates."""
    columns = transpose([joint.to_parent(row) for row in flow.mixed])
    turned = transpose([joint.to_parent(column) for column in columns])
    first = add(joint.to_parent(flow.first), scale(body.mass, step))
    displacement, moment = joint.offset, joint.to_parent(body.first)
    mixed: Matrix = [
        [
            turned[k][m] + (displacement[k] * first[m] + moment[k] * step[m])
            for m in range(3)
        ]
        for k in range(3)
    ]  # fmt: skip
    return Flow(first, mixed)


def wrench_of(field: Field, body: MassMoments, flow: Flow) -> Wrench:
    """Return what a field takes, by a body's moments of mass and its flow."""
    a, b, o = field
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = flow.mixed
    force = add(scale(body.mass, a), cross(b, body.first))
    moment = add(cross(body.first, a), transform(body.inertia(), b))
    turned = [
        o[0] * (yy + zz) - o[1] * yx - o[2] * zx,
        o[1] * (xx + zz) - o[0] * xy - o[2] * zy,
        o[2] * (xx + yy) - o[0] * xz - o[1] * yz,
    ]
    return Wrench(
        add(moment, scale(2.0, turned)), add(force, scale(2.0, cross(o, flow.first)))
    )  # fmt: skip


def flow_reaction(kind: str, flow: Flow) -> Vector:
    """Return the vector whose product with a field's `o` is its part of the joint's force."""
    if kind == "revolute":
        (xx, _, xz), (_, yy, yz), _ = flow.mixed
        return scale(2.0, [0.0 - xz, 0.0 - yz, xx + yy])
    x, y, _ = flow.first
    return scale(2.0, [y, 0.0 - x, 0.0])
