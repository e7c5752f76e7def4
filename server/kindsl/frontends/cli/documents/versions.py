"""Reads two versions of a document, one of which may not exist."""

import os
from collections.abc import Sequence

from kindsl.frontends.cli.documents.choices import Choices
from kindsl.frontends.cli.documents.document_reading import (
    CommandError,
    analysed_text,
    read_whole,
    require_parameters,
)
from kindsl.judgement.analysis.analysis import Analysis

Versions = tuple[Analysis | None, Analysis | None]


def read_versions(paths: Sequence[str], choices: Choices) -> Versions:
    """Return two versions; /dev/null is a missing one, as in git.

    Raises:
        CommandError: A file or the configuration cannot be read, or no robot is in one.
    """
    texts = [None if path == os.devnull else read_whole(path) for path in paths]
    if texts == [None, None]:
        raise CommandError.about(os.devnull, "there is no document to compare")
    return analysed_versions(paths[0 if texts[1] is None else 1], texts, choices, paths)


def analysed_versions(
    path: str, texts: Sequence[str | None], choices: Choices, paths: Sequence[str] = ()
) -> Versions:
    """Return two versions of a document from its texts; None is a missing one.

    Args:
        path: What errors name.
        texts: Before and after.
        choices: Decisions of the command line.
        paths: Of the versions, where they are files of their own.

    Raises:
        CommandError: The configuration cannot be read, or no robot is in a text.
    """
    old, new = (
        None if text is None else analysed_text(own, text, choices)
        for text, own in zip(texts, paths or (path, path), strict=True)
    )
    require_parameters(path, *(version for version in (old, new) if version is not None))
    return old, new
