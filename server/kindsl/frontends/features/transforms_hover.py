"""Hovers in a transforms document."""

from kindsl.frontends.features.wording import Hover, code
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.transforms import frame_names, joint_frame_names
from kindsl.language.syntax.transforms_text import FramePair, read_transforms


def transforms_hover(text: str, offset: int, model: Model | None) -> Hover | None:
    """Return the meaning of the pair or frame at an offset, None where there is none.

    Args:
        text: The transforms document.
        offset: The cursor, code points.
        model: The robot that it is about, None if that is not known.
    """
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
