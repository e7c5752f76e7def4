"""From the paths on the command line to documents."""

import os
import stat
from collections.abc import Callable, Collection, Iterator

from kindsl.frontends.cli.documents.sources import STDIN, reason
from kindsl.frontends.cli.outcome import Failure
from kindsl.judgement.config.robots import SUFFIX, TOOLS_FOLDERS, Obstacle, is_robot, walked

_HERE = os.curdir + os.sep


def documents(
    paths: list[str],
    excluded: Collection[str] = TOOLS_FOLDERS,
    suffixes: tuple[str, ...] = (SUFFIX,),
    is_wanted: Callable[[str], bool] = lambda _: True,
) -> Iterator[str | Failure]:
    """Yield each document once: files as named, folders with all documents below.

    `.gitignore` files, excluded names, suffixes and whether one is wanted hold for what a folder
    brings, not for what is named.
    """
    seen: set[str] = set()
    for path in paths:
        for found in _documents_of(path, excluded, suffixes, is_wanted):
            key = str(found) if isinstance(found, Failure) else _identity(found)
            if key not in seen:
                seen.add(key)
                yield found


def _identity(path: str) -> str:
    """Return a key that two paths to the same file share; links to files stay apart."""
    folder, name = os.path.split(path)
    return os.path.join(os.path.realpath(folder), name)


def shown_path(path: str) -> str:
    """Return a path without `./` in front, which says nothing unless `-` is a file."""
    shown = path
    while shown.startswith(_HERE):
        shown = shown[len(_HERE) :].lstrip(os.sep)
    return path if shown in ("", STDIN) else shown


def _documents_of(
    path: str,
    excluded: Collection[str],
    suffixes: tuple[str, ...],
    is_wanted: Callable[[str], bool],
) -> Iterator[str | Failure]:
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
        yield shown_path(path)
        return
    is_empty = True
    for found in walked(path, excluded, suffixes):
        is_empty = False
        if isinstance(found, Obstacle):
            yield _failure(found)
        elif is_wanted(shown := shown_path(found)):
            yield shown
    if is_empty and is_robot(path):
        yield Failure(path, "is a folder, not a file")


def _failure(obstacle: Obstacle) -> Failure:
    path, why = obstacle
    # Of a folder it is the list of names that cannot be read.
    verb = "listed" if os.path.isdir(path) else "read"
    return Failure(shown_path(path), reason(path, why).replace("read", verb))
