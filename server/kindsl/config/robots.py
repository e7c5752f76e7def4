"""The robots in a folder, those left out that git ignores."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kindsl.config.gitignore import Ignored

_SUFFIX = ".kindsl"


def robots_below(folder: Path) -> Iterator[Path]:
    """Yield the documents in a folder and the folders in it, in the order of their names.

    Hidden folders, links to folders and folders that cannot be listed are passed over.
    """
    from kindsl.config.gitignore import Ignored

    yield from _walk(str(folder), Ignored.above(str(folder)))


def _walk(folder: str, ignored: "Ignored") -> Iterator[Path]:
    try:
        with os.scandir(folder) as listing:
            entries = sorted(listing, key=lambda entry: entry.name)
    except OSError:
        return
    ignored = ignored.below(folder)
    for entry in entries:
        is_folder = entry.is_dir(follow_symlinks=False)
        if entry.name.startswith(".") or ignored.covers(entry.path, is_folder):
            continue
        if is_folder:
            yield from _walk(entry.path, ignored)
        elif entry.name.endswith(_SUFFIX) and entry.is_file():
            yield Path(entry.path)
