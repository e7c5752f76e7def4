"""The hovers of robots, links, joints and frames."""

from collections.abc import Iterator
from itertools import islice

from kindsl.frontends.features.subtree import subtree_of
from kindsl.frontends.features.wording import (
    KILOGRAMS,
    code,
    finding_line,
    inertia_lines,
    number,
    paragraph,
    pose_text,
    vector,
)
from kindsl.frontends.features.zero_configuration import body_pose, frame_pose, joint_pose, own_pose
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.settings import severity_of
from kindsl.judgement.rules.base import Rule, Severity
from kindsl.judgement.rules.inertia.shapes import shape_doubts
from kindsl.judgement.rules.registry import rules_with
from kindsl.language.semantics.declarations import Frame, Joint, Link
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.places import Located
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.text.phrases import counted, listed
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.mechanism.link_inertia import link_inertia
from kindsl.robots.mechanism.total_mass import UNKNOWN, Weight, own_mass, total_mass

_CODES = frozenset(("KD301", "KD302", "KD303", "KD305"))
_CONSISTENT = "✓ physically consistent"

_Reports = Iterator[tuple[Rule, Located, Severity | None, str]]


def robot_hover(analysis: Analysis, name: str) -> str:
    """Return the hover of the robot: its joints, its mass, its parameters."""
    return paragraph(f"**robot `{name}`**", _robot_lines(analysis))


def _robot_lines(analysis: Analysis) -> Iterator[str]:
    model = analysis.model
    kinds = [joint.kind for joint in model.joints]
    parts = [
        counted(count, f"{kind} joint")
        for kind in ("revolute", "prismatic")
        if (count := kinds.count(kind))
    ]
    base = "floating base" if model.floating else "fixed base"
    yield f"{base}, {counted(len(model.links), 'link')}" + (f", {listed(parts)}" if parts else "")
    if model.links or model.floating:
        weight = total_mass(model, analysis.context.values)
        mass = weight.in_words(f"{number(weight.known)} {KILOGRAMS}")
        yield f"total mass {mass}" + ("" if weight.is_whole else f" ({weight.reason_text})")
    names = [f"`{parameter.name}`" for parameter in model.parameters]
    if names:
        yield f"parameters {listed(names)}"


def link_hover(analysis: Analysis, body: Link) -> str:
    """Return the hover of a link or the base: its place in the tree, its mass, its pose."""
    lines = [*_tree_lines(analysis, body), *_mass_lines(analysis, body)]
    if not body.is_base:
        pose = body_pose(analysis, body)
        lines.append(_pose_line(pose, "zero configuration, in the base", "zero-configuration pose"))
    return paragraph(_title(body), lines)


def _title(body: Link) -> str:
    if body.is_base:
        return f"**{'floating' if body.is_floating else 'fixed'} base `{body.name}`**"
    return f"**link `{body.name}`**" + (f", id {body.id}" if body.id is not None else "")


def _tree_lines(analysis: Analysis, body: Link) -> Iterator[str]:
    tree = analysis.model.tree
    for edge in tree.above.get(body, ()):
        kind = f" ({edge.joint.kind})" if edge.joint is not None else ""
        parent = code(edge.predecessor.name)
        yield f"supporting joint {code(edge.child.joint)}{kind}, parent {parent}"
    if not body.is_base and body not in tree.above:
        yield "no supporting joint: no link has it among its children"
    below = [f"{code(e.child.link)} via {code(e.child.joint)}" for e in tree.successor_edges(body)]
    if below:
        yield f"{'child' if len(below) == 1 else 'children'} {listed(below)}"
    if body.frames:
        yield f"frames {listed(code(frame.name) for frame in body.frames)}"


def _mass_lines(analysis: Analysis, body: Link) -> Iterator[str]:
    inertia = link_inertia(body, analysis.context.values)
    subtree = subtree_of(analysis, body)
    below = _subtree_text(subtree.weight, subtree.dof)
    mass = own_mass(body, analysis.context.values)
    own = "" if isinstance(mass, Unknown) else f"mass {number(mass)} {KILOGRAMS}"
    if own or below:
        yield "; ".join(part for part in (own, below) if part)
    if isinstance(inertia, Unknown):
        yield f"mass properties are not known: {inertia.reason}"
        return
    yield from inertia_lines(inertia)
    if body.is_base and not body.is_floating:
        yield "the inertia of a fixed base does not matter"
    else:
        yield from _verdicts(analysis, body)


def _subtree_text(weight: Weight, dof: int) -> str:
    if not dof:
        return ""
    mass = weight.in_words(f"{number(weight.known)} {KILOGRAMS}")
    lack = "" if weight.is_whole else f" ({weight.reason_text})"
    subtree = f"subtree {mass}" if mass != UNKNOWN else "subtree of unknown mass"
    return f"{subtree} with {counted(dof, 'joint')}{lack}"


def _verdicts(analysis: Analysis, body: Link) -> Iterator[str]:
    """Yield what the linter reports of a link's inertia: the worst defect, else each doubt."""
    found = [*islice(_defects(analysis, body), 1)] or [*_doubts(analysis, body)]
    for rule, at, severity, message in found:
        if not analysis.is_silenced(rule.code, at):
            shown = severity_of(rule, severity, analysis.settings)
            yield finding_line(shown, message, rule.code)
    if not found:
        yield _CONSISTENT


def _defects(analysis: Analysis, body: Link) -> _Reports:
    declared = declarations(body.island)
    for rule in rules_with(_CODES):
        for each in rule.check_island(declared, analysis.context) if rule.check_island else ():
            yield rule, each.at, each.severity, each.message


def _doubts(analysis: Analysis, body: Link) -> _Reports:
    joints = analysis.model.tree.joints_on(body)
    for at, doubt in shape_doubts(body, joints, analysis.context):
        for rule in rules_with(frozenset((doubt.code,))):
            yield rule, at, None, doubt.sentence


def joint_hover(analysis: Analysis, joint: Joint) -> str:
    """Return the hover of a joint: the links it connects, its frame, its axis."""
    edges = analysis.model.tree.joint_uses.get(joint, ())
    lines = [
        f"predecessor {code(edge.predecessor.name)}, successor {code(edge.child.link)}"
        for edge in edges
    ]
    lines += [] if edges else ["not used: no link has a child via it"]
    pose = own_pose(analysis, joint)
    lines.append(_pose_line(pose, "joint frame in the predecessor", "the joint frame"))
    lines.append(_axis_line(analysis, joint))
    return paragraph(f"**{joint.kind} joint `{joint.name}`**", lines)


def _axis_line(analysis: Analysis, joint: Joint) -> str:
    pose = joint_pose(analysis, joint)
    if isinstance(pose, Unknown):
        return f"the axis in the base is not known: {pose.reason}"
    motion = "turns about" if joint.kind == "revolute" else "slides along"
    axis = vector(pose.turn((0.0, 0.0, 1.0)))
    where = f"through {vector(pose.translation)} m"
    return f"{motion} its z axis: {axis} {where} in the base, in the zero configuration"


def frame_hover(analysis: Analysis, frame: Frame) -> str:
    """Return the hover of a frame: its pose in its link and in the base."""
    own = own_pose(analysis, frame)
    lines = [_pose_line(own, "in the link frame", "its pose")]
    if not isinstance(own, Unknown):
        pose = frame_pose(analysis, frame)
        lines.append(_pose_line(pose, "zero configuration, in the base", "its pose in the base"))
    return paragraph(f"**frame `{frame.name}`** of {code(frame.link)}", lines)


def _pose_line(pose: RigidPose | Unknown, title: str, subject: str) -> str:
    if isinstance(pose, Unknown):
        return f"{subject} is not known: {pose.reason}"
    return f"{title}: {pose_text(pose)}"
