"""Files that git ignores, by the `.gitignore` files of a folder and of those above it."""

import os
from typing import TYPE_CHECKING, NamedTuple

from kindsl.judgement.config.discovery import upwards

if TYPE_CHECKING:
    from pathspec import GitIgnoreSpec


class Ignored(NamedTuple):
    """The patterns that apply in a folder, the nearest last.

    Attributes:
        levels: Folders with an ignore file, absolute, and the patterns in it.
    """

    levels: tuple[tuple[str, "GitIgnoreSpec"], ...] = ()

    @classmethod
    def above(cls, folder: str) -> "Ignored":
        """Return the patterns of the folders above one, up to the repository's root.

        If they ignore the folder itself, nothing: who names it wants it.
        """
        above = _up_to_repository(folder)
        if not above:
            return cls()
        ignored = cls()._with(above[-1], os.path.join(above[-1], ".git", "info", "exclude"))
        for parent in reversed(above[1:]):
            ignored = ignored.below(parent)
        return cls() if ignored.covers(folder, is_folder=True) else ignored

    def below(self, folder: str) -> "Ignored":
        """Return these patterns and those of a folder's own `.gitignore`."""
        return self._with(folder, os.path.join(folder, ".gitignore"))

    def covers(self, path: str, is_folder: bool) -> bool:
        """Return whether a file or folder is ignored; the nearest pattern decides."""
        if not self.levels:
            return False
        absolute = os.path.abspath(path)
        for folder, spec in reversed(self.levels):
            relative = os.path.relpath(absolute, folder).replace(os.sep, "/")
            verdict = spec.check_file(relative + "/" if is_folder else relative).include
            if verdict is not None:
                return verdict
        return False

    def _with(self, folder: str, file: str) -> "Ignored":
        if not os.path.isfile(file):
            return self
        try:
            with open(file, encoding="utf-8", errors="surrogateescape") as stream:
                lines = stream.read().splitlines()
        except OSError:
            return self
        return Ignored((*self.levels, (os.path.abspath(folder), _spec(lines))))


def _up_to_repository(folder: str) -> list[str]:
    folders = []
    for above in upwards(folder):
        folders.append(above)
        if os.path.exists(os.path.join(above, ".git")):
            return folders
    return []


def _spec(lines: list[str]) -> "GitIgnoreSpec":
    from kindsl.judgement.config.patterns import spec_of

    usable = []
    for line in lines:
        try:
            spec_of([line])
        except ValueError:
            continue
        usable.append(line)
    return spec_of(usable)
