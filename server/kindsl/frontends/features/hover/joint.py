"""The hover of a joint: the links it connects, its axis, its place."""

from collections.abc import Iterator

from kindsl.frontends.features.quantity_text import vector
from kindsl.frontends.features.wording import code, paragraph, pose_text
from kindsl.frontends.features.zero_configuration import frame_pose, joint_pose, own_pose
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Frame, Joint
from kindsl.language.semantics.unknown import Unknown


def joint_hover(analysis: Analysis, joint: Joint) -> str:
    """Return what there is to tell of a joint."""
    sections = (_tree_lines, _pose_lines, _axis_lines)
    title = f"**{joint.kind} joint `{joint.name}`**"
    return paragraph(title, (line for lines in sections for line in lines(analysis, joint)))


def _tree_lines(analysis: Analysis, joint: Joint) -> Iterator[str]:
    edges = analysis.model.tree.joint_uses.get(joint, ())
    for edge in edges:
        yield f"predecessor {code(edge.predecessor.name)}, successor {code(edge.child.link)}"
    if not edges:
        yield "not used: no link has a child via it"


def _pose_lines(analysis: Analysis, joint: Joint) -> Iterator[str]:
    pose = own_pose(analysis, joint)
    if isinstance(pose, Unknown):
        yield f"the joint frame is not known: {pose.reason}"
    else:
        yield f"joint frame in the predecessor: {pose_text(pose)}"


def _axis_lines(analysis: Analysis, joint: Joint) -> Iterator[str]:
    pose = joint_pose(analysis, joint)
    if isinstance(pose, Unknown):
        yield f"the axis in the base is not known: {pose.reason}"
        return
    motion = "turns about" if joint.kind == "revolute" else "slides along"
    axis = vector(pose.turn((0.0, 0.0, 1.0)))
    where = f"through {vector(pose.translation)} m"
    yield f"{motion} its z axis: {axis} {where} in the base, in the zero configuration"


def frame_hover(analysis: Analysis, frame: Frame) -> str:
    """Return what there is to tell of a frame."""
    return paragraph(f"**frame `{frame.name}`** of {code(frame.link)}", _lines(analysis, frame))


def _lines(analysis: Analysis, frame: Frame) -> Iterator[str]:
    own = own_pose(analysis, frame)
    if isinstance(own, Unknown):
        yield f"its pose is not known: {own.reason}"
        return
    yield f"in the link frame: {pose_text(own)}"
    pose = frame_pose(analysis, frame)
    if isinstance(pose, Unknown):
        yield f"its pose in the base is not known: {pose.reason}"
    else:
        yield f"zero configuration, in the base: {pose_text(pose)}"
