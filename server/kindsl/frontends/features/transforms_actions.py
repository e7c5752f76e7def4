"""Actions in a transforms document."""

from collections.abc import Iterator

from kindsl.frontends.features.actions.action import CodeAction
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.transforms import (
    frame_names,
    transforms_document,
    undeclared_frames,
    unknown_frames,
)
from kindsl.language.syntax.transforms_text import TransformsDocument, read_transforms
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.nearest import nearest_name

_QUICK = "quickfix"
_REWRITE = "refactor.rewrite"


def transforms_actions(text: str, model: Model | None, start: int, end: int) -> list[CodeAction]:
    """Return what can be done about a stretch of a transforms document.

    Args:
        text: The transforms document.
        model: The robot that it is about, None if that is not known.
        start: Where the stretch begins, code points.
        end: Where it ends.
    """
    document = read_transforms(text)
    if not text.strip():
        return [_whole(text, model)] if model is not None and model.name and model.bodies else []
    found = [*_listings(text, document, start, end)]
    if model is not None:
        found += [*_replacements(text, document, model, start, end)]
        found += [*_all_frames(document, model)]
    return found


def _whole(text: str, model: Model) -> CodeAction:
    edit = TextEdit(0, len(text), transforms_document(model))
    return CodeAction(f"Write the transforms of '{model.name}'", _REWRITE, (edit,))


def _listings(
    text: str, document: TransformsDocument, start: int, end: int
) -> Iterator[CodeAction]:
    """Yield how a frame of a pair becomes one of the list."""
    for wrong in undeclared_frames(document, None):
        if wrong.start <= end and start <= wrong.end:
            name = text[wrong.start : wrong.end]
            edit = _listed(document, [name])
            if edit is not None:
                yield CodeAction(f"List '{name}' under 'Frames'", _QUICK, (edit,))


def _replacements(
    text: str, document: TransformsDocument, model: Model, start: int, end: int
) -> Iterator[CodeAction]:
    """Yield the frame that may be meant by one that the robot has not."""
    for wrong in unknown_frames(document, model):
        name = text[wrong.start : wrong.end]
        near = nearest_name(name, frame_names(model))
        if near is not None and wrong.start <= end and start <= wrong.end:
            edit = TextEdit(wrong.start, wrong.end, near)
            yield CodeAction(f"Replace '{name}' with '{near}'", _QUICK, (edit,), (), True)


def _all_frames(document: TransformsDocument, model: Model) -> Iterator[CodeAction]:
    listed = {word.text for word in document.frames}
    missing = [name for name in frame_names(model) if name not in listed]
    edit = _listed(document, missing)
    if missing and edit is not None:
        yield CodeAction(f"List every frame of '{model.name}'", _REWRITE, (edit,))


def _listed(document: TransformsDocument, names: list[str]) -> TextEdit | None:
    """Return the edit that adds frames to the list; None where there is no place for them."""
    if document.frames:
        last = document.frames[-1].end
        return TextEdit(last, last, "".join(f", {name}" for name in names))
    if document.robot is None or document.defects:
        return None
    return TextEdit(
        document.robot.end, document.robot.end, f"\nFrames {{\n    {', '.join(names)}\n}}"
    )
