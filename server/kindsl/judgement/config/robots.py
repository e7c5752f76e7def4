"""The robots in a folder, for the command line and for editors, and the one beside a document."""

import os
import stat
from collections.abc import Callable, Collection, Iterator
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from pathlib import Path

    from kindsl.judgement.config.gitignore import Ignored

SUFFIX = ".kindsl"
# What tools put into a project beside its sources; the list is that of the linter ruff.
TOOLS_FOLDERS = frozenset((
    ".direnv", ".eggs", ".ipynb_checkpoints", ".mypy_cache", ".nox", ".pants.d", ".pyenv",
    ".pytest_cache", ".pytype", ".ruff_cache", ".tox", ".venv", ".vscode", "__pypackages__",
    "_build", "buck-out", "build", "dist", "node_modules", "site-packages", "venv",
))  # fmt: skip
_VERSION_CONTROL = frozenset((".bzr", ".git", ".git-rewrite", ".hg", ".jj", ".svn"))


class Obstacle(NamedTuple):
    """A possible robot, or folder of robots, that cannot be read."""

    path: str
    reason: OSError


def walked(
    folder: str, excluded: Collection[str] = TOOLS_FOLDERS, suffixes: tuple[str, ...] = (SUFFIX,)
) -> Iterator[str | Obstacle]:
    """Yield the robots in a folder and in the folders below, in the order of their names.

    What git ignores is left out, unless that is the folder itself; so are links to folders, pipes,
    devices, and the folders of version control.

    Args:
        folder: Where to begin, whatever it is called.
        excluded: Names of folders that are left out.
        suffixes: How what is wanted ends, in small letters.
    """
    from kindsl.judgement.config.gitignore import Ignored

    skipped = frozenset(excluded) | _VERSION_CONTROL
    yield from _walk(folder, skipped, suffixes, Ignored.above(folder))


def robots_below(folder: "Path") -> "Iterator[Path]":
    """Yield the robots in a folder that can be read; see `walked`."""
    from pathlib import Path

    for found in walked(str(folder)):
        if isinstance(found, str):
            yield Path(found)


def is_robot(name: str) -> bool:
    """Return whether a file has the name of a robot's document."""
    return name.lower().endswith(SUFFIX)


def robot_beside(path: str, robot: str | None, name_of: Callable[[str], str | None]) -> str | None:
    """Return the file of the robot in the same folder, None if that is ambiguous.

    It is the document of the same name, else the one with the same robot, else the only one.

    Args:
        path: The transforms document.
        robot: The robot's name in it, if there is one.
        name_of: Returns the name of the robot that a file describes, None without one.
    """
    same_name = os.path.splitext(path)[0] + SUFFIX
    if os.path.isfile(same_name):
        return same_name
    folder = os.path.dirname(path) or os.curdir
    files = [os.path.join(folder, name) for name in sorted(os.listdir(folder))]
    robots = [file for file in files if file.endswith(SUFFIX)]
    chosen = [file for file in robots if robot is not None and name_of(file) == robot] or robots
    return chosen[0] if len(chosen) == 1 else None


def _walk(
    folder: str, skipped: frozenset[str], suffixes: tuple[str, ...], ignored: "Ignored"
) -> Iterator[str | Obstacle]:
    try:
        with os.scandir(folder) as listing:
            entries = sorted(listing, key=lambda entry: entry.name)
    except OSError as error:
        yield Obstacle(folder, error)
        return
    ignored = ignored.below(folder)
    for entry in entries:
        is_folder = entry.is_dir(follow_symlinks=False)
        is_wanted = is_folder or entry.name.lower().endswith(suffixes)
        if not is_wanted or (is_folder and entry.name in skipped):
            continue
        if ignored.covers(entry.path, is_folder):
            continue
        if is_folder:
            yield from _walk(entry.path, skipped, suffixes, ignored)
        else:
            yield from _robot(entry)


def _robot(entry: "os.DirEntry[str]") -> Iterator[str | Obstacle]:
    try:
        if stat.S_ISREG(entry.stat().st_mode):
            yield entry.path
    except OSError as error:
        yield Obstacle(entry.path, error)
