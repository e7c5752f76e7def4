"""Writes the output of a command: to a file, atomically, or to stdout."""

import os
import sys
from collections.abc import Mapping

from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.documents.document_reading import CommandError
from kindsl.frontends.cli.documents.sources import STDIN, reason
from kindsl.frontends.cli.outcome import Failure
from kindsl.language.text.encodings import encoded
from kindsl.language.text.writing import write_file, write_files


def write_text(path: str, shown: str, old: str, new: str) -> Failure | None:
    """Replace a file's text, keeping its mode, its line ends, and the links that lead to it.

    Returns:
        None, or why it could not be written, such as that it is no longer the old text.
    """
    try:
        with open(path, "rb") as file:
            if file.read() != encoded(old):
                return Failure(shown, "has changed meanwhile, not written")
        write_file(path, encoded(new))
    except OSError as error:
        return Failure(shown, unwritable(path, error))
    return None


def write_output(path: str, content: str | bytes, beside: Mapping[str, str] = {}) -> None:
    """Write output to a file, with texts of files beside it, all or none; to stdout for `-`.

    Raises:
        CommandError: It cannot be written; a file that was there is as it was.
    """
    if path == STDIN:
        write(sys.stdout, content)
        return
    try:
        contents = {path: content if isinstance(content, bytes) else encoded(content)}
        write_files(contents | {name: encoded(text) for name, text in beside.items()})
    except OSError as error:
        at = str(error.filename or path)
        raise CommandError.about(at, unwritable(at, error)) from None


def unwritable(path: str, error: OSError) -> str:
    """Return the reason why a file could not be written."""
    folder = os.path.dirname(os.path.realpath(path))
    if isinstance(error, FileNotFoundError) and not os.path.isdir(folder):
        return f"cannot be written: there is no folder '{folder}'"
    return reason(path, error).replace("read", "written")
