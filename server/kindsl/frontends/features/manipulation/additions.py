"""Add a frame to a link, or a link by a new joint, where somebody points."""

from kindsl.frontends.features.completion import snippets
from kindsl.frontends.features.completion.item import without_placeholders
from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.frontends.features.manipulation.new_blocks import (
    behind_last,
    fresh_name,
    in_braces,
    new_frame,
    next_id,
    pose_lines,
    with_child,
)
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.text.lines import newline_of
from kindsl.mechanics.rigid.pose import Vector3

KEYWORDS = {"revolute": "r_joint", "prismatic": "p_joint"}


def add_frame(analysis: Analysis, link: str, point: Vector3) -> Gesture | Refusal:
    """Return the edit that adds a frame to a link.

    Args:
        link: The name of a link or of the base.
        point: The frame's origin in the link's frame, metres, as it is to be written.
    """
    body = analysis.model.body_named.get(link)
    if body is None:
        return Refusal(f"there is no link '{link}'")
    name = fresh_name(analysis.model, "frame")
    edit = new_frame(body, name, point)
    if edit is None:
        return Refusal(f"link '{link}' is not whole")
    edits = (analysis.resolver.edit_of(body.island, edit),)
    return Gesture(f"Add frame '{name}' to '{link}'", edits, (name,))


def add_child(
    analysis: Analysis, parent: str, point: Vector3, kind: str = "revolute"
) -> Gesture | Refusal:
    """Return the edits that add a link and its supporting joint.

    Args:
        parent: The name of a link or of the base.
        point: The joint frame's origin in the parent's frame, metres, as it is to be written.
        kind: `"revolute"` or `"prismatic"`.
    """
    model = analysis.model
    body = model.body_named.get(parent)
    if body is None:
        return Refusal(f"there is no link '{parent}'")
    if kind not in KEYWORDS:
        return Refusal(f"'{kind}' is neither revolute nor prismatic")
    link, joint = fresh_name(model, "link"), fresh_name(model, "joint")
    listed = with_child(analysis, body, link, joint)
    if listed is None:
        return Refusal(f"'{parent}' has no section of children to add to")
    newline = newline_of(analysis.text)
    lines = in_braces(f"{KEYWORDS[kind]} {joint}", in_braces("ref_frame", pose_lines(point)))
    block = without_placeholders(snippets.link(link, next_id(model))).replace("\n", newline)
    bodies = model.links or model.bases
    linked = behind_last(analysis, bodies, [block])
    jointed = behind_last(analysis, model.joints or bodies, [newline.join(lines)])
    title = f"Add link '{link}' to '{parent}' by joint '{joint}'"
    return Gesture(title, tuple(sorted((listed, linked, jointed))), (link, joint))
