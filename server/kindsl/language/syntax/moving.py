"""Moving a piece of text with the blanks and comments that belong to it."""

import re

from kindsl.language.syntax.scanner import comments
from kindsl.language.syntax.tree import Edit, Node, Token

_REST_OF_LINE = r"[ \t]*(?://[^\r\n]*)?(?=[\r\n]|\Z)"


def moved_behind(text: str, first: Node, last: Node, position: int) -> tuple[Edit, ...]:
    """Return the edits that move the nodes `first` to `last` behind a position."""
    token = first.children[0]
    lead = token.lead if isinstance(token, Token) else first.start
    start = _own_start(text, lead, first.start)
    moved = text[start : last.end]
    if not moved[:1].isspace():
        moved = " " + moved
    rest = re.compile(_REST_OF_LINE).match(text, position)
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
