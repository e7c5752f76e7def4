"""A session in this process, with an editor that notes what it is told and answers as it is bid."""

import asyncio
import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from lsprotocol import types
from pygls.exceptions import JsonRpcException

from kindsl.frontends.lsp.server import KindslLanguageServer
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.client import Client


class Told:
    """Takes the place of methods of the editor.

    Attributes:
        messages: Names and parameters, in their order.
        answers: What requests are answered with, by name; an exception is raised.
    """

    def __init__(self) -> None:
        self.messages: list[tuple[str, Any]] = []
        self.answers: dict[str, Any] = {}

    def named(self, name: str) -> list[Any]:
        """Return the parameters of the messages of a name."""
        return [params for other, params in self.messages if other == name]

    def note(self, name: str) -> Any:
        """Return a method that notes what it is called with."""
        return lambda params: self.messages.append((name, params))

    def ask(self, name: str) -> Any:
        """Return a method that notes what it is called with and answers."""

        async def answer(params: Any) -> Any:
            self.messages.append((name, params))
            found = self.answers.get(name)
            if isinstance(found, Exception):
                raise found
            return found

        return answer


REFUSAL = JsonRpcException("no")


@contextmanager
def session_with(
    capabilities: types.ClientCapabilities | None = None,
) -> Iterator[tuple[Session, Told]]:
    """A session that has been told what the editor can do."""
    session, told = KindslLanguageServer().session, Told()
    session.loop = asyncio.get_running_loop()
    session.client = Client(capabilities or types.ClientCapabilities(), {})
    editor: Any = session.editor
    asked = ("workspace_apply_edit", "window_work_done_progress_create", "window_show_document")
    for name in asked:
        setattr(editor, f"{name}_async", told.ask(name))
    for name in ("progress", "window_show_message", "workspace_diagnostic_refresh"):
        setattr(editor, name, told.note(name))
    protocol: Any = editor.protocol
    protocol.notify = lambda name, params: told.messages.append((name, params))
    protocol.notify_encoded = lambda name, params: protocol.notify(name, json.loads(params.json))
    yield session, told
    session.helper.stop()


def opened(session: Session, uri: str, text: str, version: int = 1) -> Document:
    """Return a document that the editor shows."""
    session.documents.open(types.TextDocumentItem(uri, "kinematics-dsl", version, text))
    document = session.documents.get(uri)
    assert document is not None
    return document


def of_versions() -> types.ClientCapabilities:
    """Return the capabilities of an editor that ties edits to versions."""
    return types.ClientCapabilities(
        workspace=types.WorkspaceClientCapabilities(
            apply_edit=True,
            workspace_edit=types.WorkspaceEditClientCapabilities(document_changes=True),
        )
    )


def folder_of(path: Path) -> types.WorkspaceFolder:
    """Return a folder as the editor names it."""
    return types.WorkspaceFolder(path.as_uri(), path.name)
