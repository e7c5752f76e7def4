"""Places for new children, frames and blocks, laid out like the text around them."""

from collections.abc import Iterable, Sequence
from itertools import count

from kindsl.frontends.features.names_taken import names_taken
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Construct
from kindsl.language.syntax.indentation import indentation
from kindsl.language.syntax.insertions import inserted_section, last_section
from kindsl.language.text.decimals import rounded_decimal
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.lines import is_first_on_line, newline_of
from kindsl.mechanics.rigid.pose import Vector3


def with_child(analysis: Analysis, body: Link, link: str, joint: str) -> TextEdit | None:
    """Return the edit that lists one more child, None where the body has no such section."""
    section = next(body.node.nodes("children"), None)
    if section is None:
        return None
    text, entry = body.island.text, f"{link} via {joint}"
    opening, closing = section.children[1].end, section.children[-1].start
    is_bare = text[section.children[1].start : closing].strip() == "{"
    if not is_bare or not is_first_on_line(text, section.start):
        edit = inserted_section(text, section, last_section(section), [entry])
    else:
        # The first child stands on a line of its own where sections do.
        indent, newline = indentation(text, section.start), newline_of(text)
        edit = TextEdit(opening, closing, f"{newline}{indent}    {entry}{newline}{indent}")
    return edit and analysis.resolver.edit_of(body.island, edit)


def new_frame(link: Link, name: str, origin: Vector3) -> TextEdit | None:
    """Return the edit of a link's island that adds a frame, None where its braces are missing."""
    text, lines = link.island.text, in_braces(name, pose_lines(origin))
    section = next(link.node.nodes("frames"), None)
    if section is None:
        lines = in_braces("frames", lines)
        return inserted_section(text, link.node, last_section(link.node), lines)
    *_, group = section.nodes("frame_group")
    return inserted_section(text, group, last_section(group), lines)


def pose_lines(translation: Vector3) -> list[str]:
    """Return the sections of a pose without rotation, its translation in metres."""
    length = sum(map(abs, translation))
    components = ", ".join(rounded_decimal(value, length) for value in translation)
    return [f"translation = ({components})", "rotation = (0.0, 0.0, 0.0)"]


def in_braces(head: str, lines: Sequence[str]) -> list[str]:
    """Return the lines of a block or section."""
    return [f"{head} {{", *(f"    {line}" for line in lines), "}"]


def behind_last(analysis: Analysis, blocks: Sequence[Construct], texts: Iterable[str]) -> TextEdit:
    """Return the edit that inserts blocks after the last of some existing ones, at least one."""
    newline = newline_of(analysis.text)
    _, end = max(map(analysis.resolver.span, blocks))
    added = "".join(f"{newline}{newline}{text}" for text in texts)
    return TextEdit(end, end, added)


def fresh_name(model: Model, stem: str) -> str:
    """Return a name that nothing in a document has: the stem with the next number."""
    taken = names_taken(model)
    return next(f"{stem}{number}" for number in count(1) if f"{stem}{number}" not in taken)


def next_id(model: Model) -> int:
    """Return the number behind the last one, which keeps all others as they are."""
    return 1 + max((link.id or 0 for link in model.links), default=0)
