"""Forward kinematics, for tracing."""

from kindsl.mechanics.dynamics.bodies import BodyFrame
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.tree import Tree, joint_motions
from kindsl.mechanics.dynamics.generation.vectors import Matrix, Vector, add, multiply, transform


def poses(tree: Tree, frames: tuple[BodyFrame, ...], q: Vector) -> list[Scalar]:
    """Return `base_T_link` of all links, then of the frames, row by row: 16 scalars each."""
    joints = joint_motions(tree, q)
    rotations: list[Matrix] = [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]]
    positions: list[Vector] = [[0.0, 0.0, 0.0]]
    for i in tree.links():
        R, r = rotations[tree.parents[i]], positions[tree.parents[i]]
        positions.append(add(r, transform(R, joints[i].offset)))
        rotations.append(joints[i].rotation_in(R))
    entries: list[Scalar] = []
    for i in tree.links():
        entries += _homogeneous(rotations[i], positions[i])
    for frame in frames:
        R, r = rotations[frame.body], positions[frame.body]
        offset: Vector = frame.body_r_frame.tolist()
        turned = multiply(R, frame.body_R_frame.tolist())
        entries += _homogeneous(turned, add(r, transform(R, offset)))
    return entries


def _homogeneous(R: Matrix, r: Vector) -> list[Scalar]:
    rows: Matrix = [[*row, component] for row, component in zip(R, r, strict=True)]
    rows.append([0.0, 0.0, 0.0, 1.0])
    return [entry for row in rows for entry in row]
