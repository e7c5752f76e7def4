"""From `initialize` to `exit`."""

from typing import TYPE_CHECKING

from lsprotocol import types
from pygls.capabilities import ServerCapabilitiesBuilder

from kindsl.lsp.client import Client
from kindsl.lsp.handlers import Handlers

if TYPE_CHECKING:
    from kindsl.lsp.server import KindslLanguageServer

handlers = Handlers()


@handlers.server(types.INITIALIZE)
def initialize(server: "KindslLanguageServer", params: types.InitializeParams) -> None:
    """Learn who is at the other end."""
    server.client = Client(params.capabilities, params.initialization_options)
    server.documents.encoding = ServerCapabilitiesBuilder.choose_position_encoding(
        params.capabilities
    )
    server.on_parent_known(params.process_id)
