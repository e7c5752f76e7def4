"""Reads two versions of a document, one of which may not exist."""

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

from kindsl.frontends.cli.documents.document_reading import (
    CommandError,
    read_whole,
    require_parameters,
    shown_name,
)
from kindsl.frontends.cli.outcome import Failure, as_failures
from kindsl.judgement.config.errors import ConfigurationError

if TYPE_CHECKING:
    from kindsl.frontends.cli.documents.choices import Choices
    from kindsl.judgement.analysis.analysis import Analysis

Versions = tuple["Analysis | None", "Analysis | None"]

_SPACE = "\ufeff \t\r\n"


def read_versions(paths: Sequence[str], choices: "Choices") -> Versions:
    """Return two versions; /dev/null is a missing one, as in git.

    Raises:
        CommandError: A file or the configuration cannot be read, or a file is another format's.
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
        CommandError: The configuration cannot be read, or the document is another format's.
    """
    for text in texts:
        require_own(path, text or "")
    return _analysed(path, texts, (path, path), choices)


def _analysed(
    named: str, texts: Sequence[str | None], paths: Sequence[str], choices: "Choices"
) -> Versions:
    from kindsl.judgement.analysis.analysis import analyse

    try:
        old, new = (
            None if text is None else analyse(text, choices.settings_for(shown_name(path)))
            for text, path in zip(texts, paths, strict=True)
        )
    except ConfigurationError as error:
        raise CommandError(as_failures(error)) from None
    require_parameters(named, *(version for version in (old, new) if version is not None))
    return old, new


def _text(path: str) -> str | None:
    if path == os.devnull:
        return None
    text = read_whole(path)
    require_own(path, text)
    return text


def require_own(path: str, text: str) -> None:
    """Raise CommandError for a document in another format, which might be read in part."""
    from kindsl.robots.interchange.registry import format_of_suffix

    foreign = format_of_suffix(os.path.splitext(path)[1])
    if foreign is None and not text.lstrip(_SPACE).startswith("<"):
        return
    what = "XML" if foreign is None else foreign.title
    message = f"is {what}, not a Kinematics-DSL document: convert it first with kindsl convert"
    raise CommandError([Failure(shown_name(path), message)])
