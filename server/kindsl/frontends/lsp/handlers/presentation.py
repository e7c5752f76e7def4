"""Text beside the document: hovers, hints in and above the lines, help while typing."""

from typing import TYPE_CHECKING

from lsprotocol import types

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.companions import TransformsView
from kindsl.frontends.lsp.session.view import Sight, View

if TYPE_CHECKING:
    from kindsl.frontends.features.code_lenses import CodeLens
    from kindsl.frontends.features.inlay_hints import InlayHint
    from kindsl.frontends.features.wording import Hover

handlers = Handlers()

_SIGNATURES = types.SignatureHelpOptions(
    trigger_characters=["(", ","], retrigger_characters=[",", " "]
)
_SHOW_REFERENCES = "kindsl.showReferences"


@handlers.place(types.TEXT_DOCUMENT_HOVER)
def hover(view: View, params: types.HoverParams) -> types.Hover | None:
    """Tell what a word means."""
    from kindsl.frontends.features.hover.hover import hover

    return _hover_message(view, hover(view.analysis, view.offset(params.position)))


@handlers.transforms(types.TEXT_DOCUMENT_HOVER)
def hover_transforms(view: TransformsView, params: types.HoverParams) -> types.Hover | None:
    """Tell what a pair of frames, or a frame, is in a transforms document."""
    from kindsl.frontends.features.transforms import transforms_hover

    offset = view.offset(params.position)
    return _hover_message(view, transforms_hover(view.document.text, offset, view.model))


@handlers.xml(types.TEXT_DOCUMENT_HOVER)
def hover_xml(view: View, params: types.HoverParams) -> types.Hover | None:
    """Tell what a link or joint of a robot in XML weighs, and how it moves."""
    from kindsl.frontends.features.xml_things import xml_hover

    return _hover_message(view, xml_hover(view.analysis, view.offset(params.position)))


def _hover_message(view: Sight, found: "Hover | None") -> types.Hover | None:
    if found is None:
        return None
    content = view.markup(found.markdown, "text_document.hover.content_format")
    return types.Hover(content, view.range(found.start, found.end))


@handlers.place(types.TEXT_DOCUMENT_SIGNATURE_HELP, _SIGNATURES)
def signature_help(view: View, params: types.SignatureHelpParams) -> types.SignatureHelp | None:
    """Tell what the component that is being typed means."""
    from kindsl.frontends.features.signature_help import signature_help

    found = signature_help(view.analysis, view.offset(params.position))
    if found is None:
        return None
    components = [
        types.ParameterInformation((component.start, component.end), component.documentation)
        for component in found.parameters
    ]
    signature = types.SignatureInformation(
        found.label, found.documentation, components, found.active
    )
    return types.SignatureHelp([signature], 0, found.active)


@handlers.document(types.TEXT_DOCUMENT_INLAY_HINT, types.InlayHintOptions())
def inlay_hints(view: View, params: types.InlayHintParams) -> list[types.InlayHint]:
    """Show values, degrees and principal moments behind what is written."""
    from kindsl.frontends.features.inlay_hints import DEFAULT_HINTS, inlay_hints

    wanted = view.editor_settings.inlay_hints
    if not wanted.get("enabled", True):
        return []
    known = {name: on for name, on in wanted.items() if name in DEFAULT_HINTS._fields}
    options = DEFAULT_HINTS._replace(**known)
    found = inlay_hints(view.analysis, *view.span(params.range), options)
    return [_hint(view, each) for each in found]


@handlers.document(types.TEXT_DOCUMENT_CODE_LENS, types.CodeLensOptions())
def code_lenses(view: View, _: types.CodeLensParams) -> list[types.CodeLens]:
    """Show the preview, what a link carries and how often it is used, above the blocks."""
    from kindsl.frontends.features.code_lenses import code_lenses

    return [
        types.CodeLens(view.range(lens.start, lens.end), _command(view, lens))
        for lens in code_lenses(view.analysis)
    ]


def _hint(view: View, hint: "InlayHint") -> types.InlayHint:
    return types.InlayHint(
        position=view.document.position(hint.offset),
        label=hint.text,
        tooltip=hint.tooltip or None,
        padding_left=True,
    )


def _command(view: View, lens: "CodeLens") -> types.Command:
    """Return the action of a lens; none where the client would have to do it and cannot."""
    uri = view.document.uri
    if lens.kind == "preview":
        return types.Command(lens.title, "kindsl.preview", arguments=[uri])
    if lens.kind == "references" and lens.places and view.client.announces(_SHOW_REFERENCES):
        places = [view.location(place.start, place.end) for place in lens.places]
        position = view.document.position(lens.start)
        return types.Command(lens.title, _SHOW_REFERENCES, arguments=[uri, position, places])
    return types.Command(lens.title, "")
