"""The robots in a folder, those left out that git ignores."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathspec import GitIgnoreSpec

_SUFFIX = ".kindsl"

Ignored = tuple[tuple[Path, "GitIgnoreSpec"], ...]


def robots_below(folder: Path, ignored: Ignored = ()) -> Iterator[Path]:
    """Yield the documents in a folder and the folders in it, in the order of their names.

    Hidden folders, links to folders and folders that cannot be listed are passed over.
    """
    ignored = (*ignored, *_own(folder))
    try:
        with os.scandir(folder) as listing:
            entries = sorted(listing, key=lambda entry: entry.name)
    except OSError:
        return
    for entry in entries:
        path = Path(entry.path)
        is_folder = entry.is_dir(follow_symlinks=False)
        if entry.name.startswith(".") or _is_ignored(path, is_folder, ignored):
            continue
        if is_folder:
            yield from robots_below(path, ignored)
        elif entry.name.endswith(_SUFFIX) and entry.is_file():
            yield path


def _own(folder: Path) -> Iterator[tuple[Path, "GitIgnoreSpec"]]:
    try:
        lines = (folder / ".gitignore").read_text("utf-8", "replace").splitlines()
    except OSError:
        return
    from pathspec import GitIgnoreSpec

    try:
        yield folder, GitIgnoreSpec.from_lines(lines)
    except ValueError:
        return  # a pattern that git would not take either


def _is_ignored(path: Path, is_folder: bool, ignored: Ignored) -> bool:
    """Whether a file or folder is ignored; the nearest pattern decides."""
    for folder, spec in reversed(ignored):
        relative = path.relative_to(folder).as_posix()
        verdict = spec.check_file(f"{relative}/" if is_folder else relative).include
        if verdict is not None:
            return verdict
    return False
