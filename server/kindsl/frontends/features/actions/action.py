"""A change that an editor offers, and insertions laid out like their surroundings."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.language.syntax.indentation import indentation
from kindsl.language.syntax.tree import Node
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.lines import is_first_on_line

_REST_OF_LINE = re.compile(r"[ \t]*(?://[^\r\n]*)?(?=[\r\n])")
_STEP = "    "


class OtherEdit(NamedTuple):
    """A change of another file: the old text from `start` to `end`, and the new text."""

    start: int
    end: int
    old: str
    new: str


class CodeAction(NamedTuple):
    """A change that an editor offers.

    Attributes:
        title: Its title, in the imperative.
        kind: `quickfix`, `refactor.extract`, `refactor.inline`, `refactor.rewrite`,
            `source.fixAll.kindsl`, `refactor.rewrite.suppress` and the like.
        edits: The change, disjoint.
        diagnostics: The findings that it fixes.
        is_preferred: Whether an editor may do it unasked, by one key.
        bindings: Values to give to parameters in `kindsl.toml` along with the change; without
            them the document does not mean the same.
        other_file: The path of another file to change, empty for none.
        other_edits: The changes there.
    """

    title: str
    kind: str
    edits: tuple[TextEdit, ...]
    diagnostics: tuple[Diagnostic, ...] = ()
    is_preferred: bool = False
    bindings: tuple[tuple[str, float], ...] = ()
    other_file: str = ""
    other_edits: tuple[OtherEdit, ...] = ()


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


def last_section(block: Node) -> Node | None:
    """Return the last section of a block, entry of a section, or None."""
    return next((child for child in reversed(block.children) if isinstance(child, Node)), None)


def section_indent(text: str, block: Node) -> str:
    """Return the blanks before the sections of a block."""
    for child in block.children:
        if isinstance(child, Node) and is_first_on_line(text, child.start):
            return indentation(text, child.start)
    return indentation(text, block.end) + _STEP
