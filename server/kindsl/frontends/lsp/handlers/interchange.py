"""Documents out of other formats and into them, whole or as they are pasted, by commands."""

from pathlib import PurePath
from typing import cast

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from kindsl.frontends.lsp.handlers.commands import view_of
from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.wire.edits import text_edits
from kindsl.frontends.lsp.wire.protocol import RequestFailed
from kindsl.language.text.printable import printable

handlers = Handlers()


@handlers.command("kindsl.exportUrdf")
async def export_urdf(session: Session, uri: object = None, *_: object) -> str:
    """Return a document as URDF; what that says beyond the document is told to the user."""
    view = await view_of(session, uri)
    text, remarks = await session.worker.run(lambda: _urdf(view))
    if remarks:
        message = f"URDF: {'; '.join(remarks)}"
        session.editor.window_show_message(types.ShowMessageParams(types.MessageType.Info, message))
    return text


@handlers.command("kindsl.importRobot")
async def import_robot(
    session: Session, name: object = None, text: object = None, *_: object
) -> dict[str, object]:
    """Return the document of a robot in another format, and remarks on what it cannot keep.

    The arguments are a file's name, whose suffix tells the format, and its text.
    """
    if not isinstance(name, str) or not isinstance(text, str):
        raise JsonRpcInvalidParams("the arguments must be a file's name and its text")
    document, remarks = await session.worker.run(lambda: _document(PurePath(name), text))
    return {"text": document, "remarks": [printable(remark) for remark in remarks]}


@handlers.command("kindsl.paste")
async def paste(
    session: Session, uri: object = None, at: object = None, text: object = None, *_: object
) -> list[dict[str, object]]:
    """Return how a text may be pasted: titles, edits, and whether each is the only way.

    The arguments are the document's address, the range that is replaced, and the text. The list is
    empty for a text that is pasted as it is.
    """
    place = _range(session, at)
    if place is None or not isinstance(text, str):
        raise JsonRpcInvalidParams("the arguments must be an address, a range and a text")
    view = await view_of(session, uri)
    return await session.worker.run(lambda: _ways(view, place, text))


def _urdf(view: View) -> tuple[str, tuple[str, ...]]:
    from kindsl.robots.interchange.format import WritingChoices
    from kindsl.robots.interchange.urdf.writing import written_urdf
    from kindsl.robots.mechanism.total_mass import fixed_base_mass

    analysis = view.analysis
    try:
        skeleton = analysis.skeleton()
    except ValueError as error:
        raise RequestFailed(str(error)) from None
    mass = fixed_base_mass(analysis.model, analysis.context.values)
    choices = WritingChoices(joints=analysis.settings.joints, fixed_base_mass=mass)
    written = written_urdf(analysis.model.name or "robot", skeleton, choices)
    return written.text, written.remarks


def _document(name: PurePath, text: str) -> tuple[str, tuple[str, ...]]:
    from kindsl.language.text.phrases import alternatives
    from kindsl.robots.interchange.format import (
        AS_WRITTEN,
        FormatError,
        joints_dropped,
        suffix_unknown,
    )
    from kindsl.robots.interchange.kindsl_writing import written_kindsl
    from kindsl.robots.interchange.registry import all_formats, format_of_suffix

    format = format_of_suffix(name.suffix)
    if format is None or format.parse is None:
        known = [f.suffixes[0] for f in all_formats() if f.parse is not None]
        if format is None:
            raise RequestFailed(suffix_unknown(name.suffix, known))
        others = alternatives(known)
        raise RequestFailed(f"{format.title} cannot be read from one text, as {others} can")
    try:
        written = written_kindsl(format.parse(text, name.stem, AS_WRITTEN))
    except FormatError as error:
        raise RequestFailed(printable(str(error))) from None
    lost = (joints_dropped(written.joints),) if written.joints else ()
    return written.text, (*written.remarks, *lost)


def _range(session: Session, at: object) -> types.Range | None:
    """Return a range in the protocol's form as a range, None for anything else."""
    try:
        return session.editor.protocol.structured(cast("dict[str, object]", at), types.Range)
    except (TypeError, KeyError, ValueError, ExceptionGroup):
        return None


def _ways(view: View, at: types.Range, text: str) -> list[dict[str, object]]:
    from kindsl.frontends.features.pasting import pastings

    return [
        {
            "title": way.title,
            "edits": text_edits(view.document, way.edits),
            "isCertain": way.is_certain,
        }
        for way in pastings(view.analysis, *view.span(at), text)
    ]
