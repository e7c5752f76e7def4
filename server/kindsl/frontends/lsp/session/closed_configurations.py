"""Problems of configuration files on disk that the editor does not show, and their changes.

Many clients watch no files. Others watch those below their folders only, and hear nothing of the
files in a folder that is deleted as a whole.
"""

import asyncio
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from typing import Any

from kindsl.frontends.lsp.session.configuration_files import configuration_problems, shown_problems
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.worker import Urgency, start_task
from kindsl.frontends.lsp.session.workspace import CONFIGURATION_FILES
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document, document
from kindsl.judgement.config.errors import ConfigurationError

Problems = list[dict[str, Any]]

INTERVAL = 1.0  # seconds


class ClosedConfigurations:
    """Reports what is wrong with each file as it is on disk; one that is open speaks for itself.

    A file that had problems is looked at until nothing is wrong with it, whatever became of it and
    whether or not a robot still depends on it.
    """

    __slots__ = ("_publish", "_reported", "_state")

    def __init__(self, state: State, publish: Callable[[str, Problems], None]) -> None:
        self._state = state
        self._publish = publish
        self._reported: dict[str, tuple[str, Problems]] = {}
        state.documents.on_close.append(self._closed)
        state.on_findings.append(self._found)

    async def watch(self, on_change: Callable[[], None]) -> None:
        """Look again and again at the files that decide for documents, until cancelled."""
        while True:
            await asyncio.sleep(INTERVAL)
            if await self._state.worker.run(
                self._state.workspace.project.is_outdated, Urgency.BACKGROUND
            ):
                self._state.workspace.forget()
                on_change()
            else:
                await self.look_again()

    async def look_again(self) -> None:
        """Report what has become of files that had problems."""
        if self._reported:
            await self.look()

    async def look(self, changed: Iterable[str] = ()) -> None:
        """Report what has become of files: those that changed, and those that were broken."""
        broken = map(uris.uri, tuple(self._state.workspace.project.broken))
        reported = (uri for uri, _ in self._reported.values())
        candidates = {uris.key(uri): uri for uri in (*broken, *changed, *reported)}
        for key, uri in candidates.items():
            path = uris.path(uri)
            if path is None or uris.basename(uri) not in CONFIGURATION_FILES:
                continue
            read = partial(self._on_disk, uri, path)
            problems = await self._state.worker.run(read, Urgency.DIAGNOSTICS)
            if not self._state.documents.is_open(uri):
                self._report(key, uri, problems)

    def forget(self, uri: str) -> None:
        """Note that something else was published for a file."""
        self._reported.pop(uris.key(uri), None)

    def _closed(self, document: Document) -> None:
        self.forget(document.uri)
        start_task(self.look([document.uri]))

    def _found(self, *_: object) -> None:
        if self._state.workspace.project.broken:
            start_task(self.look())

    def _report(self, key: str, uri: str, problems: Problems) -> None:
        if problems != self._reported.get(key, (uri, []))[1]:
            self._publish(uri, problems)
        if problems:
            self._reported[key] = uri, problems
        else:
            self._reported.pop(key, None)

    def _on_disk(self, uri: str, path: Path) -> Problems:
        from kindsl.judgement.config.configuration_reading import text_of
        from kindsl.judgement.config.discovery import is_configuration

        file, encoding = str(path), self._state.documents.encoding
        try:
            text = text_of(file) if is_configuration(file) else None
        except ConfigurationError as error:
            shown = document(uri, None, "", encoding)
            # It may have gone away while it was being read.
            return shown_problems(shown, error.problems) if is_configuration(file) else []
        return [] if text is None else configuration_problems(document(uri, None, text, encoding))
