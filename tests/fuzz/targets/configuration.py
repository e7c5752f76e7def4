"""A kindsl.toml or pyproject.toml: a configuration, or problems that lie in the text.

Input: the file's bytes.
"""

import math
import re
from collections.abc import Iterator

from kindsl.judgement.config.configuration import Configuration
from kindsl.judgement.config.configuration_reading import configuration_of
from kindsl.judgement.config.errors import ConfigurationError

_LONGEST = 1000
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
    for document in ("arm.kindsl", "arms/arm.kindsl", *_named(configuration)):
        for binding in configuration.settings_for(document).bindings.values():
            low, high = binding.minimum, binding.maximum
            assert math.isfinite(binding.value)
            assert low is None or high is None or low <= high


def _named(configuration: Configuration) -> Iterator[str]:
    """Yield documents that patterns match, or nearly: what makes a matcher look everywhere."""
    for table in configuration.documents:
        for filling in ("", "a", "arm/arm", table.pattern[-1:] * 40):
            name = re.sub(r"[*?]+|\[[^]]*\]", lambda _, text=filling: text, table.pattern)
            for end in ("", "x"):
                yield name.replace("\0", "")[:_LONGEST] + end
