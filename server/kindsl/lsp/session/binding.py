"""Gives parameters values in the project's `kindsl.toml`, which may have to be made."""

from collections.abc import Iterable
from typing import NamedTuple

from kindsl.config.file_names import OWN_FILE
from kindsl.config.parameter_lines import parameter_lines
from kindsl.lsp.session.state import State
from kindsl.lsp.text import uris
from kindsl.lsp.text.document import Document, document
from kindsl.text.edits import TextEdit


class ConfigurationEdit(NamedTuple):
    """An edit of a configuration file.

    Attributes:
        document: The file, empty if it is to be made.
        is_new: Whether it is to be made.
        edit: The edit of the file.
    """

    document: Document
    is_new: bool
    edit: TextEdit


def bound(
    state: State, shown: Document, values: Iterable[tuple[str, float]]
) -> ConfigurationEdit | None:
    """Return the edit that binds parameters of a document; None if there is no place for one."""
    file = state.workspace.configuration_file(shown)
    if file is None:
        return _new_file(state, shown, parameter_lines(values))
    found = state.documents.get(uris.uri(file))
    if found is None:
        return None
    from kindsl.config.toml_edits import binding_edit

    edit = binding_edit(str(file), found.text, str(uris.path(shown.uri)), values)
    return None if edit is None else ConfigurationEdit(found, False, edit)


def _new_file(state: State, shown: Document, lines: list[str]) -> ConfigurationEdit | None:
    """Return a new file beside the document, in the innermost workspace folder if there is one."""
    from kindsl.config.discovery import nearest_configuration

    path = uris.path(shown.uri)
    if path is None or nearest_configuration(str(path.parent)) is not None:
        return None  # nowhere to write it, or a file decides that says something wrong
    around = [folder for folder in state.workspace.paths() if path.is_relative_to(folder)]
    file = max(around, key=lambda folder: len(folder.parts), default=path.parent) / OWN_FILE
    empty = document(uris.uri(file), None, "", shown.encoding)
    return ConfigurationEdit(empty, True, TextEdit(0, 0, "\n".join(("[parameters]", *lines, ""))))
