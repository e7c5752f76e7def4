"""Where new children, frames and blocks go, laid out like what is around them."""

from collections.abc import Iterable, Sequence

from kindsl.analysis.analysis import Analysis
from kindsl.features.actions.layout_edits import inserted_section, line_indent, newline_of
from kindsl.semantics.declarations import Link
from kindsl.semantics.model import Model
from kindsl.semantics.places import Construct
from kindsl.syntax.tree import Node
from kindsl.text.edits import TextEdit


def with_child(analysis: Analysis, body: Link, link: str, joint: str) -> TextEdit | None:
    """Return the edit that lists one more child, None where the body has no such section."""
    section = next(body.node.nodes("children"), None)
    if section is None:
        return None
    entry = f"{link} via {joint}"
    if not body.children:
        return _absolute(analysis, body, _first_child(body.island.text, section, entry))
    last = body.children[-1]
    indent = line_indent(body.island.text, last.start)
    begins_line = body.island.text[: last.start].endswith(("\n" + indent, "\r" + indent))
    apart = f"{newline_of(body.island.text)}{indent}" if begins_line else " "
    return _absolute(analysis, body, TextEdit(last.end, last.end, f"{apart}{entry}"))


def with_frame(analysis: Analysis, body: Link, lines: Sequence[str]) -> TextEdit | None:
    """Return the edit that gives a body one more frame, None where its braces are missing."""
    section = next(body.node.nodes("frames"), None)
    group = next(section.nodes("frame_group"), None) if section is not None else None
    if group is None:
        behind = [child for child in body.node.children if isinstance(child, Node)]
        whole = ["frames {", *(f"    {line}" for line in lines), "}"]
        edit = inserted_section(body.island.text, body.node, behind[-1] if behind else None, whole)
    else:
        frames = list(group.nodes("frame"))
        edit = inserted_section(body.island.text, group, frames[-1] if frames else None, lines)
    return _absolute(analysis, body, edit)


def behind_last(
    analysis: Analysis, blocks: Sequence[Construct], texts: Iterable[str]
) -> TextEdit | None:
    """Return the edit that puts new blocks behind the last of their kind, None without one."""
    if not blocks:
        return None
    newline = newline_of(analysis.text)
    last = max(blocks, key=lambda block: analysis.resolver.span(block)[0])
    end = analysis.resolver.span(last)[1]
    added = "".join(f"{newline}{newline}{text}" for text in texts)
    return TextEdit(end, end, added)


def fresh_name(model: Model, stem: str) -> str:
    """Return a name that nothing in a document has: the stem with the next number."""
    taken = {*model.body_named, *model.joint_named, *(str(frame.name) for frame in model.frames)}
    taken |= {str(parameter.name) for parameter in model.parameters}
    numbers = range(1, len(taken) + 2)
    return next(f"{stem}{number}" for number in numbers if f"{stem}{number}" not in taken)


def next_ids(model: Model) -> int:
    """Return the number behind the last one, which keeps all others as they are."""
    return 1 + max((link.id or 0 for link in model.links), default=0)


def _first_child(text: str, section: Node, entry: str) -> TextEdit | None:
    """Return the edit that lists the first child: on a line of its own where sections are."""
    opening, closing = section.children[1].end, section.children[-1].start
    indent = line_indent(text, section.start)
    begins_line = text[: section.start].endswith(("\n" + indent, "\r" + indent))
    if not begins_line or text[opening:closing].strip(" \t"):
        return inserted_section(text, section, None, [entry])
    newline = newline_of(text)
    return TextEdit(opening, closing, f"{newline}{indent}    {entry}{newline}{indent}")


def _absolute(analysis: Analysis, body: Link, edit: TextEdit | None) -> TextEdit | None:
    if edit is None:
        return None
    origin = analysis.resolver.span(body)[0] - body.start
    return TextEdit(origin + edit.start, origin + edit.end, edit.text)
