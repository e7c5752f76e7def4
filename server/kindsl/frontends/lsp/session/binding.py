"""Changes by hand outside the text, written into it or into the project's `kindsl.toml`."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from functools import partial
from typing import NamedTuple

from lsprotocol import types

from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document, document
from kindsl.frontends.lsp.wire.client import asked
from kindsl.frontends.lsp.wire.edits import makes_files, text_edits, workspace_edit
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.file_names import OWN_FILE
from kindsl.language.text.edits import TextEdit, difference

_CHANGED = "the document has changed in the meantime"
_NO_FILE = "the configuration file cannot be written"


class ConfigurationEdit(NamedTuple):
    """An edit of a configuration file; one that is to be made is empty."""

    document: Document
    is_new: bool
    edit: TextEdit


def bound(
    state: State, shown: Document | None, values: Iterable[tuple[str, float]]
) -> ConfigurationEdit | None:
    """Return the edit that binds parameters of a document; None if there is no place for one."""
    from kindsl.judgement.config.toml_edits import binding_edit

    return _edited(state, shown, partial(binding_edit, values=values))


def pose_edit(
    state: State, shown: Document | None, name: str, joints: Mapping[str, float]
) -> ConfigurationEdit | None:
    """Return the edit that keeps a pose of a document; None if there is no place for one."""
    from kindsl.judgement.config.document_tables import with_pose

    def edit(file: str, text: str, robot: str) -> TextEdit | None:
        with suppress(ConfigurationError):
            new = with_pose(file, text, robot, name, joints)
            return None if new is None else difference(text, new)
        return None

    return _edited(state, shown, edit)


async def request_edits(
    view: View, label: str, edits: Sequence[TextEdit], bindings: Sequence[tuple[str, float]] = ()
) -> str:
    """Have the client make edits of the version that a view shows, as one step of undo.

    Returns:
        Why nothing was written, or an empty text.
    """
    made: list[tuple[Document, list[types.TextEdit]]] = []
    if edits:
        made.append((view.document, text_edits(view.document, edits)))
    if bindings:
        binding = bound(view.state, view.document, bindings)
        if binding is None or binding.is_new:
            return _NO_FILE
        made.append((binding.document, text_edits(binding.document, [binding.edit])))
    if not made:
        return ""
    params = types.ApplyWorkspaceEditParams(workspace_edit(view.client, made), label=label)
    answer = await asked(view.state.editor.workspace_apply_edit_async(params))
    return "" if answer is not None and answer.applied else _CHANGED


def _edited(
    state: State, shown: Document | None, edit_of: Callable[[str, str, str], TextEdit | None]
) -> ConfigurationEdit | None:
    place = None if shown is None else _place(state, shown)
    if shown is None or place is None:
        return None
    document, is_new = place
    if is_new and not makes_files(state.client):
        return None
    file, robot = str(uris.path(document.uri)), str(uris.path(shown.uri))
    edit = edit_of(file, document.text, robot)
    return None if edit is None else ConfigurationEdit(document, is_new, edit)


def _place(state: State, shown: Document) -> tuple[Document, bool] | None:
    file = state.workspace.configuration_file(shown)
    if file is not None:
        found = state.documents.get(uris.uri(file))
        return None if found is None else (found, False)
    from kindsl.judgement.config.discovery import nearest_configuration

    path = uris.path(shown.uri)
    if path is None or nearest_configuration(str(path.parent)) is not None:
        return None  # nowhere to write it, or a file decides that says something wrong
    around = [folder for folder in state.workspace.paths() if path.is_relative_to(folder)]
    file = max(around, key=lambda folder: len(folder.parts), default=path.parent) / OWN_FILE
    return document(uris.uri(file), None, "", shown.encoding), True
