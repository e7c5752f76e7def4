"""Movable things in the picture: joints, optional frames, centres of mass, by their numbers."""

from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.rules.broken_text import has_problem_within
from kindsl.language.semantics.declarations import Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.model import Model
from kindsl.robots.mechanism.skeleton import named_frames

LENGTHS = ("x", "y", "z")
ANGLES = ("rx", "ry", "rz")


class Thing(NamedTuple):
    """Something that has numbers of its own in the document.

    Attributes:
        kind: `"joint"`, `"frame"` or `"com"`.
        name: Of the joint, of the frame as it is drawn (`link.frame` where its name is taken), or
            of the link whose centre of mass it is.
    """

    kind: str
    name: str


class Missing(NamedTuple):
    """The reason why there is no number to move: one sentence without final period."""

    reason: str


def component(analysis: Analysis, thing: Thing, name: str) -> Expression | Missing:
    """Return the value that a component is written as.

    Args:
        analysis: The document.
        thing: The thing that is moved.
        name: `x y z` in metres along the axes of what carries it, `rx ry rz` in radians about x,
            the new y, the new z.
    """
    found = _vectors(analysis.model, thing)
    if isinstance(found, Missing):
        return found
    translation, rotation = found
    vector = translation if name in LENGTHS else rotation if name in ANGLES else None
    if vector is None:
        return Missing(f"{thing.kind} '{thing.name}' has no component '{name}'")
    row = LENGTHS if name in LENGTHS else ANGLES
    value = vector.components[row.index(name)]
    if not value.text:
        return Missing(f"component {name} of {thing.kind} '{thing.name}' is missing")
    if has_problem_within(value):
        return Missing(f"'{value.text}' is not a valid value")
    return value


def carrying_frame(model: Model, thing: Thing) -> str:
    """Return the frame along whose axes a centre of mass is written, empty for its link's."""
    link = model.body_named.get(thing.name) if thing.kind == "com" else None
    inertia = link.inertia if link is not None else None
    if link is None or inertia is None or inertia.frame is None:
        return ""
    found = named_frames(model.bodies)
    names = (name for name, body, frame in found if body is link and frame.name == inertia.frame)
    return next(names, "")


def _vectors(model: Model, thing: Thing) -> tuple[Vector | None, Vector | None] | Missing:
    if thing.kind == "joint":
        alike = [joint for joint in model.joints if joint.name == thing.name]
        if len(alike) > 1:
            return Missing(f"{len(alike)} joints are named '{thing.name}'")
        return alike[0].pose if alike else _unknown(thing)
    if thing.kind == "frame":
        found = (frame for name, _, frame in named_frames(model.bodies) if name == thing.name)
        frame = next(found, None)
        return frame.pose if frame is not None else _unknown(thing)
    if thing.kind == "com":
        link = model.body_named.get(thing.name)
        if link is None:
            return _unknown(thing)
        if link.inertia is None:
            return Missing(f"link '{thing.name}' has no inertia section")
        return link.inertia.com, None
    return _unknown(thing)


def _unknown(thing: Thing) -> Missing:
    return Missing(f"there is no {thing.kind} '{thing.name}'")
