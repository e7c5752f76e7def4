"""Patterns of a `.gitignore`: matched or refused, whatever they are, and without waiting.

Input: patterns, one a line; the last line is the path.
"""

import warnings

from pathspec import GitIgnoreSpec

from kindsl.judgement.config.patterns import can_match, is_match, spec_of

_LONGEST = 2000
# The library tries more ways than there are atoms for more, and lets a class match a slash.
_FEW_STARS = 4
_CLASSES = frozenset("[\\")


def one_input(data: bytes) -> None:
    """Match a path; where the library does not take for ever, hold the answer against its own."""
    text = data.decode("utf-8", "replace").replace("\0", "")[:_LONGEST]
    *lines, path = text.split("\n")
    with warnings.catch_warnings(action="ignore"):  # of `[[` and `--`, which mean what they say
        for line in filter(can_match, lines):
            is_match("kindsl.toml", line, path or "a")
        try:
            found = spec_of(lines).check_file(path).include
        except ValueError:
            return
        if text.count("*") <= _FEW_STARS and not _CLASSES & set(text):
            assert found == GitIgnoreSpec.from_lines(lines).check_file(path).include
