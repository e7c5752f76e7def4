"""Problems of configuration files on disk that the editor does not show."""

from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from typing import Any

from kindsl.frontends.lsp.session.configuration_diagnostics import shown_problems
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.worker import Urgency
from kindsl.frontends.lsp.session.workspace import CONFIGURATION_FILES
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import document

Problems = list[dict[str, Any]]


class ClosedConfigurations:
    """Tells what is wrong with each file as it is on disk; a file that is open speaks for itself.

    A file that was told of is looked at until nothing is wrong with it, whatever became of it and
    whether or not a robot still depends on it.
    """

    __slots__ = ("_publish", "_state", "_told")

    def __init__(self, state: State, publish: Callable[[str, Problems], None]) -> None:
        self._state = state
        self._publish = publish
        self._told: dict[str, tuple[str, Problems]] = {}

    @property
    def is_anything_told(self) -> bool:
        """True if a file had problems when it was last looked at."""
        return bool(self._told)

    async def look(self, changed: Iterable[str] = ()) -> None:
        """Tell what has become of files: those that changed, and those that were broken.

        Args:
            changed: URIs of files that are to be read even if nobody has asked for them.
        """
        broken = map(uris.uri, tuple(self._state.workspace.broken))
        told = (uri for uri, _ in self._told.values())
        candidates = {uris.key(uri): uri for uri in (*broken, *changed, *told)}
        for key, uri in candidates.items():
            path = uris.path(uri)
            if path is None or uris.basename(uri) not in CONFIGURATION_FILES:
                continue
            read = partial(self._on_disk, uri, path)
            problems = await self._state.worker.run(read, Urgency.DIAGNOSTICS)
            if not self._state.documents.is_open(uri):
                self._tell(key, uri, problems)

    def forget(self, uri: str) -> None:
        """Something else was told of a file."""
        self._told.pop(uris.key(uri), None)

    def _tell(self, key: str, uri: str, problems: Problems) -> None:
        if problems != self._told.get(key, (uri, []))[1]:
            self._publish(uri, problems)
        if problems:
            self._told[key] = uri, problems
        else:
            self._told.pop(key, None)

    def _on_disk(self, uri: str, path: Path) -> Problems:
        from kindsl.judgement.config.baseline import read_baseline
        from kindsl.judgement.config.configuration import ConfigurationError
        from kindsl.judgement.config.configuration_reading import configuration_of, text_of
        from kindsl.judgement.config.discovery import is_configuration

        if not is_configuration(str(path)):
            return []
        text = ""
        try:
            text = text_of(str(path))
            read_baseline(configuration_of(str(path), text))
        except ConfigurationError as error:
            if not is_configuration(str(path)):
                return []  # It went away while it was being read.
            shown = document(uri, None, text, self._state.documents.encoding)
            return shown_problems(shown, error.problems)
        return []
