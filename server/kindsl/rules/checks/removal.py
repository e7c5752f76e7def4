"""How a piece of text is removed without leaving a hole."""

from kindsl.rules.base import Change
from kindsl.semantics.places import Located, Place


def removal(at: Located) -> Change:
    """Return the change that removes a piece, with its lines if nothing else is on them."""
    text, start, end = at.island.text, at.start, at.end
    while start > 0 and text[start - 1] in " \t":
        start -= 1
    while end < len(text) and text[end] in " \t":
        end += 1
    is_first = start == 0 or text[start - 1] in "\r\n"
    is_last = end < len(text) and text[end] in "\r\n"
    if is_first and is_last:
        end += 2 if text.startswith("\r\n", end) else 1
        return Change(Place(at.island, start, end), "")
    return Change(Place(at.island, at.start, end if not is_last else at.end), "")
