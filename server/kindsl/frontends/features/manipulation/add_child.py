"""Hang a new link on another, by a new joint."""

from kindsl.frontends.features.actions.layout_edits import newline_of
from kindsl.frontends.features.completion import snippets
from kindsl.frontends.features.completion.item import without_placeholders
from kindsl.frontends.features.manipulation.add_frame import pose_lines
from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.frontends.features.manipulation.new_blocks import (
    behind_last,
    fresh_name,
    next_ids,
    with_child,
)
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.mechanics.rigid.pose import Vector3

KEYWORDS = {"revolute": "r_joint", "prismatic": "p_joint"}


def add_child(
    analysis: Analysis, parent: str, point: Vector3, kind: str = "revolute"
) -> Gesture | Refusal:
    """Return the edits that add a link and its supporting joint.

    Args:
        analysis: The document.
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
    pose = [f"        {line}" for line in pose_lines(point)]
    lines = [f"{KEYWORDS[kind]} {joint} {{", "    ref_frame {", *pose, "    }", "}"]
    newline = newline_of(analysis.text)
    block = without_placeholders(snippets.link(link, next_ids(model))).replace("\n", newline)
    listed = with_child(analysis, body, link, joint)
    bodies = model.links or model.bases
    linked = behind_last(analysis, bodies, [block])
    jointed = behind_last(analysis, model.joints or bodies, [newline.join(lines)])
    if listed is None:
        return Refusal(f"'{parent}' has no section of children to add to")
    title = f"Add link '{link}' to '{parent}' by joint '{joint}'"
    return Gesture(title, tuple(sorted((listed, linked, jointed))), (link, joint))
