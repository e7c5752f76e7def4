"""Changes of files that the editor may not have open, in no language of ours."""

from pathlib import Path
from typing import TYPE_CHECKING

from lsprotocol import types

from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document, document
from kindsl.frontends.lsp.wire.edits import text_edits
from kindsl.language.text.edits import TextEdit

if TYPE_CHECKING:
    from kindsl.frontends.features.actions.action import CodeAction

_MARK = "\ufeff"


def other_file_edits(
    state: State, action: "CodeAction"
) -> tuple[Document, list[types.TextEdit]] | None:
    """Return the edits of an action's other file; None if it is not as it was when it was read."""
    path = Path(action.other_file).absolute()
    try:
        content = path.read_bytes().decode("utf-8")
    except (OSError, UnicodeDecodeError):
        return None
    opened = state.documents.get(uris.uri(path))
    plain = content.removeprefix(_MARK)
    found = opened or document(uris.uri(path), None, plain, state.documents.encoding)
    # Offsets count a byte order mark, which editors take off.
    off = found.text.startswith(_MARK) - content.startswith(_MARK)
    edits = [e._replace(start=e.start + off, end=e.end + off) for e in action.other_edits]
    if any(found.text[edit.start : edit.end] != edit.old for edit in edits):
        return None
    return found, text_edits(found, [TextEdit(e.start, e.end, e.new) for e in edits])
