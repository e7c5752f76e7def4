"""The beginning: who is at the other end, and what it wants."""

from typing import TYPE_CHECKING

from lsprotocol import types
from pygls.capabilities import ServerCapabilitiesBuilder

from kindsl.lsp.handlers.table import Handlers
from kindsl.lsp.wire.client import Client

if TYPE_CHECKING:
    from kindsl.lsp.server import KindslLanguageServer

handlers = Handlers()


@handlers.server(types.INITIALIZE)
def initialize(server: "KindslLanguageServer", params: types.InitializeParams) -> None:
    """Learn who is at the other end."""
    capabilities = params.capabilities
    server.client = Client(capabilities, params.initialization_options)
    server.documents.encoding = ServerCapabilitiesBuilder.choose_position_encoding(capabilities)
    folders = params.workspace_folders or _root(params)
    server.settings.add_folders(folders)
    server.settings.set_editor_settings(params.initialization_options)
    server.on_parent_known(params.process_id)


def _root(params: types.InitializeParams) -> list[types.WorkspaceFolder]:
    """Return the one folder of a client that knows no others."""
    return [types.WorkspaceFolder(params.root_uri, "")] if params.root_uri else []
