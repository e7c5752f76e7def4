"""Settings and files: what the client sends, and what it is asked for."""

from typing import TYPE_CHECKING

from lsprotocol import types
from pygls.capabilities import ServerCapabilitiesBuilder

from kindsl.lsp.handlers.table import Handlers
from kindsl.lsp.session.warm_up import warm_up
from kindsl.lsp.session.workspace import CONFIGURATION_FILES
from kindsl.lsp.text import uris
from kindsl.lsp.wire.client import Client, asked

if TYPE_CHECKING:
    from kindsl.lsp.server import KindslLanguageServer


handlers = Handlers()

_SECTION = "kindsl"
_WATCHED = ("**/*.kindsl", *(f"**/{name}" for name in CONFIGURATION_FILES))


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


@handlers.server(types.INITIALIZED)
async def initialized(server: "KindslLanguageServer", _: types.InitializedParams) -> None:
    """Load what comes next, ask to be told of changes, then for the settings."""
    warm_up(server.worker)
    registrations = []
    if server.client.can("workspace.did_change_watched_files.dynamic_registration"):
        watchers = [types.FileSystemWatcher(pattern) for pattern in _WATCHED]
        options = types.DidChangeWatchedFilesRegistrationOptions(watchers)
        method = types.WORKSPACE_DID_CHANGE_WATCHED_FILES
        registrations.append(types.Registration("kindsl-files", method, options))
    if server.client.can("workspace.did_change_configuration.dynamic_registration"):
        section = {"section": _SECTION}
        method = types.WORKSPACE_DID_CHANGE_CONFIGURATION
        registrations.append(types.Registration("kindsl-settings", method, section))
    if registrations:
        params = types.RegistrationParams(registrations)
        await asked(server.client_register_capability_async(params))
    await ask_for_settings(server)


@handlers.server(types.WORKSPACE_DID_CHANGE_CONFIGURATION)
async def change_configuration(
    server: "KindslLanguageServer", params: types.DidChangeConfigurationParams
) -> None:
    """Take new settings, or ask for them."""
    if isinstance(params.settings, dict) and any(params.settings.values()):
        server.settings.set_editor_settings(params.settings)
    await ask_for_settings(server)
    refresh(server)


@handlers.server(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
async def change_folders(
    server: "KindslLanguageServer", params: types.DidChangeWorkspaceFoldersParams
) -> None:
    """Open and close folders."""
    server.settings.add_folders(params.event.added)
    server.settings.remove_folders(params.event.removed)
    await ask_for_settings(server)
    refresh(server)


@handlers.server(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
def change_files(server: "KindslLanguageServer", params: types.DidChangeWatchedFilesParams) -> None:
    """See what has changed outside the editor."""
    server.news.set()
    for change in params.changes:
        if change.type == types.FileChangeType.Deleted and not server.documents.is_open(change.uri):
            server.publisher.clear(change.uri)
    if any(uris.basename(change.uri) in CONFIGURATION_FILES for change in params.changes):
        server.settings.forget()
        refresh(server)
    elif server.client.can("workspace.diagnostics.refresh_support"):
        server.workspace_diagnostic_refresh(None)


@handlers.server(types.TEXT_DOCUMENT_DID_SAVE, types.SaveOptions(include_text=False))
def save(server: "KindslLanguageServer", params: types.DidSaveTextDocumentParams) -> None:
    """See a configuration file that was saved here, in case the client watches no files."""
    server.news.set()
    server.previews.saved(params.text_document.uri)
    if uris.basename(params.text_document.uri) in CONFIGURATION_FILES:
        server.settings.forget()
        refresh(server)


async def ask_for_settings(server: "KindslLanguageServer") -> None:
    """Ask for the section `kindsl`, once for all and once a folder; check again if it is new."""
    if server.client.can("workspace.configuration"):
        scopes = [None, *server.settings.folders.values()]
        items = [types.ConfigurationItem(scope_uri=scope, section=_SECTION) for scope in scopes]
        params = types.ConfigurationParams(items)
        answers = await asked(server.workspace_configuration_async(params)) or ()
        given = [(answer, s) for s, answer in zip(scopes, answers, strict=False) if answer]
        news = [server.settings.set_editor_settings(*each) for each in given]
        if any(news):
            refresh(server)
    for problem in server.settings.problems():
        server.window_log_message(types.LogMessageParams(types.MessageType.Warning, problem))


def refresh(server: "KindslLanguageServer") -> None:
    """Check all open documents again and let the client ask again for what it shows."""
    server.news.set()
    server.publisher.refresh()
    for capability, ask in (
        ("workspace.diagnostics.refresh_support", server.workspace_diagnostic_refresh),
        ("workspace.inlay_hint.refresh_support", server.workspace_inlay_hint_refresh),
        ("workspace.code_lens.refresh_support", server.workspace_code_lens_refresh),
        (
            "workspace.semantic_tokens.refresh_support",
            server.workspace_semantic_tokens_refresh,
        ),
    ):
        if server.client.can(capability):
            ask(None)


def _root(params: types.InitializeParams) -> list[types.WorkspaceFolder]:
    """Return the one folder of a client that knows no others."""
    return [types.WorkspaceFolder(params.root_uri, "")] if params.root_uri else []
