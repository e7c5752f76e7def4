"""Folders and their settings: what the editor says, merged with `kindsl.toml`."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from lsprotocol import types

from kindsl.config.configuration import ConfigurationError, ConfigurationProblem
from kindsl.config.discovery import Configurations
from kindsl.lsp import uris
from kindsl.lsp.settings import EditorSettings, editor_settings, merged
from kindsl.rules.settings import Settings

if TYPE_CHECKING:
    from kindsl.lsp.document import Document

CONFIGURATION_FILES = ("kindsl.toml", "pyproject.toml")


class Workspace:
    """The folders that the editor has open, and who decides what in them.

    Attributes:
        folders: Their URIs.
        broken: What is wrong with configuration files, by path.
    """

    def __init__(self) -> None:
        self.folders: dict[str, str] = {}
        self._editor: dict[str, EditorSettings] = {}
        self._default = EditorSettings()
        self._merged: dict[str, Settings] = {}
        self._configurations = Configurations()
        self.broken: dict[str, tuple[ConfigurationProblem, ...]] = {}

    def add_folders(self, folders: Iterable[types.WorkspaceFolder]) -> None:
        """Open folders."""
        for folder in folders:
            self.folders[uris.key(folder.uri)] = folder.uri
        self.forget()

    def remove_folders(self, folders: Iterable[types.WorkspaceFolder]) -> None:
        """Close folders."""
        for folder in folders:
            self.folders.pop(uris.key(folder.uri), None)
            self._editor.pop(uris.key(folder.uri), None)
        self.forget()

    def set_editor_settings(self, raw: object, folder: str | None = None) -> EditorSettings:
        """Take the section `kindsl` for all, or for one folder; return it as understood."""
        settings = editor_settings(raw)
        if folder is None:
            self._default = settings
        else:
            self._editor[uris.key(folder)] = settings
        self.forget()
        return settings

    def editor_settings(self, uri: str) -> EditorSettings:
        """Return what the editor says for a document: its innermost folder's word."""
        key = uris.key(uri)
        inside = [folder for folder in self._editor if key.startswith(folder.rstrip("/") + "/")]
        return self._editor[max(inside, key=len)] if inside else self._default

    def settings(self, document: "Document") -> "Settings":
        """Return the decisions for a document."""
        key = uris.key(document.uri)
        if key not in self._merged:
            editor = self.editor_settings(document.uri).rules
            self._merged[key] = merged(self._project_settings(document.uri), editor)
        return self._merged[key]

    def snapshot(self) -> object:
        """Return what the editor has said, to see later whether it says something else."""
        return self._default, dict(self._editor)

    def files(self) -> Iterator[Path]:
        """Yield the robots in all folders."""
        for folder in self.paths():
            yield from folder.rglob("*.kindsl")

    def forget(self) -> None:
        """Read and merge settings again when they are next asked for."""
        self._merged.clear()
        self._configurations = Configurations()
        self.broken.clear()

    def _project_settings(self, uri: str) -> Settings:
        """Return what the nearest `kindsl.toml` says; nothing, if it says something wrong."""
        path = uris.path(uri) or next((f / "untitled.kindsl" for f in self.paths()), None)
        if path is None:
            return Settings()
        try:
            found = self._configurations.above(str(path))
        except ConfigurationError as error:
            self.broken[str(Path(error.problems[0].path).absolute())] = error.problems
            return Settings()
        return Settings() if found is None else found.settings_for(str(path))

    def paths(self) -> Iterator[Path]:
        """Yield the paths of the folders."""
        for uri in self.folders.values():
            path = uris.path(uri)
            if path is not None:
                yield path
