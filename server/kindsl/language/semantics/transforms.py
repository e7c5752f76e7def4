"""The meaning of names in a transforms document, and their defects."""

import math
import re
from collections.abc import Iterable, Iterator

from kindsl.language.semantics.declarations import Frame
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import triple
from kindsl.language.syntax.transforms_text import Defect, PlacedName, TransformsDocument
from kindsl.language.text.nearest import hint, nearest_name

LINK_PREFIX = "fr_"
_OF_OTHER_LETTERS = re.compile(r"\w*[^\W\x00-\x7f]\w*")


class UnwritableNameError(ValueError):
    """RobCoGen cannot read a name in a transforms document."""


def frame_names(model: Model) -> dict[str, str]:
    """Return the name here of each frame of a model, with the name there.

    A link's own frame is `fr_` and the link's name; an optional frame keeps its name and wins.
    """
    bodies = [model.base, *model.links] if model.base is not None else [*model.links]
    own = {f"{LINK_PREFIX}{body.name}": str(body.name) for body in bodies}
    return {**own, **{str(f.name): str(f.name) for body in bodies for f in body.frames}}


def joint_frame_names(model: Model) -> dict[str, str]:
    """Return the name of each joint's frame, fixed to the parent, with the joint's name."""
    return {f"{LINK_PREFIX}{joint.name}": str(joint.name) for joint in model.joints}


def unknown_frames(document: TransformsDocument, model: Model) -> Iterator[Defect]:
    """Yield frames of transforms and Jacobians that the robot lacks, each where it is first."""
    pairs = [*_words_of_pairs(document)]
    used = {word.text for word in pairs}
    yield from _unknown(model, [w for w in (*document.frames, *pairs) if w.text in used])


def unknown_listed_frames(document: TransformsDocument, model: Model) -> Iterator[Defect]:
    """Yield frames that are listed without being used, and that the robot does not have."""
    used = {word.text for word in _words_of_pairs(document)}
    yield from _unknown(model, [word for word in document.frames if word.text not in used])


def _unknown(model: Model, words: Iterable[PlacedName]) -> Iterator[Defect]:
    known = {**joint_frame_names(model), **frame_names(model)}
    seen = set(known)
    for word in words:
        if word.text not in seen:
            seen.add(word.text)
            own = f"{LINK_PREFIX}{word.text}"
            close = hint(own if own in known else nearest_name(word.text, known))
            yield Defect(f"the robot has no frame '{word.text}'{close}", word.start, word.end)


def undeclared_frames(document: TransformsDocument, _: Model | None) -> Iterator[Defect]:
    """Yield frames of pairs that `Frames` does not list."""
    declared = {word.text for word in document.frames}
    for word in _words_of_pairs(document):
        if word.text not in declared:
            yield Defect(f"'{word.text}' is not listed under 'Frames'", word.start, word.end)


def repetitions(document: TransformsDocument, _: Model | None) -> Iterator[Defect]:
    """Yield frames under `Frames`, and pairs, that were there before."""
    listed: set[str] = set()
    for word in document.frames:
        if word.text in listed:
            yield Defect(f"frame '{word.text}' is already listed", word.start, word.end)
        listed.add(word.text)
    for what, pairs in (("transform", document.transforms), ("Jacobian", document.jacobians)):
        seen: set[tuple[str, str]] = set()
        for pair in pairs:
            key = (pair.base.text, pair.target.text)
            if key in seen:
                message = f"the {what} of '{key[1]}' in '{key[0]}' is already listed"
                yield Defect(message, *pair.span)
            seen.add(key)


def other_robot(document: TransformsDocument, model: Model) -> Iterator[Defect]:
    """Yield the robot's name if it is not the model's."""
    word = document.robot
    if word is not None and model.name and word.text != model.name:
        yield Defect(f"the robot is '{model.name}', not '{word.text}'", word.start, word.end)


def _words_of_pairs(document: TransformsDocument) -> Iterator[PlacedName]:
    for pair in (*document.transforms, *document.jacobians):
        yield from pair


def transforms_document(model: Model) -> str:
    """Return the document that wants each link's and frame's pose, and the Jacobians of tips.

    Tips are the outermost frames on links without children, such as feet and tools, or such a link
    itself if it has none. All is seen from the base; without one, from the first link.

    Raises:
        UnwritableNameError: A name has other letters than a to z.
    """
    frames = list(frame_names(model))
    base, poses = frames[0], _pairs(frames[0], frames)
    jacobians = _pairs(base, _tips(model))
    listed = f"Frames {{\n    {', '.join(frames)}\n}}"
    text = f"Robot {model.name}\n{listed}\nTransforms {{\n{poses}}}\nJacobians {{\n{jacobians}}}\n"
    if foreign := _OF_OTHER_LETTERS.search(text):
        raise UnwritableNameError(
            f"'{foreign[0]}' is not a valid name in RobCoGen's code: "
            "use letters a to z, digits and '_'"
        )
    return text


def _pairs(base: str, targets: Iterable[str]) -> str:
    return "".join(f"    base={base}, target={name}\n" for name in targets if name != base)


def _tips(model: Model) -> Iterator[str]:
    for body in model.bodies:
        if not body.children and not body.is_base:
            tip = max(body.frames, key=_distance, default=None)
            yield f"{LINK_PREFIX}{body.name}" if tip is None else str(tip.name)


def _distance(frame: Frame) -> float:
    """Return how far a frame is from its link's origin; infinity where that is not known."""
    place = triple(frame.pose.translation, {})
    return math.inf if place is None else math.hypot(*place)
