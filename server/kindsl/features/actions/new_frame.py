"""Add a frame to a link: one that an inertia refers to and that is nowhere, or any other."""

from collections.abc import Iterator

from kindsl.analysis.analysis import Analysis
from kindsl.analysis.diagnostics import Diagnostic
from kindsl.features.actions.action import CodeAction
from kindsl.features.actions.layout_edits import inserted_section
from kindsl.rigid.pose import Vector3
from kindsl.semantics.declarations import Link
from kindsl.semantics.lowering import declarations
from kindsl.syntax.tree import Node
from kindsl.text.decimals import rounded_decimal
from kindsl.text.edits import TextEdit

_ORIGIN = (0.0, 0.0, 0.0)


def add_referenced_frame(analysis: Analysis, finding: Diagnostic) -> Iterator[CodeAction]:
    """Offer the frame that the `ref_frame` at a finding names, at the origin of its link.

    Not where the finding tells another name that is probably meant, nor one that something has.
    """
    if finding.fix is not None:
        return
    model = analysis.model
    taken = {name.lower() for name in (*model.body_named, *model.joint_named)}
    place = analysis.syntax.island_at(finding.start)
    for link in declarations(place.island).bodies():
        name = link.inertia.frame if link.inertia is not None else None
        if name is None or name.lower() in taken or place.start + name.start != finding.start:
            continue
        edit = new_frame(link, str(name), _ORIGIN)
        if edit is not None:
            moved = TextEdit(place.start + edit.start, place.start + edit.end, edit.text)
            title = f"Add a frame '{name}' to '{link.name}'"
            yield CodeAction(title, "quickfix", (moved,), (finding,))


def new_frame(link: Link, name: str, translation: Vector3) -> TextEdit | None:
    """Return the edit of a link's island that adds a frame without rotation.

    Args:
        link: Where to; None is returned where it has no braces.
        name: Of the frame.
        translation: In the link's frame, metres.
    """
    length = sum(map(abs, translation))
    components = ", ".join(rounded_decimal(value, length) for value in translation)
    lines = [
        f"{name} {{",
        f"    translation = ({components})",
        "    rotation = (0.0, 0.0, 0.0)",
        "}",
    ]
    text = link.island.text
    sections = [child for child in link.node.children if isinstance(child, Node)]
    frames = next((section for section in sections if section.kind == "frames"), None)
    if frames is None:
        indented = ["frames {", *(f"    {line}" for line in lines), "}"]
        return inserted_section(text, link.node, sections[-1], indented)
    group = list(frames.nodes("frame_group"))[-1]
    last = list(group.nodes("frame"))[-1:]
    return inserted_section(text, group, last[0] if last else None, lines)
