"""The transforms document of a robot: completions, hovers, actions, edits of a renaming.

Offsets are code points of its text. The robot that it is about is None where that is not known.
"""

import re
from collections.abc import Iterator
from itertools import chain

from kindsl.frontends.features.actions.action import REWRITE, CodeAction
from kindsl.frontends.features.completion.completion import Completions
from kindsl.frontends.features.completion.item import CompletionItem
from kindsl.frontends.features.outline import is_match
from kindsl.frontends.features.symbol_at import EntityKind, symbol_at
from kindsl.frontends.features.wording import Hover, code
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.transforms import (
    LINK_PREFIX,
    UnwritableNameError,
    frame_names,
    joint_frame_names,
    transforms_document,
    undeclared_frames,
    unknown_frames,
    unknown_listed_frames,
)
from kindsl.language.syntax.transforms_text import (
    SECTIONS,
    FramePair,
    PlacedName,
    TransformsDocument,
    read_transforms,
)
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.nearest import nearest_name

_WORD_BEFORE = re.compile(r"(?:[<>-]+|\w*)\Z")
_BEHIND_WORD = re.compile(r"\W")
_ARROWS = {"'<-'": "the base first", "'->'": "the base last"}
_PAIR = "base=${1:frame}, target=${2:frame}"
_IN_LIST = re.compile(r"\bFrames\s*\{[^}]*\Z")

_QUICK = "quickfix"


def transforms_completions(text: str, offset: int, model: Model | None) -> Completions:
    """Return what may be typed at an offset; nothing where a whole word stands."""
    word: str = _WORD_BEFORE.findall(text, 0, offset)[0]
    start = offset - len(word)
    end = offset + len(_BEHIND_WORD.split(text[offset:])[0])
    items = tuple(_items(text, start, model))
    if word and any(item.label == word for item in items):
        items = ()
    return Completions(tuple(item for item in items if is_match(word, item.label)), start, end)


def _items(text: str, start: int, model: Model | None) -> Iterator[CompletionItem]:
    """Yield what the parser expects at a place."""
    before = read_transforms(text[:start])
    if not before.expected:
        sections = [name for name in SECTIONS if not re.search(rf"\b{name}\b", text)]
        for name in sections:
            block = f"{name} {{\n\t$0\n}}"
            yield CompletionItem(name, "snippet", block, "section")
    for expected in before.expected:
        if expected == "a frame":
            yield from _frames(text, start, model)
        elif expected in _ARROWS:
            arrow = expected.strip("'")
            yield CompletionItem(arrow, "keyword", f"{arrow} ", _ARROWS[expected])
        elif expected == "a robot name":
            if model is not None and model.name:
                yield CompletionItem(str(model.name), "link", str(model.name), "the robot")
        elif expected == "'base'" and "'target'" in before.expected:
            yield CompletionItem("base, target", "snippet", _PAIR, "a pair of frames")
        elif expected == "'base'" or (expected == "'target'" and "'base'" not in before.expected):
            name = expected.strip("'")
            yield CompletionItem(name, "keyword", f"{name}=")
        elif expected == "'Robot'":
            yield CompletionItem("Robot", "keyword", "Robot ")


def _frames(text: str, start: int, model: Model | None) -> Iterator[CompletionItem]:
    """Yield the listed frames in a pair, the unlisted ones in the list."""
    listed = [word.text for word in read_transforms(text).frames if word.start != start]
    known = frame_names(model) if model is not None else {}
    is_in_list = _IN_LIST.search(text[:start]) is not None
    names = listed if listed and not is_in_list else [n for n in known if n not in listed]
    for name in names:
        of = known.get(name, name)
        yield CompletionItem(name, "frame", name, "" if of == name else f"frame of {of}")


def transforms_actions(text: str, model: Model | None, start: int, end: int) -> list[CodeAction]:
    """Return what can be done about a stretch of a transforms document."""
    document = read_transforms(text)
    if not text.strip():
        if model is None or not model.name or not model.bodies:
            return []
        try:
            edit = TextEdit(0, len(text), transforms_document(model))
        except UnwritableNameError:
            return []
        return [CodeAction(f"Write the transforms of '{model.name}'", REWRITE, (edit,))]
    found = [*_listings(text, document, start, end)]
    if model is not None:
        found += [*_replacements(text, document, model, start, end)]
        found += [*_all_frames(document, model)]
    return found


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
    for wrong in chain(unknown_frames(document, model), unknown_listed_frames(document, model)):
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
        yield CodeAction(f"List every frame of '{model.name}'", REWRITE, (edit,))


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


def renamed_transforms(
    analysis: Analysis, offset: int, new_name: str, text: str
) -> tuple[TextEdit, ...]:
    """Return the edits of a transforms document when something of its robot takes another name."""
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


def transforms_hover(text: str, offset: int, model: Model | None) -> Hover | None:
    """Return the meaning of the pair or frame at an offset, None where there is none."""
    document = read_transforms(text)
    for name in document.frames:
        if name.start <= offset <= name.end:
            return Hover(name.start, name.end, _frame(name.text, model))
    for pairs, letter in ((document.transforms, "X"), (document.jacobians, "J")):
        for pair in pairs:
            start, end = pair.span
            if start <= offset <= end:
                return Hover(start, end, _pair(pair, letter, model))
    return None


def _pair(pair: FramePair, letter: str, model: Model | None) -> str:
    base, target = (name.text for name in pair)
    frames = dict.fromkeys((base, target))
    described = "".join(f"\n\n{_frame(name, model)}" for name in frames)
    what, seen = ("pose", "in") if letter == "X" else ("Jacobian", "relative to")
    name = code(f"{base}_{letter}_{target}")
    return f"{name}: the {what} of {code(target)} {seen} {code(base)}.{described}"


def _frame(name: str, model: Model | None) -> str:
    """Return the link or frame that a name refers to."""
    if model is None:
        return code(name)
    links, joints = frame_names(model), joint_frame_names(model)
    if name in links:
        of = links[name]
        owner = next((b for b in model.bodies if any(f.name == of for f in b.frames)), None)
        if of != name:
            return f"{code(name)} is the frame of {code(of)}."
        return f"{code(name)} is a frame on {code(str(owner.name))}." if owner else code(name)
    if name in joints:
        return f"{code(name)} is the frame of the joint {code(joints[name])}, fixed to its parent."
    return f"{code(name)} is no frame of this robot."
