"""Folders and their settings: what the editor says, merged with `kindsl.toml`.

Settings are kept as they came until they are first asked for, since all that gives them a meaning
loads only after the client has its answer to `initialize`.
"""

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from lsprotocol import types

from kindsl.frontends.lsp.text import uris
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.file_names import OWN_FILE, PYTHON_FILE
from kindsl.judgement.config.robots import robots_below
from kindsl.language.text.saves import Stamp, stamp

if TYPE_CHECKING:
    from kindsl.frontends.lsp.text.document import Document
    from kindsl.judgement.analysis.settings import Settings
    from kindsl.judgement.config.configuration import Configuration, ConfigurationProblem
    from kindsl.judgement.config.discovery import Configurations
    from kindsl.judgement.config.editor_settings import EditorSettings
    from kindsl.robots.comparison.twins import TwinFile

CONFIGURATION_FILES = (OWN_FILE, PYTHON_FILE)


class Workspace:
    """The folders that the editor has open, and who decides what in them.

    Attributes:
        folders: Their URIs.
        project: What the configuration files said when they were read.
        is_trusted: Whether the user trusts what lies in them, as editors ask.
    """

    def __init__(self) -> None:
        self.folders: dict[str, str] = {}
        self._raw: dict[str | None, object] = {}
        self._understood: dict[str | None, EditorSettings] = {}
        self.project = _Project()
        self.is_trusted = True

    def may_read(self, path: str) -> bool:
        """Return whether a file that a configuration names may be read: outside only if trusted."""
        return self.is_trusted or any(Path(path).is_relative_to(each) for each in self.paths())

    def add_folders(self, folders: Iterable[types.WorkspaceFolder]) -> None:
        """Open folders."""
        for folder in folders:
            self.folders[uris.key(folder.uri)] = folder.uri
        self.forget()

    def remove_folders(self, folders: Iterable[types.WorkspaceFolder]) -> None:
        """Close folders."""
        for folder in folders:
            self.folders.pop(uris.key(folder.uri), None)
            self._raw.pop(uris.key(folder.uri), None)
        self.forget()

    def set_editor_settings(self, raw: object, folder: str | None = None) -> bool:
        """Take the section `kindsl` for all, or for one folder; return whether it is new."""
        scope = None if folder is None else uris.key(folder)
        is_new = self._raw.get(scope) != raw
        self._raw[scope] = raw
        if is_new:
            self.forget()
        return is_new

    def editor_settings(self, uri: str) -> "EditorSettings":
        """Return what the editor says for a document: its innermost folder's word."""
        key = uris.key(uri)
        inside = [scope for scope in self._raw if scope and _is_below(key, scope)]
        return self._understand(max(inside, key=len) if inside else None)

    def problems(self) -> list[str]:
        """Return a sentence for each of the editor's settings that makes no sense."""
        return [p for scope in self._raw for p in self._understand(scope).problems]

    def known_settings(self, document: "Document") -> "Settings | None":
        """Return the decisions for a document if they have been read already."""
        return self.project.merged.get(uris.key(document.uri))

    def read_settings(self, document: "Document") -> "Settings":
        """Return the decisions for a document; reads files, so not for the message loop."""
        from kindsl.judgement.config.editor_settings import merged

        project, key = self.project, uris.key(document.uri)
        if key not in project.merged:
            path = uris.path(document.uri)
            place = path or next((f / "untitled.kindsl" for f in self.paths()), None)
            editor = self.editor_settings(document.uri).rules
            found = project.settings(place)
            twins = tuple(twin for twin in found.twins if self.may_read(twin.path))
            project.merged[key] = merged(found._replace(twins=twins), editor)
        return project.merged[key]

    def configuration_file(self, document: "Document") -> Path | None:
        """Return the file that decides for a document besides the editor, if it is valid."""
        return self.project.file(uris.path(document.uri))

    def forget(self) -> None:
        """Read and merge settings again when they are next asked for."""
        self._understood = {}
        self.project = _Project()

    def paths(self) -> Iterator[Path]:
        """Yield the paths of the folders."""
        for uri in self.folders.values():
            path = uris.path(uri)
            if path is not None:
                yield path

    def files(self) -> Iterator[Path]:
        """Yield the robots in all folders."""
        for folder in self.paths():
            yield from robots_below(folder)

    def _understand(self, scope: str | None) -> "EditorSettings":
        from kindsl.judgement.config.editor_settings import editor_settings

        if scope not in self._understood:
            self._understood[scope] = editor_settings(self._raw.get(scope))
        return self._understood[scope]


class _Project:
    """The configuration files' content at one moment."""

    __slots__ = ("_configurations", "_stamps", "broken", "merged")

    def __init__(self) -> None:
        self._configurations: Configurations | None = None
        self._stamps: dict[str, Stamp | None] = {}
        self.broken: dict[Path, tuple[ConfigurationProblem, ...]] = {}
        self.merged: dict[str, Settings] = {}

    def settings(self, document: Path | None) -> "Settings":
        """Return what the nearest `kindsl.toml` says; nothing, if it says something wrong."""
        from kindsl.judgement.analysis.settings import Settings

        if document is None:
            return Settings()
        found = self._above(document)
        if found is None:
            return Settings()
        settings = found.settings_for(str(document))
        twins = tuple(map(self._watched, settings.twins))
        return settings._replace(known=self._known(found, document), twins=twins)

    def file(self, document: Path | None) -> Path | None:
        """Return the nearest configuration file above a document, if it is valid."""
        found = self._above(document) if document is not None else None
        return Path(found.path).absolute() if found is not None else None

    def is_outdated(self) -> bool:
        """True if a file that decides for a document has appeared, changed or gone."""
        return any(stamp(path) != known for path, known in self._stamps.items())

    def _watched(self, twin: "TwinFile") -> "TwinFile":
        """Return a twin that differs from itself after each change of its files."""
        from kindsl.judgement.analysis.twins import watched_files

        files = list(watched_files([twin]))
        for path in files:
            self._stamps.setdefault(path, stamp(path))
        return twin._replace(version=tuple(self._stamps[path] for path in files))

    def _known(self, configuration: "Configuration", document: Path) -> "Mapping[str, int]":
        from kindsl.judgement.config.baseline import baseline_path, known_findings

        path = baseline_path(configuration)
        if path:
            self._stamps.setdefault(path, stamp(path))
        try:
            return known_findings(configuration, str(document))
        except ConfigurationError as error:
            self.broken[Path(configuration.path).absolute()] = error.problems
            return {}

    def _above(self, document: Path) -> "Configuration | None":
        from kindsl.judgement.config.discovery import Configurations, candidates

        self._configurations = self._configurations or Configurations()
        for candidate in candidates(str(document.parent)):
            if candidate in self._stamps:
                break
            self._stamps[candidate] = stamp(candidate)
        try:
            return self._configurations.above(str(document))
        except ConfigurationError as error:
            self.broken[Path(error.problems[0].path).absolute()] = error.problems
            return None


def _is_below(key: str, folder: str) -> bool:
    return key.startswith(folder.rstrip("/") + "/")
