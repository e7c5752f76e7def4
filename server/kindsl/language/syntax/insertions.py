"""Sections and blocks that are inserted, moved or removed, with their blanks and comments."""

import re
from collections.abc import Sequence

from kindsl.language.syntax.indentation import indentation
from kindsl.language.syntax.scanner import comments
from kindsl.language.syntax.tree import Edit, Node, Token
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.lines import is_first_on_line, newline_of

_REST_OF_LINE = re.compile(r"[ \t]*(?://[^\r\n]*)?(?=[\r\n]|\Z)")
_STEP = "    "


def inserted_section(
    text: str, block: Node, behind: Node | None, lines: Sequence[str]
) -> TextEdit | None:
    """Return the edit that puts a section into a block, None where the block has no braces.

    Args:
        text: The island's text, which the edit's offsets refer to.
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


def last_section(block: Node) -> Node | None:
    """Return the last section of a block, entry of a section, or None."""
    return next(reversed(block.parts), None)


def section_indent(text: str, block: Node) -> str:
    """Return the blanks before the sections of a block."""
    for child in block.children:
        if isinstance(child, Node) and is_first_on_line(text, child.start):
            return indentation(text, child.start)
    return indentation(text, block.end) + _STEP


def moved_behind(text: str, first: Node, last: Node, position: int) -> tuple[Edit, ...]:
    """Return the edits that move the nodes `first` to `last` behind a position."""
    token = first.children[0]
    lead = token.lead if isinstance(token, Token) else first.start
    start = _own_start(text, lead, first.start)
    moved = text[start : last.end]
    if not moved[:1].isspace():
        moved = " " + moved
    rest = _REST_OF_LINE.match(text, position)
    if rest is not None and "\n" in moved[: len(moved) - len(moved.lstrip())]:
        position = rest.end()
    elif position < len(text) and not text[position].isspace():
        moved += " "
    return (Edit(start, last.end, ""), Edit(position, position, moved))


def removed(text: str, first: Token, end: int) -> Edit:
    """Return the edit that takes out what begins with a token; comments before it stay."""
    before = comments(text[first.lead : first.start])
    if not before:
        return Edit(first.lead, end, "")
    is_whole_line = text[end : end + 1] in ("\n", "\r", "")
    return Edit(first.lead + before[-1][1] if is_whole_line else first.start, end, "")


def _own_start(text: str, lead: int, start: int) -> int:
    """Return where the lines of a node begin: a comment beside the node before stays there."""
    ends = [i for i in (text.find("\n", lead, start), text.find("\r", lead, start)) if i >= 0]
    return min(ends) if ends else lead
