"""A kindsl.toml or pyproject.toml: a configuration, or problems that lie in the text.

Input: the file's bytes.
"""

import math

from kindsl.config.configuration import Configuration
from kindsl.config.errors import ConfigurationError
from kindsl.config.reading import configuration_of

_NAMES = ("kindsl.toml", "pyproject.toml")


def one_input(data: bytes) -> None:
    """Read a configuration under both names that one may have."""
    text = data.decode("utf-8", "replace")
    for name in _NAMES:
        try:
            _check(configuration_of(name, text))
        except ConfigurationError as error:
            assert error.problems
            for problem in error.problems:
                place = problem.place
                assert 0 <= place.start <= place.end <= len(text)
                assert place.line >= 1 and place.column >= 1
                assert problem.message and "\n" not in problem.message


def _check(configuration: Configuration) -> None:
    for document in ("arm.kindsl", "arms/arm.kindsl"):
        for binding in configuration.settings_for(document).bindings.values():
            low, high = binding.minimum, binding.maximum
            assert math.isfinite(binding.value)
            assert low is None or high is None or low <= high
