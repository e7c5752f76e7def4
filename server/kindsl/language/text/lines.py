"""Lines of a text and the way between offsets and (line, column)."""

import re
from bisect import bisect_right

_LINE_END = r"\r\n|\n|\r"


class LineIndex:
    """The starts of a text's lines; only CR LF, LF and CR end a line.

    Lines and columns count from 0 unless it is said otherwise, columns in code points.
    """

    __slots__ = ("length", "starts")

    def __init__(self, text: str) -> None:
        self.length = len(text)
        self.starts = [0, *(match.end() for match in re.finditer(_LINE_END, text))]

    def position(self, offset: int) -> tuple[int, int]:
        """Return `(line, column)` of an offset, clamped to the text."""
        offset = min(max(offset, 0), self.length)
        line = bisect_right(self.starts, offset) - 1
        return line, offset - self.starts[line]

    def place(self, offset: int) -> tuple[int, int]:
        """Return `(line, column)` of an offset for people: both count from 1."""
        line, column = self.position(offset)
        return line + 1, column + 1

    def offset(self, line: int, column: int) -> int:
        """Return the offset of `(line, column)`, clamped to the text."""
        if line >= len(self.starts):
            return self.length
        return min(self.starts[max(line, 0)] + max(column, 0), self.length)


def is_first_on_line(text: str, position: int) -> bool:
    """Return whether only blanks stand before a position on its line."""
    while position > 0 and text[position - 1] in " \t":
        position -= 1
    return position == 0 or text[position - 1] in "\r\n"


def line_start(text: str, position: int) -> int:
    """Return where the line that holds a position begins."""
    return max(text.rfind("\n", 0, position), text.rfind("\r", 0, position)) + 1


def newline_of(text: str) -> str:
    """Return the line end that a text uses, a line feed where it uses none or several."""
    ends = set(re.findall(_LINE_END, text)) if "\r" in text else ()
    return "".join(ends) if len(ends) == 1 else "\n"
