"""Renaming, in the document, its transforms document and the project's configuration."""

from lsprotocol import types

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.configuration_files import bound_places, rename_binding
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.edits import text_edits, workspace_edit
from kindsl.frontends.lsp.wire.protocol import RequestFailed
from kindsl.judgement.config.file_names import TRANSFORMS_SUFFIX

handlers = Handlers()


@handlers.place(types.TEXT_DOCUMENT_PREPARE_RENAME)
def prepare(view: View, params: types.PrepareRenameParams) -> types.Range | None:
    """Find the name that would be renamed; None where there is none."""
    from kindsl.frontends.features.rename import rename_range

    found = rename_range(view.analysis, view.offset(params.position))
    return None if found is None else view.range(*found)


@handlers.place(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))
def rename(view: View, params: types.RenameParams) -> types.WorkspaceEdit | None:
    """Give something another name everywhere."""
    from kindsl.frontends.features.manipulation.gesture import Refusal
    from kindsl.frontends.features.rename import rename

    found = rename(view.analysis, view.offset(params.position), params.new_name)
    if found is None:
        return None
    if isinstance(found, Refusal):
        raise RequestFailed(found.reason)
    edits = [(view.document, text_edits(view.document, found.edits))]
    if found.bound_parameter is not None:
        for place in bound_places(view, found.bound_parameter):
            bindings = rename_binding(place, params.new_name)
            edits.append((place.document, text_edits(place.document, bindings)))
    edits += _transforms_edits(view, params)
    return workspace_edit(view.client, edits)


def _transforms_edits(
    view: View, params: types.RenameParams
) -> list[tuple[Document, list[types.TextEdit]]]:
    from kindsl.frontends.features.transforms import renamed_transforms

    path = uris.path(view.document.uri)
    beside = path.with_suffix(TRANSFORMS_SUFFIX) if path is not None else None
    if beside is None or not beside.is_file():
        return []
    document = view.state.documents.get(uris.uri(beside))
    if document is None:
        return []
    offset = view.offset(params.position)
    edits = renamed_transforms(view.analysis, offset, params.new_name, document.text)
    return [(document, text_edits(document, edits))] if edits else []
