"""Edits as the client takes them."""

from collections.abc import Iterable, Sequence

from lsprotocol import types

from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.client import Client
from kindsl.language.text.edits import TextEdit

_ANEW = types.CreateFileOptions(ignore_if_exists=True)


def text_edits(document: Document, edits: Iterable[TextEdit]) -> list[types.TextEdit]:
    """Return edits with the client's ranges."""
    return [types.TextEdit(document.range(e.start, e.end), e.text) for e in edits]


def workspace_edit(
    client: Client,
    edits: Sequence[tuple[Document, list[types.TextEdit]]],
    new: Sequence[Document] = (),
) -> types.WorkspaceEdit:
    """Return edits of documents, tied to their versions if the client can check them.

    Those among them that are new are to be made first; see `makes_files`.
    """
    merged: dict[str, tuple[Document, list[types.TextEdit]]] = {}
    for document, each in edits:
        merged.setdefault(document.uri, (document, []))[1].extend(each)
    if not client.can("workspace.workspace_edit.document_changes"):
        return types.WorkspaceEdit(changes={uri: each for uri, (_, each) in merged.items()})
    return types.WorkspaceEdit(
        document_changes=[
            *(types.CreateFile(document.uri, options=_ANEW) for document in new),
            *(
                types.TextDocumentEdit(
                    types.OptionalVersionedTextDocumentIdentifier(document.uri, document.version),
                    each,
                )
                for document, each in merged.values()
            ),
        ]
    )


def makes_files(client: Client) -> bool:
    """Return whether the client makes files that an edit asks for.

    One that knows plain changes only opens what they name, also what is not there yet.
    """
    if not client.can("workspace.workspace_edit.document_changes"):
        return True
    operations = client.values("workspace.workspace_edit.resource_operations")
    return types.ResourceOperationKind.Create in operations
