"""Poses and Jacobians of one frame seen from another, for tracing."""

from collections.abc import Sequence

from kindsl.mechanics.dynamics.generation.function import Function, Inputs, Result, matrix
from kindsl.mechanics.dynamics.generation.jacobians import (
    frame_pose,
    joint_columns,
    lever_of,
    poses_in_nearest,
    support,
)
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame, Robot
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import (
    Matrix,
    Vector,
    multiply,
    scale,
    subtract,
    transform,
    transpose,
)

FramePair = tuple[PlacedFrame, PlacedFrame]


def relative_poses(robot: Robot, inputs: Inputs, pairs: Sequence[FramePair]) -> list[Function]:
    """Record `base_T_target` of pairs of frames, without the last row."""
    functions = []
    for base, target in pairs:
        rows = zip(*relative_pose(robot, inputs.q, base, target), strict=True)
        entries: list[Scalar] = [x for row, c in rows for x in (*row, c)]
        functions.append(
            Function(
                f"pose_{target.name}_in_{base.name}",
                f"the upper three rows of the pose of {target.name} in {base.name}",
                inputs.positions,
                (Result("T", (3, 4), entries),),
                about=(target.name, base.name),
            )
        )
    return functions


def relative_pose(
    robot: Robot, q: Vector, base: PlacedFrame, target: PlacedFrame
) -> tuple[Matrix, Vector]:
    """Return rotation and position of a frame in another."""
    found = poses_in_nearest(robot.tree, q, base.body, target.body)
    (base_R, base_r), (R, r) = frame_pose(found, base), frame_pose(found, target)
    E = transpose(base_R)
    return multiply(E, R), transform(E, subtract(r, base_r))


def relative_jacobians(robot: Robot, inputs: Inputs, pairs: Sequence[FramePair]) -> list[Function]:
    """Record the Jacobians of pairs between which there is a joint."""
    functions = []
    for base, target in pairs:
        if columns := relative_columns(robot, inputs.q, base, target):
            functions.append(
                Function(
                    f"jacobian_{target.name}_in_{base.name}",
                    f"the velocity of {target.name} relative to {base.name}, in its coordinates",
                    inputs.positions,
                    (matrix("J", transpose(columns)),),
                    about=(target.name, base.name),
                )
            )
    return functions


def relative_columns(
    robot: Robot, q: Vector, base: PlacedFrame, target: PlacedFrame
) -> list[Vector]:
    """Return the velocity of a frame relative to another, in its coordinates, by joint.

    The joints are those between both frames, in the order of the links.
    """
    found = poses_in_nearest(robot.tree, q, base.body, target.body)
    _, r = frame_pose(found, target)
    E = transpose(frame_pose(found, base)[0])
    forth = joint_columns(robot.tree, found, target.body, lever_of(found, target))
    lever = subtract(r, found.positions[base.body])
    back = joint_columns(robot.tree, found, base.body, lever)
    columns: list[Vector] = []
    for joint in between(robot, base, target):
        sign, (w, v) = (1.0, forth[joint]) if joint in forth else (-1.0, back[joint])
        columns.append([*scale(sign, transform(E, w)), *scale(sign, transform(E, v))])
    return columns


def between(robot: Robot, base: PlacedFrame, target: PlacedFrame) -> list[int]:
    """Return the joints between two frames, in the order of the links."""
    return sorted({*support(robot.tree, base.body)} ^ {*support(robot.tree, target.body)})
