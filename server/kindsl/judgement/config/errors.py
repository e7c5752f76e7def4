"""Errors in a configuration file, with their places."""

from typing import NamedTuple


class KeyPlace(NamedTuple):
    """The place of a key: line and column from 1, offsets from 0, all in code points."""

    line: int
    column: int
    start: int
    end: int


class ConfigurationProblem(NamedTuple):
    """An error in a configuration file.

    Attributes:
        key: The key in question, dotted; empty where the file as a whole is meant.
    """

    path: str
    place: KeyPlace
    key: str
    message: str

    def __str__(self) -> str:
        return f"{self.path}:{self.place.line}:{self.place.column}: error: {self.message}"


class ConfigurationError(Exception):
    """A configuration file cannot be used."""

    def __init__(self, problems: tuple[ConfigurationProblem, ...]) -> None:
        super().__init__("\n".join(map(str, problems)))
        self.problems = problems
