"""Joints whose axis alone has another direction: one number of a file that moves many of ours.

URDF, MJCF and SDF write the axis apart from the frame. Where it differs, our joint frame and all
that it carries would have to be turned: that is reported as one difference.
"""

from collections.abc import Iterator
from dataclasses import replace
from math import atan2, hypot

from kindsl.mechanics.rigid.pose import ORIGIN, Z_AXIS, RigidPose, Vector3, rotation_from_z
from kindsl.robots.comparison.number_differences import NumberDifference
from kindsl.robots.comparison.quantities import AXIS
from kindsl.robots.comparison.side import ComparedSide, Pair
from kindsl.robots.comparison.written import WrittenInertia, WrittenPose
from kindsl.robots.mechanism.linkage import Linkage

_APART = 1e-6


def axis_differences(pair: Pair, body: int) -> Iterator[tuple[NumberDifference, RigidPose]]:
    """Yield a joint's differing axis, with the turn from the other's joint frame to ours.

    The bodies are taken where they are aligned, then where they are if zeros are the same, too.
    """
    ours, theirs, frames = pair.ours.skeleton, pair.theirs.skeleton, pair.alignment.frames
    carrier = ours.parents[body - 1]
    placed = theirs.zero_poses[theirs.parents[pair.matching.theirs[body] - 1]]
    at_zero = ours.zero_poses[carrier].inverse().then(frames[0]).then(placed)
    for parent in (frames[carrier], at_zero):
        found = _axis_difference(pair, body, parent)
        if found is not None:
            yield found


def _axis_difference(
    pair: Pair, body: int, parent: RigidPose
) -> tuple[NumberDifference, RigidPose] | None:
    ours, theirs, its = pair.ours, pair.theirs, pair.matching.theirs[body]
    mine = ours.skeleton.placements[body - 1]
    other = parent.then(theirs.skeleton.placements[its - 1])
    its_axis = mine.inverse().turn(other.turn(Z_AXIS))
    our_axis = other.inverse().turn(mine.turn(Z_AXIS))
    angle = atan2(hypot(our_axis[0], our_axis[1]), abs(our_axis[2]))
    if angle < _APART:
        return None
    form, its_form = ours.joints[body - 1], theirs.joints[its - 1]
    found = NumberDifference(
        *("joint", form.owner, its_form.owner, AXIS, "rad", 0.0, angle, None, None),
        here_near=form.axis or form.numbers[3],
        there_near=its_form.axis or its_form.numbers[3],
        body=body,
        turn=_turn(its_axis),
    )
    return found, _turn(our_axis)


def with_axis(skeleton: Linkage, body: int, turn: RigidPose) -> Linkage:
    """Return a robot with another axis of a body's joint, all bodies in place at zero.

    `turn` is the joint's new frame in its old one.
    """
    back = turn.inverse()
    bodies = [
        each._replace(placement=back.then(each.placement)) if each.parent == body else each
        for each in skeleton.bodies
    ]
    own = bodies[body]
    parts = (part.seen_from(back) for part in own.parts)
    bodies[body] = own._replace(parts=tuple(parts), placement=own.placement.then(turn))
    return replace(skeleton, bodies=tuple(bodies))


def described_with_axis(robot: ComparedSide, body: int, turn: RigidPose) -> ComparedSide:
    """Return a robot as `with_axis` does, its numbers as they are written."""
    back, joints, inertias = turn.inverse(), list(robot.joints), list(robot.inertias)
    joints[body - 1] = replace(joints[body - 1], after=joints[body - 1].after.then(turn))
    for child, parent in robot.skeleton.links():
        if parent == body:
            joints[child - 1] = _before(joints[child - 1], back)
    inertias[body] = tuple(_part(part, back) for part in inertias[body])
    of_body = {frame.name for frame in robot.skeleton.frames if frame.body == body}
    frames = {n: _before(f, back) if n in of_body else f for n, f in robot.frames.items()}
    return replace(
        robot,
        skeleton=with_axis(robot.skeleton, body, turn),
        joints=tuple(joints),
        inertias=tuple(inertias),
        frames=frames,
    )


def _before(form: WrittenPose, back: RigidPose) -> WrittenPose:
    return replace(form, before=back.then(form.before))


def _part(part: WrittenInertia, back: RigidPose) -> WrittenInertia:
    return replace(part, body_T_frame=back.then(part.body_T_frame))


def _turn(axis: Vector3) -> RigidPose:
    """Return the frame whose z is along an axis, either way: a sign is a convention."""
    x, y, z = axis
    return RigidPose(rotation_from_z((x, y, z) if z >= 0.0 else (-x, -y, -z)), ORIGIN)
