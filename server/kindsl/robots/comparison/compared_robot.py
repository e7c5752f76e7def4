"""One side of a comparison: a robot, and the lines of its numbers."""

from collections.abc import Callable
from typing import NamedTuple

from kindsl.language.semantics.places import Located
from kindsl.robots.comparison.written import Described, TextPlace, WrittenNumber

LineOf = Callable[[Located], int]


class ComparedRobot(NamedTuple):
    """One side of a comparison.

    Attributes:
        name: Its file, as shown.
        robot: The robot that it describes.
        line_of: Returns the line of a place in it, where it is a document.
    """

    name: str
    robot: Described
    line_of: LineOf | None = None

    def line(self, number: WrittenNumber | None) -> int | None:
        """Return the line of a number, None where it stands nowhere."""
        if number is None:
            return None
        if isinstance(number.at, TextPlace):
            return number.at.line
        return self.line_of(number.at) if self.line_of else None

    def place(self, number: WrittenNumber | None) -> str:
        """Return where a number stands, in words."""
        line = self.line(number)
        if number is None or line is None:
            return f"in {self.robot.label}"
        file = number.at.file if isinstance(number.at, TextPlace) else ""
        label = self.robot.label
        name = f"{label.rstrip('/')}/{file}" if file else label
        return f"in {name} (line {line})"
