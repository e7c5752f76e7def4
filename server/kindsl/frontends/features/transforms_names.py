"""Names of a robot in the transforms document beside it."""

from collections.abc import Iterator

from kindsl.frontends.features.symbol_at import EntityKind, symbol_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.transforms import LINK_PREFIX, frame_names
from kindsl.language.syntax.transforms_text import PlacedName, TransformsDocument, read_transforms
from kindsl.language.text.edits import TextEdit


def renamed_transforms(
    analysis: Analysis, offset: int, new_name: str, text: str
) -> tuple[TextEdit, ...]:
    """Return the edits of a transforms document when something of its robot takes another name.

    Args:
        analysis: The robot's document, before the renaming.
        offset: Where the old name stands.
        new_name: The new name.
        text: The transforms document.
    """
    symbol = symbol_at(analysis, offset)
    if symbol is None:
        return ()
    kind, name = symbol.entity.kind, symbol.entity.name
    document = read_transforms(text)
    new_name = new_name.strip().removeprefix("^")
    if kind is EntityKind.ROBOT:
        robot = document.robot
        return (TextEdit(robot.start, robot.end, new_name),) if robot is not None else ()
    if kind is EntityKind.LINK:
        # An optional frame may have the name that the link's own frame would have.
        own = f"{LINK_PREFIX}{name}"
        if frame_names(analysis.model).get(own) != name:
            return ()
        return tuple(_edits(document, own, f"{LINK_PREFIX}{new_name}"))
    return tuple(_edits(document, name, new_name)) if kind is EntityKind.FRAME else ()


def _edits(document: TransformsDocument, old: str, new: str) -> Iterator[TextEdit]:
    words: list[PlacedName] = list(document.frames)
    for pair in (*document.transforms, *document.jacobians):
        words += pair
    for word in words:
        if word.text == old:
            yield TextEdit(word.start, word.end, new)
