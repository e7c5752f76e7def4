"""Poses of single frames and geometric Jacobians, for tracing."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

from kindsl.mechanics.dynamics.generation.robot import PlacedFrame, Robot
from kindsl.mechanics.dynamics.generation.tree import Tree, joint_motions
from kindsl.mechanics.dynamics.generation.vectors import (
    EYE,
    ZERO,
    Matrix,
    Vector,
    add,
    cross,
    multiply,
    transform,
    transpose,
)


@dataclass(frozen=True, slots=True)
class BodyPoses:
    """The poses of the bodies in the base.

    Attributes:
        rotations: `base_R_i`, by body.
        positions: `base_r_i`, by body, metres.
        steps: From the parent's origin to each body's, in base coordinates, metres.
    """

    rotations: list[Matrix]
    positions: list[Vector]
    steps: list[Vector]


def body_poses(tree: Tree, q: Vector) -> BodyPoses:
    """Return the poses of all bodies, base first."""
    return _poses(tree, q, tree.links())


def poses_in_nearest(tree: Tree, q: Vector, one: int, other: int) -> BodyPoses:
    """Return the poses of two bodies, and of all between them, in the nearest that carries both.

    They depend on the joints between only. The poses of other bodies are not to be used.
    """
    back, forth = support(tree, one), support(tree, other)
    shared = len([None for a, b in zip(back, forth, strict=False) if a == b])
    return _poses(tree, q, (*back[shared:], *forth[shared:]))


def _poses(tree: Tree, q: Vector, links: Iterable[int]) -> BodyPoses:
    """Return the poses of links, parents first, as if all others stayed in place."""
    joints, n = joint_motions(tree, q), len(tree.parents)
    poses = BodyPoses([EYE] * n, [ZERO] * n, [ZERO] * n)
    for i in links:
        R, r = poses.rotations[tree.parents[i]], poses.positions[tree.parents[i]]
        poses.steps[i] = transform(R, joints[i].offset)
        poses.positions[i] = add(r, poses.steps[i])
        poses.rotations[i] = joints[i].rotation_in(R)
    return poses


def frame_pose(poses: BodyPoses, frame: PlacedFrame) -> tuple[Matrix, Vector]:
    """Return rotation and position of a frame in the base."""
    R, r = poses.rotations[frame.body], poses.positions[frame.body]
    return multiply(R, frame.R), add(r, transform(R, frame.r))


def support(tree: Tree, body: int) -> list[int]:
    """Return the joints between the base and a body, nearest to the base first."""
    joints = []
    while body:
        joints.append(body)
        body = tree.parents[body]
    return joints[::-1]


def joint_columns(
    tree: Tree, poses: BodyPoses, body: int, lever: Vector
) -> dict[int, tuple[Vector, Vector]]:
    """Return what each supporting joint's rate does to a point of a body.

    Args:
        tree: The mechanism.
        poses: Its bodies' poses.
        lever: From the body's origin to the point, in base coordinates.

    Returns:
        By joint, nearest to the base first, angular and linear velocity in base coordinates.
    """
    columns: dict[int, tuple[Vector, Vector]] = {}
    for joint in reversed(support(tree, body)):
        axis = [row[2] for row in poses.rotations[joint]]
        is_revolute = tree.kinds[joint] == "revolute"
        columns[joint] = (axis, cross(axis, lever)) if is_revolute else (ZERO, axis)
        lever = add(poses.steps[joint], lever)
    return dict(reversed(columns.items()))


def lever_of(poses: BodyPoses, frame: PlacedFrame) -> Vector:
    """Return the way from a body's origin to a frame's on it, in base coordinates."""
    return transform(poses.rotations[frame.body], frame.r)


def jacobian(robot: Robot, poses: BodyPoses, frame: PlacedFrame, seen_from: Matrix) -> Matrix:
    """Return `J` (6, nv) of a frame's origin, a floating base's six columns first.

    Args:
        robot: The mechanism.
        poses: Its bodies' poses.
        seen_from: Rotation to the base from the coordinates that velocities are wanted in.
    """
    E = transpose(seen_from)
    moved = joint_columns(robot.tree, poses, frame.body, lever_of(poses, frame))
    columns = [moved.get(joint, (ZERO, ZERO)) for joint in robot.tree.links()]
    if robot.tree.is_floating:
        _, r = frame_pose(poses, frame)
        turns = [(axis, cross(axis, r)) for axis in EYE]
        columns = [*turns, *((ZERO, axis) for axis in EYE), *columns]
    rotated = [[*transform(E, w), *transform(E, v)] for w, v in columns]
    return transpose(rotated)


def feet(robot: Robot) -> tuple[PlacedFrame, ...]:
    """Return the outermost frame on each link that carries no other link; the link if it has none.

    Where frames were chosen, all chosen ones there.
    """
    parents = set(robot.tree.parents)
    found: list[PlacedFrame] = []
    for link in robot.placed[: len(robot.link_names)]:
        if link.body not in parents:
            on_it = [frame for frame in robot.frames if frame.body == link.body] or [link]
            found += on_it if robot.chosen is not None else [max(on_it, key=_distance)]
    wanted = {target.name for target in robot.targets}
    return tuple(foot for foot in found if foot.name in wanted)


def _distance(frame: PlacedFrame) -> float:
    """Return how far a frame is from its link's origin; infinity where a parameter decides."""
    numbers = [x for x in frame.r if isinstance(x, float)]
    return math.hypot(*numbers) if len(numbers) == len(frame.r) else math.inf
