"""Patterns as in `.gitignore`, for the documents of a table and for files that git ignores.

Matching takes time in proportion to pattern times path. `pathspec` makes regular expressions in
which each `*` may be tried at every place for every place of those before; but what follows a `*`
up to the next one can be taken where it fits first: the next one takes whatever comes between.
"""

import os
import re
from collections.abc import Container, Iterable, Iterator
from functools import cache
from typing import Any

from pathspec import GitIgnoreSpec
from pathspec.patterns.gitignore.spec import GitIgnoreSpecPattern

_STAR = "[^/]*"
# What pathspec writes for `**` at the beginning and between others.
_ANY_FOLDERS = {"(?:.+/)?": "(?:.+?/)??", "(?:/.+)?": "(?:/.+?)??"}
_TOKEN = re.compile(
    r"\[\^/\][*+]?|\(\?:\.\+/\)\?|\(\?:/\.\+\)\?|\(.*|\\.|\[\^?\]?[^]]*\]|.", re.DOTALL
)
_NO_SLASH = "(?!/)"  # In git, and so that what follows a `*` stays within a name.


class LinearPattern(GitIgnoreSpecPattern):
    """A pattern of git's that tries no place twice."""

    __slots__ = ()

    @classmethod
    def pattern_to_regex(cls, pattern: Any) -> tuple[Any, bool | None]:
        """Return the regular expression of a pattern, and whether it includes what it matches."""
        expression, is_included = super().pattern_to_regex(pattern)
        return None if expression is None else linear(expression), is_included


def spec_of(lines: Iterable[str]) -> GitIgnoreSpec:
    """Return what lines of a `.gitignore` match.

    Raises:
        ValueError: One of them is no pattern.
    """
    try:
        # Other backends of pathspec know no groups that are not gone back into.
        return GitIgnoreSpec.from_lines(lines, LinearPattern, backend="simple")
    except re.error as error:
        raise ValueError(str(error)) from None


def can_match(pattern: str) -> bool:
    """Return whether a pattern can match anything."""
    try:
        return any(each.include for each in _spec(pattern).patterns)
    except ValueError:
        return False


def is_match(file: str, pattern: str, document: str) -> bool:
    """Return whether a document is one that a pattern in a configuration file names.

    A pattern with a slash counts from the file's folder; one without matches a name at
    any depth. `**` stands for any folders.
    """
    folder = os.path.dirname(os.path.abspath(file))
    path = os.path.relpath(os.path.abspath(document), folder).replace(os.sep, "/")
    return _spec(pattern).match_file(path)


@cache
def _spec(pattern: str) -> GitIgnoreSpec:
    return spec_of([pattern])


def linear(expression: str) -> str:
    """Return a regular expression of pathspec's that matches the same without going back."""
    tokens = [_within_name(token) for token in _TOKEN.findall(expression)]
    parts = list(_split(tokens, _ANY_FOLDERS))
    rewritten = [_without_return(tokens) for tokens in parts]
    for number in range(1, len(parts) - 1):
        rewritten[number] = _first_place(rewritten[number])
    return "".join(rewritten)


def _within_name(token: str) -> str:
    if token[0] != "[" or token.startswith("[^/]"):
        return token
    # What is more than a sign to Python's expressions.
    return _NO_SLASH + "[" + re.sub(r"[\[&~|]", r"\\\g<0>", token[1:])


def _split(tokens: list[str], heads: Container[str]) -> Iterator[list[str]]:
    """Yield the tokens before the first head, then each head with what follows it."""
    part: list[str] = []
    for token in tokens:
        if token in heads:
            yield part
            part = []
        part.append(token)
    yield part


def _first_place(part: str) -> str:
    """Return a part that begins with any folders, for the fewest of them."""
    head = next(head for head in _ANY_FOLDERS if part.startswith(head))
    return f"(?>{_ANY_FOLDERS[head]}{part.removeprefix(head)}(?=/))"


def _without_return(tokens: list[str]) -> str:
    """Return tokens in which only the last star of a name may be tried at several places."""
    parts = list(_split(tokens, (_STAR, "/")))
    text = ""
    for part, behind in zip(parts, [*parts[1:], ["/"]], strict=True):
        joined = "".join(part)
        if part[:1] == [_STAR] and behind[0] == _STAR:
            joined = f"(?>[^/]*?{joined.removeprefix(_STAR)})"
        text += joined
    return text
