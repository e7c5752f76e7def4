"""From a name to other places: definitions, references, the kinematic tree both ways."""

from typing import TYPE_CHECKING

from lsprotocol import types

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.configuration_files import bound_places
from kindsl.frontends.lsp.session.view import View

if TYPE_CHECKING:
    from kindsl.frontends.features.outline import DocumentSymbol

Definitions = list[types.LocationLink] | list[types.Location]

handlers = Handlers()

_HIGHLIGHTS = {
    "text": types.DocumentHighlightKind.Text,
    "read": types.DocumentHighlightKind.Read,
    "write": types.DocumentHighlightKind.Write,
}


@handlers.place(types.TEXT_DOCUMENT_DEFINITION)
def definition(view: View, params: types.DefinitionParams) -> Definitions:
    """Find where a name is given its meaning."""
    return _definitions(view, params.position, "text_document.definition.link_support")


@handlers.place(types.TEXT_DOCUMENT_DECLARATION)
def declaration(view: View, params: types.DeclarationParams) -> Definitions:
    """Find where a name is declared; in this language that is where it is defined."""
    return _definitions(view, params.position, "text_document.declaration.link_support")


@handlers.place(types.TEXT_DOCUMENT_REFERENCES)
def references(view: View, params: types.ReferenceParams) -> list[types.Location]:
    """Find all places of a name."""
    from kindsl.frontends.features.navigation import references, uses

    find = references if params.context.include_declaration else uses
    return [
        view.location(place.start, place.end)
        for place in find(view.analysis, view.offset(params.position))
    ]


@handlers.place(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
def highlight(view: View, params: types.DocumentHighlightParams) -> list[types.DocumentHighlight]:
    """Light up all places of a name."""
    from kindsl.frontends.features.navigation import highlights

    view.follow_cursor(params.position)
    return [
        types.DocumentHighlight(view.range(found.start, found.end), _HIGHLIGHTS[found.kind])
        for found in highlights(view.analysis, view.offset(params.position))
    ]


@handlers.xml(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
def follow(view: View, params: types.DocumentHighlightParams) -> None:
    """Light up in the preview what the cursor is on in a robot in XML, and nothing in the text."""
    from kindsl.frontends.features.xml_things import thing_at

    view.tell_cursor(*thing_at(view.analysis, view.offset(params.position)))


@handlers.place(types.TEXT_DOCUMENT_PREPARE_CALL_HIERARCHY)
def prepare_hierarchy(
    view: View, params: types.CallHierarchyPrepareParams
) -> list[types.CallHierarchyItem]:
    """Find the link whose place in the tree is asked for."""
    from kindsl.frontends.features.navigation import hierarchy_items

    found = hierarchy_items(view.analysis, view.offset(params.position))
    return [_item(view, item) for item in found]


@handlers.document(types.CALL_HIERARCHY_INCOMING_CALLS)
def incoming(
    view: View, params: types.CallHierarchyIncomingCallsParams
) -> list[types.CallHierarchyIncomingCall]:
    """Find the bodies that carry a link."""
    from kindsl.frontends.features.navigation import predecessors

    return [
        types.CallHierarchyIncomingCall(_item(view, call.item), [view.range(*call.place)])
        for call in predecessors(view.analysis, params.item.name)
    ]


@handlers.document(types.CALL_HIERARCHY_OUTGOING_CALLS)
def outgoing(
    view: View, params: types.CallHierarchyOutgoingCallsParams
) -> list[types.CallHierarchyOutgoingCall]:
    """Find the links that a body carries."""
    from kindsl.frontends.features.navigation import successors

    return [
        types.CallHierarchyOutgoingCall(_item(view, call.item), [view.range(*call.place)])
        for call in successors(view.analysis, params.item.name)
    ]


def _definitions(view: View, position: types.Position, capability: str) -> Definitions:
    from kindsl.frontends.features.navigation import bound_parameter, definitions

    offset = view.offset(position)
    links = [
        types.LocationLink(
            target_uri=view.document.uri,
            target_range=view.range(place.start, place.end),
            target_selection_range=view.range(place.name_start, place.name_end),
        )
        for place in definitions(view.analysis, offset)
    ]
    parameter = bound_parameter(view.analysis, offset)
    for bound in bound_places(view, parameter) if parameter is not None else ():
        span = bound.document.range(bound.start, bound.end)
        links.append(types.LocationLink(bound.document.uri, span, span))
    if view.client.can(capability):
        return links
    return [types.Location(link.target_uri, link.target_selection_range) for link in links]


def _item(view: View, item: "DocumentSymbol") -> types.CallHierarchyItem:
    return types.CallHierarchyItem(
        name=item.name,
        kind=types.SymbolKind.Class,
        uri=view.document.uri,
        range=view.range(item.start, item.end),
        selection_range=view.range(item.name_start, item.name_end),
        detail=item.detail,
    )
