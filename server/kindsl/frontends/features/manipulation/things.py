"""Movable things in the picture: joints, optional frames, centres of mass, by their numbers."""

from typing import NamedTuple

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.language.semantics.declarations import Vector
from kindsl.language.semantics.expressions import ConstantUse, Expression, ParameterUse, symbols
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import Constant, Parameter
from kindsl.language.semantics.places import has_problem_within
from kindsl.language.syntax.arithmetic import number_of
from kindsl.language.syntax.tree import Node
from kindsl.language.syntax.value_forms import is_signed_product
from kindsl.robots.mechanism.reading import named_frames

LENGTHS = ("x", "y", "z")
ANGLES = ("rx", "ry", "rz")
_NAMED = ("parameter", "defaulted", "constant", "constant_use")


class Thing(NamedTuple):
    """Something that has numbers of its own in the document.

    Attributes:
        kind: `"joint"`, `"frame"` or `"com"`.
        name: Of the joint, of the frame as it is drawn (`link.frame` where its name is taken), or
            of the link whose centre of mass it is.
    """

    kind: str
    name: str


class Carrier(NamedTuple):
    """The one parameter or constant in a value.

    Attributes:
        use: Its use there.
        factor: The value is the symbol's times this.
    """

    use: ParameterUse | ConstantUse
    factor: float


class Component(NamedTuple):
    """One number of a thing.

    Attributes:
        expression: As written.
        carrier: The name that carries it, None where it is a plain number, or why it cannot be
            changed.
    """

    expression: Expression
    carrier: Carrier | Refusal | None


def components(model: Model, thing: Thing) -> dict[str, Component | Refusal]:
    """Return the numbers of a thing by name, or why one is not there.

    `x y z` are in metres along the axes of the thing's parent, `rx ry rz` in radians about x, the
    new y, the new z. A centre of mass has the first three.
    """
    rows = (LENGTHS,) if thing.kind == "com" else (LENGTHS, ANGLES)
    vectors = _vectors(model, thing)
    if isinstance(vectors, Refusal):
        return {name: vectors for row in rows for name in row}
    return {
        name: _component(thing, name, vector)
        for row, vector in zip(rows, vectors, strict=True)
        for name in row
    }


def component(model: Model, thing: Thing, name: str) -> Component | Refusal:
    """Return one number of a thing, or why it is not there."""
    return components(model, thing).get(name) or _lacking(thing, name)


def carrier_of(expression: Expression) -> Carrier | Refusal | None:
    """Return the name that carries a value, None where the value has no names."""
    use = next(symbols(expression), None)
    if use is None:
        return None
    factor = _factor(expression.node)
    if not factor:
        return Refusal(f"'{expression.text}' cannot be solved for one name")
    return Carrier(use, factor)


def _factor(node: Node) -> float:
    """Return the number that the name in a value is multiplied by, zero in other expressions."""
    operands = node.parts
    if node.kind == "juxtaposed_parameter":
        return number_of(node.children[0]) or 0.0
    if node.kind == "negate":
        return -_factor(operands[0])
    if node.kind == "multiply" or is_signed_product(node):
        product = (number_of(operands[0].children[0]) or 0.0) * _factor(operands[1])
        return product if node.kind == "multiply" else -product
    if node.kind == "divide":
        divisor = number_of(operands[1].children[0])
        return _factor(operands[0]) / divisor if divisor else 0.0
    return float(node.kind in _NAMED)


def declared(model: Model, use: ParameterUse | ConstantUse) -> Parameter | Constant:
    """Return the parameter or constant of a use."""
    if isinstance(use, ParameterUse):
        return next(each for each in model.parameters if each.name == use.name)
    return next(each for each in model.constants if each.name == use.name)


def carrying_frame(model: Model, thing: Thing) -> str:
    """Return the frame along whose axes a centre of mass is written, empty for its link's."""
    link = model.body_named.get(thing.name) if thing.kind == "com" else None
    inertia = link.inertia if link is not None else None
    if link is None or inertia is None or inertia.frame is None:
        return ""
    found = named_frames(model.bodies)
    names = (name for name, body, frame in found if body is link and frame.name == inertia.frame)
    return next(names, "")


def _component(thing: Thing, name: str, vector: Vector | None) -> Component | Refusal:
    if vector is None:
        return _lacking(thing, name)
    value = vector.components[(LENGTHS if name in LENGTHS else ANGLES).index(name)]
    if not value.text:
        return Refusal(f"component {name} of {thing.kind} '{thing.name}' is missing")
    if has_problem_within(value):
        return Refusal(f"'{value.text}' is not a valid value")
    return Component(value, carrier_of(value))


def _lacking(thing: Thing, name: str) -> Refusal:
    return Refusal(f"{thing.kind} '{thing.name}' has no component '{name}'")


def _vectors(model: Model, thing: Thing) -> tuple[Vector | None, ...] | Refusal:
    if thing.kind == "joint":
        alike = [joint for joint in model.joints if joint.name == thing.name]
        if len(alike) > 1:
            return Refusal(f"{len(alike)} joints are named '{thing.name}'")
        poses = [joint.pose for joint in alike]
    elif thing.kind == "frame":
        frames = named_frames(model.bodies)
        poses = [frame.pose for name, _, frame in frames if name == thing.name]
    else:
        poses = []
        link = model.body_named.get(thing.name) if thing.kind == "com" else None
        if link is not None:
            no_inertia = Refusal(f"link '{thing.name}' has no inertia section")
            return (link.inertia.com,) if link.inertia is not None else no_inertia
    return poses[0] if poses else Refusal(f"there is no {thing.kind} '{thing.name}'")
