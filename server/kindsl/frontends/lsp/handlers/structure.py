"""The shape of a document: outline, folds, growing selections, links."""

from collections.abc import AsyncIterator
from typing import TYPE_CHECKING, Any

from lsprotocol import types

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.configuration_files import configuration_links
from kindsl.frontends.lsp.session.progress import Progress
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.text.document import Document
from kindsl.language.text.facts import Fact

if TYPE_CHECKING:
    from kindsl.frontends.features.outline import DocumentSymbol, WorkspaceSymbol

KINEMATIC_TREE = "kindsl/kinematicTree"

handlers = Handlers()

_KINDS = {
    "robot": types.SymbolKind.Namespace,
    "base": types.SymbolKind.Class,
    "link": types.SymbolKind.Class,
    "joint": types.SymbolKind.Method,
    "frame": types.SymbolKind.Property,
}
_MOST_SYMBOLS = 1000
# Of a text until it changes.
_SYMBOLS: "Fact[tuple[WorkspaceSymbol, ...]]" = Fact("symbols")


@handlers.document(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
def outline(
    view: View, _: types.DocumentSymbolParams
) -> list[types.DocumentSymbol] | list[types.SymbolInformation]:
    """Show what is written in what, or a list to a client that cannot nest."""
    from kindsl.frontends.features.outline import document_symbols, flat_symbols

    if view.client.can("text_document.document_symbol.hierarchical_document_symbol_support"):
        return [_symbol(view, symbol) for symbol in document_symbols(view.analysis)]
    return [
        types.SymbolInformation(
            view.location(symbol.start, symbol.end), symbol.name, _KINDS[symbol.kind]
        )
        for symbol in flat_symbols(view.analysis)
    ]


@handlers.session(KINEMATIC_TREE)
def kinematic_tree(session: Session, params: Any) -> Any:
    """Show the kinematic tree: a link below the link that carries it, wherever it is written.

    Parameters and result are those of `textDocument/documentSymbol`; an entry need not lie inside
    the one above it.
    """
    return session.ask(_tree, str(params["textDocument"]["uri"]), params)


def _tree(view: View, _: Any) -> list[types.DocumentSymbol]:
    from kindsl.frontends.features.outline import kinematic_outline

    return [_symbol(view, symbol) for symbol in kinematic_outline(view.analysis)]


@handlers.session(types.WORKSPACE_SYMBOL, types.WorkspaceSymbolOptions())
async def workspace_symbols(
    session: Session, params: types.WorkspaceSymbolParams
) -> list[dict[str, Any]]:
    """Find named things in all robots of the workspace."""
    from kindsl.frontends.features.outline import is_match

    found: list[dict[str, Any]] = []
    progress = Progress(session, "Reading robots", params.work_done_token)
    async for robot, symbols in _all_symbols(session, await session.open_and_closed(), progress):
        matching = (each for each in symbols if is_match(params.query, each.name))
        found += [_found_in(robot, symbol) for symbol in matching]
        if len(found) >= _MOST_SYMBOLS:
            break
    return found[:_MOST_SYMBOLS]


async def _all_symbols(
    session: Session, robots: list[str], progress: Progress
) -> "AsyncIterator[tuple[Document, tuple[WorkspaceSymbol, ...]]]":
    """Yield each robot and its symbols; of a file that is not open only its names are read."""

    async def read(uri: str) -> Document | None:
        robot = session.documents.get(uri)
        if robot is None or not robot.is_robot:
            return None
        if robot.facts.get(_SYMBOLS) is None:
            robot.facts.keep(_SYMBOLS, await _symbols(session, robot))
        return robot

    async with progress:
        async for robot in progress.over(robots, read):
            if robot is not None:
                yield robot, robot.facts.get(_SYMBOLS) or ()


async def _symbols(session: Session, robot: Document) -> "tuple[WorkspaceSymbol, ...]":
    from kindsl.frontends.features.names_in_text import symbols_in_text
    from kindsl.frontends.features.outline import workspace_symbols

    if robot.version is None:
        return tuple(symbols_in_text(robot.text))
    return tuple(workspace_symbols(await session.analyses.of(robot)))


def _found_in(robot: Document, symbol: "WorkspaceSymbol") -> dict[str, Any]:
    return {
        "name": symbol.name,
        "kind": _KINDS[symbol.kind].value,
        "location": {"uri": robot.uri, "range": robot.wire_range(symbol.start, symbol.end)},
        "containerName": symbol.container,
    }


@handlers.document(types.TEXT_DOCUMENT_FOLDING_RANGE)
def folding(view: View, _: types.FoldingRangeParams) -> list[types.FoldingRange]:
    """Show what can be folded away."""
    from kindsl.frontends.features.ranges import folds

    whole_lines = view.client.can("text_document.folding_range.line_folding_only")
    found = []
    for fold in folds(view.analysis):
        start, end = view.document.position(fold.start), view.document.position(fold.end)
        is_comment = fold.kind == "comment"
        last = end.line - (whole_lines and not is_comment)
        left, right = (None, None) if whole_lines else (start.character, end.character)
        kind = types.FoldingRangeKind.Comment if is_comment else None
        if last > start.line:
            found.append(types.FoldingRange(start.line, last, left, right, kind))
    return found


@handlers.place(types.TEXT_DOCUMENT_SELECTION_RANGE)
def selection(view: View, params: types.SelectionRangeParams) -> list[types.SelectionRange]:
    """Grow selections around places."""
    return [_selection(view, position) for position in params.positions]


@handlers.place(types.TEXT_DOCUMENT_LINKED_EDITING_RANGE)
def linked_editing(
    view: View, params: types.LinkedEditingRangeParams
) -> types.LinkedEditingRanges | None:
    """Find the places that change together while one is typed in."""
    from kindsl.frontends.features.navigation import linked_ranges

    found = linked_ranges(view.analysis, view.offset(params.position))
    return types.LinkedEditingRanges([view.range(*span) for span in found]) if found else None


@handlers.session(types.TEXT_DOCUMENT_DOCUMENT_LINK, types.DocumentLinkOptions())
def links(session: Session, params: types.DocumentLinkParams) -> list[types.DocumentLink]:
    """Find documents that a configuration file names."""
    document = session.documents.get(params.text_document.uri)
    if document is None or not document.is_toml:
        return []
    return list(configuration_links(document))


def _symbol(view: View, symbol: "DocumentSymbol") -> types.DocumentSymbol:
    return types.DocumentSymbol(
        name=symbol.name,
        kind=_KINDS[symbol.kind],
        range=view.range(symbol.start, symbol.end),
        selection_range=view.range(symbol.name_start, symbol.name_end),
        detail=symbol.detail,
        children=[_symbol(view, child) for child in symbol.children],
    )


def _selection(view: View, position: types.Position) -> types.SelectionRange:
    from kindsl.frontends.features.ranges import selection_ranges

    outer: types.SelectionRange | None = None
    for span in reversed(selection_ranges(view.analysis, view.offset(position))):
        outer = types.SelectionRange(view.range(*span), outer)
    return outer or types.SelectionRange(types.Range(position, position))
