"""Every feature over real stdio, as VS Code, Neovim and Emacs ask for it.

What the answers mean is tested beside the features; here it is that they arrive, in the client's
own terms, without a warning about the specification.
"""

import sys
from pathlib import Path
from typing import Any

import pytest
import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities
from tests.support import robots

from kindsl.frontends.lsp.text import uris

HEAD = "Robot Arm {\n"
ARM = robots.ARM.replace(HEAD, HEAD + "// See https://example.org/arm.\n").replace("2.0", "m", 1)
ARM = ARM.replace("(0.5, 0.0", "(reach, 0.0")
BROKEN = ARM.replace("lower via elbow", "lowest via elbow")
CONFIGURATION = """\
[parameters]
m = 2.5
reach = 0.3
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("robots")
    (folder / "arm.kindsl").write_text(ARM)
    (folder / "closed.kindsl").write_text(BROKEN)
    (folder / "kindsl.toml").write_text(CONFIGURATION)
    return folder


@pytest_lsp.fixture(
    scope="module",
    params=["visual_studio_code", "neovim", "emacs"],
    config=ClientServerConfig(
        server_command=[sys.executable, "-m", "kindsl.frontends.cli.language_server"]
    ),
)
async def client(request: pytest.FixtureRequest, lsp_client: LanguageClient, folder: Path) -> Any:
    workspace = [types.WorkspaceFolder(uri=uris.uri(folder), name="robots")]
    await lsp_client.initialize_session(
        types.InitializeParams(
            capabilities=client_capabilities(request.param), workspace_folders=workspace
        )
    )
    open_document(lsp_client, arm(folder), ARM)
    await lsp_client.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    yield
    await lsp_client.shutdown_session()


async def test_diagnostics_are_published_and_cleared(client: LanguageClient, folder: Path) -> None:
    uri = uris.uri(folder / "other.kindsl")
    open_document(client, uri, BROKEN)
    await client.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    assert [d.code for d in client.diagnostics[uri] if d.severity == 1] == ["KD105"]
    change(client, uri, 2, span(BROKEN, "lowest"), "lower")
    await client.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    assert [d for d in client.diagnostics[uri] if d.severity == 1] == []
    client.text_document_did_close(
        types.DidCloseTextDocumentParams(types.TextDocumentIdentifier(uri))
    )
    await client.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    assert not client.diagnostics[uri]


async def test_diagnostics_can_be_asked_for(client: LanguageClient, folder: Path) -> None:
    document = types.TextDocumentIdentifier(uris.uri(folder / "closed.kindsl"))
    report = await client.text_document_diagnostic_async(types.DocumentDiagnosticParams(document))
    assert isinstance(report, types.RelatedFullDocumentDiagnosticReport)
    assert "KD105" in [item.code for item in report.items]
    again = await client.text_document_diagnostic_async(
        types.DocumentDiagnosticParams(document, previous_result_id=report.result_id)
    )
    assert isinstance(again, types.RelatedUnchangedDocumentDiagnosticReport)


async def test_the_workspace_is_checked_when_asked(client: LanguageClient, folder: Path) -> None:
    report = await client.workspace_diagnostic_async(types.WorkspaceDiagnosticParams([]))
    found = {Path(item.uri).name: item for item in report.items}
    assert set(found) == {"arm.kindsl", "closed.kindsl"}
    known = [types.PreviousResultId(item.uri, item.result_id or "") for item in report.items]
    again = await client.workspace_diagnostic_async(types.WorkspaceDiagnosticParams(known))
    assert {item.kind for item in again.items} == {"unchanged"}


async def test_hover(client: LanguageClient, folder: Path) -> None:
    hover = await client.text_document_hover_async(at(types.HoverParams, folder, "upper {"))
    assert hover is not None
    assert isinstance(hover.contents, types.MarkupContent)
    assert "upper" in hover.contents.value
    assert hover.range == span(ARM, "upper {", 5)


async def test_completion(client: LanguageClient, folder: Path) -> None:
    params = at(types.CompletionParams, folder, "children {}", 10)
    answer = await client.text_document_completion_async(params)
    items = answer.items if isinstance(answer, types.CompletionList) else answer
    assert items
    resolved = await client.completion_item_resolve_async(items[0])
    assert resolved.label == items[0].label


async def test_definition_and_declaration(client: LanguageClient, folder: Path) -> None:
    for ask, params in (
        (client.text_document_definition_async, types.DefinitionParams),
        (client.text_document_declaration_async, types.DeclarationParams),
    ):
        found = await ask(at(params, folder, "upper via"))
        assert isinstance(found, list)
        place = found[0]
        target = (
            place.target_selection_range if isinstance(place, types.LocationLink) else place.range
        )
        assert target == span(ARM, "upper {", 5)


async def test_a_bound_parameter_leads_to_its_value(client: LanguageClient, folder: Path) -> None:
    found = await client.text_document_definition_async(
        at(types.DefinitionParams, folder, "reach,")
    )
    assert isinstance(found, list)
    targets = {p.target_uri if isinstance(p, types.LocationLink) else p.uri for p in found}
    assert uris.uri(folder / "kindsl.toml") in targets


async def test_references_and_highlights(client: LanguageClient, folder: Path) -> None:
    params = at(types.ReferenceParams, folder, "upper via", context=types.ReferenceContext(True))
    references = await client.text_document_references_async(params)
    assert [r.range for r in references or ()] == [
        span(ARM, "upper via", 5),
        span(ARM, "upper {", 5),
    ]
    highlights = await client.text_document_document_highlight_async(
        at(types.DocumentHighlightParams, folder, "upper via")
    )
    assert len(highlights or ()) == 2


async def test_rename_follows_the_configuration(client: LanguageClient, folder: Path) -> None:
    prepared = await client.text_document_prepare_rename_async(
        at(types.PrepareRenameParams, folder, "reach,")
    )
    assert prepared == span(ARM, "reach,", 5)
    edit = await client.text_document_rename_async(
        at(types.RenameParams, folder, "reach,", new_name="length")
    )
    assert edit is not None
    edits = edits_by_name(edit)
    assert [e.new_text for e in edits["kindsl.toml"]] == ["length"]
    assert edits["kindsl.toml"][0].range == span(CONFIGURATION, "reach")
    assert len(edits["arm.kindsl"]) == 2


async def test_rename_follows_the_transforms_document(client: LanguageClient, folder: Path) -> None:
    transforms = "Robot Arm\nFrames { fr_upper }\nTransforms { base=fr_upper, target=fr_upper }\n"
    (folder / "arm.dtdsl").write_text(transforms)
    edit = await client.text_document_rename_async(
        at(types.RenameParams, folder, "upper via", new_name="thigh")
    )
    assert edit is not None
    assert [e.new_text for e in edits_by_name(edit)["arm.dtdsl"]] == ["fr_thigh"] * 3
    (folder / "arm.dtdsl").unlink()


async def test_a_rename_that_clashes_is_refused(client: LanguageClient, folder: Path) -> None:
    with pytest.raises(Exception, match="exists already"):
        await client.text_document_rename_async(
            at(types.RenameParams, folder, "upper via", new_name="lower")
        )


async def test_outline(client: LanguageClient, folder: Path) -> None:
    symbols = await client.text_document_document_symbol_async(
        types.DocumentSymbolParams(identifier(folder))
    )
    assert symbols
    names = []
    queue = list(symbols)
    while queue:
        symbol = queue.pop(0)
        names.append(symbol.name)
        queue += getattr(symbol, "children", None) or []
    assert {"base", "upper", "lower", "shoulder", "elbow", "tip"} <= set(names)


async def test_kinematic_tree(client: LanguageClient, folder: Path) -> None:
    place = {"textDocument": {"uri": identifier(folder).uri}}
    (base,) = await client.protocol.send_request_async("kindsl/kinematicTree", place)
    (upper,) = base["children"]
    assert (base["name"], upper["name"]) == ("base", "upper")
    assert {child["name"] for child in upper["children"]} == {"lower", "shoulder"}


async def test_workspace_symbols(client: LanguageClient, folder: Path) -> None:
    found = await client.workspace_symbol_async(types.WorkspaceSymbolParams("elbow"))
    assert {Path(s.location.uri).name for s in found or ()} == {"arm.kindsl", "closed.kindsl"}


async def test_call_hierarchy(client: LanguageClient, folder: Path) -> None:
    items = await client.text_document_prepare_call_hierarchy_async(
        at(types.CallHierarchyPrepareParams, folder, "upper {")
    )
    assert items
    above = await client.call_hierarchy_incoming_calls_async(
        types.CallHierarchyIncomingCallsParams(items[0])
    )
    below = await client.call_hierarchy_outgoing_calls_async(
        types.CallHierarchyOutgoingCallsParams(items[0])
    )
    assert [call.from_.name for call in above or ()] == ["base"]
    assert [call.to.name for call in below or ()] == ["lower"]


async def test_folding(client: LanguageClient, folder: Path) -> None:
    folds = await client.text_document_folding_range_async(
        types.FoldingRangeParams(identifier(folder))
    )
    first = span(ARM, "link upper").start.line
    assert first in [fold.start_line for fold in folds or ()]


async def test_selections_grow(client: LanguageClient, folder: Path) -> None:
    positions = [span(ARM, "upper {").start, types.Position(999, 999)]
    found = await client.text_document_selection_range_async(
        types.SelectionRangeParams(identifier(folder), positions)
    )
    assert found is not None
    assert len(found) == 2
    assert found[0].range == span(ARM, "upper {", 5)
    assert found[0].parent is not None


async def test_linked_editing(client: LanguageClient, folder: Path) -> None:
    found = await client.text_document_linked_editing_range_async(
        at(types.LinkedEditingRangeParams, folder, "upper {")
    )
    assert found is not None
    assert len(found.ranges) == 2


async def test_semantic_tokens(client: LanguageClient, folder: Path) -> None:
    whole = await client.text_document_semantic_tokens_full_async(
        types.SemanticTokensParams(identifier(folder))
    )
    assert whole is not None
    assert len(whole.data) % 5 == 0
    part = await client.text_document_semantic_tokens_range_async(
        types.SemanticTokensRangeParams(identifier(folder), span(ARM, "upper via"))
    )
    assert part is not None
    assert 5 <= len(part.data) < len(whole.data)


async def test_inlay_hints(client: LanguageClient, folder: Path) -> None:
    everything = types.Range(types.Position(0, 0), types.Position(999, 0))
    hints = await client.text_document_inlay_hint_async(
        types.InlayHintParams(identifier(folder), everything)
    )
    assert "90°" in [hint.label for hint in hints or ()]


async def test_code_lenses(client: LanguageClient, folder: Path) -> None:
    lenses = await client.text_document_code_lens_async(types.CodeLensParams(identifier(folder)))
    assert "kindsl.preview" in [lens.command.command for lens in lenses or () if lens.command]


async def test_signature_help(client: LanguageClient, folder: Path) -> None:
    found = await client.text_document_signature_help_async(
        at(types.SignatureHelpParams, folder, "PI/2.0")
    )
    assert found is not None
    assert found.signatures[0].label == "rotation = (rx, ry, rz)"
    assert found.active_parameter == 1


async def test_code_actions(client: LanguageClient, folder: Path) -> None:
    uri = uris.uri(folder / "actions.kindsl")
    open_document(client, uri, BROKEN)
    context = types.CodeActionContext([], only=[types.CodeActionKind.QuickFix])
    actions = await client.text_document_code_action_async(
        types.CodeActionParams(types.TextDocumentIdentifier(uri), span(BROKEN, "lowest"), context)
    )
    assert actions
    assert {action.kind for action in actions if isinstance(action, types.CodeAction)} == {
        "quickfix"
    }
    assert all(action.edit for action in actions if isinstance(action, types.CodeAction))


async def test_formatting(client: LanguageClient, folder: Path) -> None:
    uri = uris.uri(folder / "crooked.kindsl")
    crooked = ARM.replace("    id = 1", "  id=1")
    open_document(client, uri, crooked)
    document, options = types.TextDocumentIdentifier(uri), types.FormattingOptions(4, True)
    edits = await client.text_document_formatting_async(
        types.DocumentFormattingParams(document, options)
    )
    assert edits
    place = span(crooked, "id=1")
    part = await client.text_document_range_formatting_async(
        types.DocumentRangeFormattingParams(document, place, options)
    )
    assert part
    below = types.Position(place.start.line + 1, 0)
    typed = await client.text_document_on_type_formatting_async(
        types.DocumentOnTypeFormattingParams(document, below, "\n", options)
    )
    assert typed


async def test_a_broken_document_is_not_formatted(client: LanguageClient, folder: Path) -> None:
    uri = uris.uri(folder / "half.kindsl")
    open_document(client, uri, "Robot Half {")
    params = types.DocumentFormattingParams(
        types.TextDocumentIdentifier(uri), types.FormattingOptions(4, True)
    )
    before = len(client.messages)
    for _ in range(2):
        assert await client.text_document_formatting_async(params) is None
    assert [m.message.split(":")[0] for m in client.messages[before:]] == ["Not formatted"]


async def test_commands(client: LanguageClient, folder: Path) -> None:
    uri = arm(folder)
    shown = await run(client, "kindsl.preview", uri)
    assert shown["url"].startswith("http://127.0.0.1:")
    computed = await run(client, "kindsl.compute", uri, {"q": [0.1, 0.2]})
    assert computed["robot"] == "Arm"
    assert len(computed["configurations"]) == 1
    assert "<robot" in await run(client, "kindsl.exportUrdf", uri)
    assert await run(client, "kindsl.applyFixAll", uri) is False


async def run(client: LanguageClient, command: str, *arguments: Any) -> Any:
    params = types.ExecuteCommandParams(command, list(arguments))
    return await client.workspace_execute_command_async(params)


def arm(folder: Path) -> str:
    return uris.uri(folder / "arm.kindsl")


def identifier(folder: Path) -> types.TextDocumentIdentifier:
    return types.TextDocumentIdentifier(arm(folder))


def at(params: Any, folder: Path, mark: str, after: int = 0, **more: Any) -> Any:
    """Parameters of a request at the first place of a text in the arm."""
    position = span(ARM, mark).start
    position = types.Position(position.line, position.character + after)
    return params(text_document=identifier(folder), position=position, **more)


def span(text: str, mark: str, length: int | None = None) -> types.Range:
    offset = text.index(mark)
    line = text.count("\n", 0, offset)
    column = offset - text.rfind("\n", 0, offset) - 1
    end = column + (len(mark) if length is None else length)
    return types.Range(types.Position(line, column), types.Position(line, end))


def open_document(client: LanguageClient, uri: str, text: str) -> None:
    item = types.TextDocumentItem(uri, "kinematics-dsl", 1, text)
    client.text_document_did_open(types.DidOpenTextDocumentParams(item))


def change(client: LanguageClient, uri: str, version: int, where: types.Range, text: str) -> None:
    client.text_document_did_change(
        types.DidChangeTextDocumentParams(
            types.VersionedTextDocumentIdentifier(version, uri),
            [types.TextDocumentContentChangePartial(range=where, text=text)],
        )
    )


def edits_by_name(edit: types.WorkspaceEdit) -> dict[str, list[Any]]:
    if edit.changes is not None:
        return {Path(uri).name: list(edits) for uri, edits in edit.changes.items()}
    return {
        Path(change.text_document.uri).name: list(change.edits)
        for change in edit.document_changes or ()
        if isinstance(change, types.TextDocumentEdit)
    }
