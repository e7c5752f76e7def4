"""Poses of links, joints and frames when all joint variables are zero.

Only the joints between a body and the base are evaluated, and each once an analysis.
"""

from kindsl.frontends.features.wording import code
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Frame, Joint, Link
from kindsl.language.semantics.numbers import written_pose
from kindsl.language.semantics.unknown import Unknown, pose_expressions, why_unknown
from kindsl.language.text.facts import kept
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose


@kept
def _poses(_: Analysis) -> dict[Link, RigidPose | Unknown]:
    return {}


def body_pose(analysis: Analysis, body: Link) -> RigidPose | Unknown:
    """Return the pose of a link frame in the base frame, or why it is not known."""
    known = _poses(analysis)
    path: dict[Link, None] = {}
    current = body
    while current not in known and current not in path:
        path[current] = None
        edge = analysis.model.tree.supporting_edge(current)
        if current.is_base or edge is None:
            break
        current = edge.predecessor
    for link in reversed(path):
        known[link] = _from_predecessor(analysis, link, known)
    return known[body]


def joint_pose(analysis: Analysis, joint: Joint) -> RigidPose | Unknown:
    """Return the pose of a joint frame in the base frame, or why it is not known."""
    edges = analysis.model.tree.joint_uses.get(joint)
    if not edges:
        return Unknown(f"no link is connected via {code(joint.name)}")
    predecessor = body_pose(analysis, edges[0].predecessor)
    return _composed(predecessor, own_pose(analysis, joint))


def frame_pose(analysis: Analysis, frame: Frame) -> RigidPose | Unknown:
    """Return the pose of an optional frame in the base frame, or why it is not known."""
    body = next(body for body in analysis.model.bodies if frame in body.frames)
    return _composed(body_pose(analysis, body), own_pose(analysis, frame))


def own_pose(analysis: Analysis, thing: Joint | Frame) -> RigidPose | Unknown:
    """Return a pose as given: in the predecessor's frame, or in the link frame."""
    values = analysis.context.values
    pose = written_pose(thing.pose, values)
    return pose if pose is not None else why_unknown(pose_expressions(thing.pose), values)


def _from_predecessor(
    analysis: Analysis, body: Link, known: dict[Link, RigidPose | Unknown]
) -> RigidPose | Unknown:
    if body.is_base:
        return IDENTITY
    edge = analysis.model.tree.supporting_edge(body)
    if edge is None:
        return Unknown(f"{code(body.name)} has no parent")
    if edge.joint is None:
        return Unknown(f"there is no joint {code(edge.child.joint)}")
    carrier = known.get(edge.predecessor, Unknown(f"{code(body.name)} is part of a kinematic loop"))
    return _composed(carrier, own_pose(analysis, edge.joint))


def _composed(carrier: RigidPose | Unknown, own: RigidPose | Unknown) -> RigidPose | Unknown:
    if isinstance(carrier, Unknown):
        return carrier
    return own if isinstance(own, Unknown) else carrier.then(own)
