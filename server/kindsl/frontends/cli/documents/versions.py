"""Reads two versions of a document, one of which may not exist."""

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

from kindsl.frontends.cli.documents.document_reading import (
    CommandError,
    analysed_text,
    read_whole,
    require_parameters,
)
from kindsl.frontends.cli.outcome import Failure

if TYPE_CHECKING:
    from kindsl.frontends.cli.documents.choices import Choices
    from kindsl.judgement.analysis.analysis import Analysis

Versions = tuple["Analysis | None", "Analysis | None"]


def read_versions(paths: Sequence[str], choices: "Choices") -> Versions:
    """Return two versions; /dev/null is a missing one, as in git.

    Raises:
        CommandError: A file or the configuration cannot be read, or no robot is in one.
    """
    old, new = (_text(path) for path in paths)
    if old is None and new is None:
        raise CommandError([Failure(os.devnull, "there is no document to compare")])
    named = paths[0] if new is None else paths[1]
    settings = tuple(paths) if None not in (old, new) else (named, named)
    return _analysed(named, (old, new), settings, choices)


def analysed_versions(
    path: str, texts: tuple[str | None, str | None], choices: "Choices"
) -> Versions:
    """Return two versions of one document from its texts; None is a missing one.

    Raises:
        CommandError: The configuration cannot be read, or no robot is in a text.
    """
    return _analysed(path, texts, (path, path), choices)


def _analysed(
    named: str, texts: Sequence[str | None], paths: Sequence[str], choices: "Choices"
) -> Versions:
    old, new = (
        None if text is None else analysed_text(path, text, choices)
        for text, path in zip(texts, paths, strict=True)
    )
    require_parameters(named, *(version for version in (old, new) if version is not None))
    return old, new


def _text(path: str) -> str | None:
    if path == os.devnull:
        return None
    return read_whole(path)
