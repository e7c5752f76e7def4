"""The error of a wrong configuration; apart from the problems, so that it imports nothing."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kindsl.config.problems import ConfigurationProblem


class ConfigurationError(Exception):
    """A configuration file cannot be used.

    Attributes:
        problems: All that is wrong with it, in the order of the file.
    """

    def __init__(self, problems: "tuple[ConfigurationProblem, ...]") -> None:
        super().__init__("\n".join(map(str, problems)))
        self.problems = problems
