"""Insertions that look like what is around them."""

import re
from collections.abc import Sequence

from kindsl.syntax.tree import Node
from kindsl.text.edits import TextEdit

_BLANKS = re.compile(r"[ \t]*")
_REST_OF_LINE = re.compile(r"[ \t]*(?://[^\r\n]*)?(?=[\r\n])")
_STEP = "    "


def line_indent(text: str, offset: int) -> str:
    """Return the blanks that the line of an offset begins with."""
    start = max(text.rfind("\n", 0, offset), text.rfind("\r", 0, offset)) + 1
    blanks = _BLANKS.match(text, start, offset)
    return blanks[0] if blanks is not None else ""


def newline_of(text: str) -> str:
    """Return the line end that a text uses."""
    if "\r\n" in text:
        return "\r\n"
    return "\r" if "\r" in text and "\n" not in text else "\n"


def inserted_section(
    text: str, block: Node, behind: Node | None, lines: Sequence[str]
) -> TextEdit | None:
    """Return the edit that puts a section into a block, None where the block has no braces.

    Args:
        text: The island's text, which the edit's offsets refer to.
        block: The construct in braces.
        behind: The section to put it behind; behind the opening brace if None.
        lines: The section's lines, indented from zero by four blanks a level.
    """
    opening = next((c for c in block.children if c.kind == "{" and c.start < c.end), None)
    if opening is None:
        return None
    position = behind.end if behind is not None else opening.end
    rest = _REST_OF_LINE.match(text, position)
    if rest is not None and rest.end() < block.end:
        indent = section_indent(text, block)
        new = "".join(f"{newline_of(text)}{indent}{line}" for line in lines)
        return TextEdit(rest.end(), rest.end(), new)
    new = " " + " ".join(line.strip() for line in lines)
    is_close = position < len(text) and not text[position].isspace()
    return TextEdit(position, position, new + " " if is_close else new)


def section_indent(text: str, block: Node) -> str:
    """Return the blanks before the sections of a block."""
    for child in block.children:
        indent = line_indent(text, child.start)
        is_first = text[child.start - len(indent) - 1 : child.start - len(indent)] in ("\n", "\r")
        if isinstance(child, Node) and is_first:
            return indent
    return line_indent(text, block.start) + _STEP
