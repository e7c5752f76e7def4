"""Gives parameters values in the project's `kindsl.toml`, which may have to be made."""

import re
from collections.abc import Iterable
from typing import NamedTuple

from kindsl.config.file_names import OWN_FILE
from kindsl.config.parameter_lines import parameter_lines
from kindsl.lsp.session.state import State
from kindsl.lsp.text import uris
from kindsl.lsp.text.document import Document, document
from kindsl.text.edits import TextEdit


class Binding(NamedTuple):
    """An edit of a configuration file.

    Attributes:
        document: The file, empty if it is to be made.
        is_new: Whether it is to be made.
        edit: What to write where.
    """

    document: Document
    is_new: bool
    edit: TextEdit


def bound(state: State, shown: Document, values: Iterable[tuple[str, float]]) -> Binding | None:
    """Return the edit that binds parameters of a document; None if there is no place for one."""
    lines = parameter_lines(values)
    file = state.workspace.configuration_file(shown)
    if file is None:
        return _new_file(state, shown, lines)
    found = state.documents.get(uris.uri(file))
    if found is None:
        return None
    prefix = "tool.kindsl." if file.name == "pyproject.toml" else ""
    return Binding(found, False, _insertion(found.text, prefix, lines))


def _new_file(state: State, shown: Document, lines: list[str]) -> Binding | None:
    """Return a new file beside the document, in the innermost workspace folder if there is one."""
    path = uris.path(shown.uri)
    if path is None:
        return None
    around = [folder for folder in state.workspace.paths() if path.is_relative_to(folder)]
    file = max(around, key=lambda folder: len(folder.parts), default=path.parent) / OWN_FILE
    if file.exists():
        return None  # it is there but says something wrong
    empty = document(uris.uri(file), None, "", shown.encoding)
    return Binding(empty, True, TextEdit(0, 0, "\n".join(("[parameters]", *lines, ""))))


def _insertion(text: str, prefix: str, lines: list[str]) -> TextEdit:
    """Return the edit that adds lines to the table of parameters."""
    table = re.escape(f"{prefix}parameters")
    header = re.search(rf"^[ \t]*\[[ \t]*{table}[ \t]*\][^\n]*(\n|\Z)", text, re.MULTILINE)
    if header is not None:
        start = "" if header[1] else "\n"
        return TextEdit(header.end(), header.end(), start + "\n".join((*lines, "")))
    inline = re.search(r"^[ \t]*parameters[ \t]*=[ \t]*\{", text, re.MULTILINE)
    if inline is not None:
        rest = text[inline.end() :].lstrip()
        comma = "" if rest.startswith("}") else ","
        return TextEdit(inline.end(), inline.end(), f" {', '.join(lines)}{comma}")
    start = "" if not text else "\n" if text.endswith("\n") else "\n\n"
    new = "\n".join((f"[{prefix}parameters]", *lines, ""))
    return TextEdit(len(text), len(text), start + new)
