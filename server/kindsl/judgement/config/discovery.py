"""Finds the configuration that applies to a document: the nearest above it."""

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.file_names import OWN_FILE, PYTHON_FILE

if TYPE_CHECKING:
    from kindsl.judgement.config.configuration import Configuration


class Configurations:
    """Configuration files, each found and read once.

    Attributes:
        fixed: The only file to use, None to look above each document.
    """

    __slots__ = ("_of_file", "_of_folder", "fixed")

    def __init__(self, fixed: str | None = None) -> None:
        self.fixed = fixed
        self._of_folder: dict[str, str | None] = {}
        self._of_file: dict[str, Configuration | ConfigurationError] = {}

    def above(self, document: str) -> "Configuration | None":
        """Return the configuration that applies to a document, None if there is none.

        Raises:
            ConfigurationError: The file has an error, or cannot be read.
        """
        path = self.fixed or self._nearest(os.path.dirname(os.path.abspath(document)))
        if path is None:
            return None
        known = self._of_file.get(path)
        if known is None:
            known = self._of_file[path] = _read(path)
        if isinstance(known, ConfigurationError):
            raise known
        return known

    def _nearest(self, folder: str) -> str | None:
        if folder not in self._of_folder:
            self._of_folder[folder] = nearest_configuration(folder)
        return self._of_folder[folder]


def nearest_configuration(folder: str) -> str | None:
    """Return the path of the configuration file in a folder or the nearest one above.

    It is from the working directory if it lies below.
    """
    for path in candidates(folder):
        if is_configuration(path):
            relative = os.path.relpath(path)
            return path if relative.startswith("..") else relative
    return None


def candidates(folder: str) -> Iterator[str]:
    """Yield the candidates for the configuration file of a folder, the nearest first."""
    for above in upwards(folder):
        yield os.path.join(above, OWN_FILE)
        yield os.path.join(above, PYTHON_FILE)


def upwards(folder: str) -> Iterator[str]:
    """Yield a folder and those above it, the nearest first."""
    folder = os.path.abspath(folder)
    while True:
        yield folder
        above = os.path.dirname(folder)
        if above == folder:
            return
        folder = above


def is_configuration(path: str) -> bool:
    """Return whether a file exists and is a kindsl.toml or has a [tool.kindsl] table."""
    is_own = os.path.basename(path) != PYTHON_FILE
    return os.path.isfile(path) and (is_own or has_python_table(path))


def has_python_table(path: str) -> bool:
    """Return whether a pyproject.toml has a [tool.kindsl] table."""
    try:
        with open(path, "rb") as file:
            content = file.read()
    except OSError:
        return False
    if b"kindsl" not in content:
        return False
    import tomllib

    try:
        tool = tomllib.loads(content.decode("utf-8")).get("tool")
    except ValueError:
        return b"[tool.kindsl" in content
    return isinstance(tool, dict) and "kindsl" in tool


def _read(path: str) -> "Configuration | ConfigurationError":
    from kindsl.judgement.config.configuration_reading import read_configuration

    try:
        return read_configuration(path)
    except ConfigurationError as error:
        return error
