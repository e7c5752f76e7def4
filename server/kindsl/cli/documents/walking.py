"""From the paths on the command line to the documents that are meant."""

import os
import stat
from collections.abc import Iterator
from typing import TYPE_CHECKING

from kindsl.cli.documents.sources import STDIN, reason
from kindsl.cli.outcome import Failure

if TYPE_CHECKING:
    from kindsl.config.gitignore import Ignored

SUFFIX = ".kindsl"
_HERE = os.curdir + os.sep
_VERSION_CONTROL = frozenset((".git", ".hg", ".svn", ".jj"))


def documents(paths: list[str]) -> Iterator[str | Failure]:
    """Yield each document once: files as named, folders with all documents below.

    `.gitignore` files hold for what a folder brings, not for files that are named.
    """
    seen: set[str] = set()
    for path in paths:
        for found in _documents_of(path):
            key = str(found) if isinstance(found, Failure) else _identity(found)
            if key not in seen:
                seen.add(key)
                yield found


def documents_below(folder: str) -> Iterator[str | Failure]:
    """Yield the documents in a folder and the folders in it, those that git ignores left out."""
    from kindsl.config.gitignore import Ignored

    yield from _walk(folder, Ignored.above(folder))


def _identity(path: str) -> str:
    """Return what two ways to the same file have in common; links to files stay apart."""
    folder, name = os.path.split(path)
    return os.path.join(os.path.realpath(folder), name)


def _shown(path: str) -> str:
    """Return a path without `./` in front, which says nothing unless `-` is a file."""
    shown = path
    while shown.startswith(_HERE):
        shown = shown[len(_HERE) :].lstrip(os.sep)
    return path if shown in ("", STDIN) else shown


def _documents_of(path: str) -> Iterator[str | Failure]:
    if path == STDIN:
        yield STDIN
        return
    try:
        is_folder = stat.S_ISDIR(os.stat(path).st_mode)
    except (OSError, ValueError) as error:
        why = reason(path, error) if isinstance(error, OSError) else str(error)
        yield Failure(path, why)
        return
    if not is_folder:
        yield _shown(path)
        return
    is_empty = True
    for found in documents_below(path):
        is_empty = False
        yield found
    if is_empty and path.endswith(SUFFIX):
        yield Failure(path, "is a folder, not a file")


def _walk(folder: str, ignored: "Ignored") -> Iterator[str | Failure]:
    try:
        with os.scandir(folder) as listing:
            entries = sorted(listing, key=lambda entry: entry.name)
    except OSError as error:
        yield Failure(folder, reason(folder, error).replace("read", "listed"))
        return
    ignored = ignored.below(folder)
    for entry in entries:
        is_folder = entry.is_dir(follow_symlinks=False)
        if entry.name in _VERSION_CONTROL or not (is_folder or entry.name.endswith(SUFFIX)):
            continue
        if ignored.covers(entry.path, is_folder):
            continue
        yield from _walk_folder(entry.path, ignored) if is_folder else _document(entry)


def _walk_folder(path: str, ignored: "Ignored") -> Iterator[str | Failure]:
    is_empty = True
    for found in _walk(path, ignored):
        is_empty = False
        yield found
    if is_empty and path.endswith(SUFFIX):
        yield Failure(_shown(path), "is a folder, not a file")


def _document(entry: "os.DirEntry[str]") -> Iterator[str | Failure]:
    path = _shown(entry.path)
    try:
        mode = entry.stat().st_mode
    except OSError as error:
        yield Failure(path, reason(path, error))
        return
    if stat.S_ISREG(mode):
        yield path
    elif stat.S_ISDIR(mode):
        yield Failure(path, "is a link to a folder, not a file")
    else:
        yield Failure(path, "is not a regular file")
