"""Which documents a `[[document]]` table is for."""

import os
from functools import cache

from pathspec import GitIgnoreSpec


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
    return GitIgnoreSpec.from_lines([pattern])
