"""The start of a session, its settings and files: what the client says, and what it is asked."""

from collections.abc import Iterable, Iterator

from lsprotocol import types
from pygls.capabilities import ServerCapabilitiesBuilder

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.warm_up import warm_up
from kindsl.frontends.lsp.session.worker import start_task
from kindsl.frontends.lsp.session.workspace import CONFIGURATION_FILES
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.wire.client import Client, asked

handlers = Handlers()

_SECTION = "kindsl"
_TRUST = "kindsl/isTrusted"
_WATCHED = ("**/*.kindsl", *(f"**/{name}" for name in CONFIGURATION_FILES))


@handlers.session(types.INITIALIZE)
def initialize(session: Session, params: types.InitializeParams) -> None:
    """Learn who is at the other end."""
    capabilities = params.capabilities
    session.client = Client(capabilities, params.initialization_options)
    session.documents.encoding = ServerCapabilitiesBuilder.choose_position_encoding(capabilities)
    # A client that does not know workspace folders has one.
    root = [types.WorkspaceFolder(params.root_uri, "")] if params.root_uri else []
    session.workspace.add_folders(params.workspace_folders or root)
    options = params.initialization_options
    session.workspace.is_trusted = not isinstance(options, dict) or options.get(_TRUST) is not False
    session.workspace.set_editor_settings(params.initialization_options)
    session.on_parent_known(params.process_id)


@handlers.session(types.INITIALIZED)
async def initialized(session: Session, _: types.InitializedParams) -> None:
    """Load what comes next, ask to be told of changes, then for the settings."""
    warm_up(session.worker)
    registrations = list(_registrations(session.client))
    if registrations:
        params = types.RegistrationParams(registrations)
        await asked(session.editor.client_register_capability_async(params))
    if session.surroundings.has_files:
        start_task(session.closed.watch(lambda: refresh(session)))
    await _ask_for_settings(session)


@handlers.session(types.WORKSPACE_DID_CHANGE_CONFIGURATION)
async def change_configuration(
    session: Session, params: types.DidChangeConfigurationParams
) -> None:
    """Take new settings, or ask for them."""
    if isinstance(params.settings, dict) and any(params.settings.values()):
        session.workspace.set_editor_settings(params.settings)
    await _ask_for_settings(session)
    refresh(session)


@handlers.session(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
async def change_folders(session: Session, params: types.DidChangeWorkspaceFoldersParams) -> None:
    """Open and close folders."""
    session.workspace.add_folders(params.event.added)
    session.workspace.remove_folders(params.event.removed)
    await _ask_for_settings(session)
    refresh(session)


@handlers.session(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
def change_files(session: Session, params: types.DidChangeWatchedFilesParams) -> None:
    """See what has changed outside the editor."""
    session.news.set()
    for change in params.changes:
        is_gone = change.type == types.FileChangeType.Deleted
        if is_gone and not session.documents.is_open(change.uri):
            session.closed.forget(change.uri)
            session.publisher.publish(change.uri, [])
    changed = [change.uri for change in params.changes if _is_configuration(change.uri)]
    if changed:
        session.workspace.forget()
        refresh(session, changed)
    elif session.client.is_told_to_pull:
        session.editor.workspace_diagnostic_refresh(None)


@handlers.session(types.TEXT_DOCUMENT_DID_SAVE, types.SaveOptions(include_text=False))
def save(session: Session, params: types.DidSaveTextDocumentParams) -> None:
    """See a configuration file that was saved here, in case the client watches no files."""
    session.news.set()
    session.previews.saved(params.text_document.uri)
    if _is_configuration(params.text_document.uri):
        session.workspace.forget()
        refresh(session)


async def _ask_for_settings(session: Session) -> None:
    if session.client.can("workspace.configuration"):
        scopes = [None, *session.workspace.folders.values()]
        items = [types.ConfigurationItem(scope_uri=scope, section=_SECTION) for scope in scopes]
        params = types.ConfigurationParams(items)
        answers = await asked(session.editor.workspace_configuration_async(params)) or ()
        given = [(answer, s) for s, answer in zip(scopes, answers, strict=False) if answer]
        news = [session.workspace.set_editor_settings(*each) for each in given]
        if any(news):
            refresh(session)
    for problem in session.workspace.problems():
        message = types.LogMessageParams(types.MessageType.Warning, problem)
        session.editor.window_log_message(message)


def refresh(session: Session, changed: Iterable[str] = ()) -> None:
    """Check all open documents again and let the client ask again for what it shows."""
    session.news.set()
    session.publisher.refresh()
    start_task(session.closed.look(changed))
    session.previews.refresh()
    editor = session.editor
    for shown, ask in (
        ("diagnostics", editor.workspace_diagnostic_refresh),
        ("inlay_hint", editor.workspace_inlay_hint_refresh),
        ("code_lens", editor.workspace_code_lens_refresh),
        ("semantic_tokens", editor.workspace_semantic_tokens_refresh),
    ):
        if session.client.can(f"workspace.{shown}.refresh_support"):
            ask(None)


def _is_configuration(uri: str) -> bool:
    return uris.basename(uri) in CONFIGURATION_FILES


def _registrations(client: Client) -> Iterator[types.Registration]:
    """Yield the notifications to ask a client for, as far as it can be asked."""
    if client.can("workspace.did_change_watched_files.dynamic_registration"):
        watchers = [types.FileSystemWatcher(pattern) for pattern in _WATCHED]
        options = types.DidChangeWatchedFilesRegistrationOptions(watchers)
        method = types.WORKSPACE_DID_CHANGE_WATCHED_FILES
        yield types.Registration("kindsl-files", method, options)
    if client.can("workspace.did_change_configuration.dynamic_registration"):
        section = {"section": _SECTION}
        method = types.WORKSPACE_DID_CHANGE_CONFIGURATION
        yield types.Registration("kindsl-settings", method, section)
