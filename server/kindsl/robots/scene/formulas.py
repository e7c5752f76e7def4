"""Places as formulas of parameters, for pages without a server to evaluate the document.

In this language a value is a number, or a number times a parameter. So each component of a
translation or rotation is told as its value with all parameters zero, and a factor for each.
"""

from collections.abc import Iterator
from typing import Literal

from kindsl.language.semantics.declarations import Link, Pose, Vector
from kindsl.language.semantics.expressions import Expression, ParameterUse, Values, symbols
from kindsl.language.semantics.model import Model
from kindsl.robots.scene.messages import Affine, FormulaMessage, path_of

_COMPONENTS = 3
_ELSEWHERE = 2.3


def formula_messages(model: Model, values: Values) -> Iterator[FormulaMessage]:
    """Yield the formula of each joint and frame whose place has parameters in it.

    Args:
        values: Of parameters by name, and of constants by `<name>`.
    """
    for edge in model.tree.edges:
        if edge.joint is not None:
            name, pose = str(edge.joint.name), edge.joint.pose
            yield from _formula("joints", name, edge.predecessor, pose, values)
    for body in model.bodies:
        for frame in body.frames:
            yield from _formula("frames", str(frame.name), body, frame.pose, values)


def _formula(
    group: Literal["joints", "frames"], name: str, carrier: Link, pose: Pose, values: Values
) -> Iterator[FormulaMessage]:
    translation, rotation = (
        affine_vector(pose.translation, values),
        affine_vector(pose.rotation, values),
    )
    if translation is None or rotation is None:
        return
    if not any(terms for _, terms in (*translation, *rotation)):
        return
    body = ("robot", "links", str(carrier.name), "base" if carrier.is_base else "body")
    yield FormulaMessage(
        path=path_of("formulas", group, name),
        group=group,
        name=name,
        link=str(carrier.name),
        translation=translation,
        rotation=rotation,
        rod=path_of(*body, f"segment-{name}"),
        end=path_of(*body, f"end-{name}"),
    )


def affine_vector(vector: Vector | None, values: Values) -> tuple[Affine, ...] | None:
    """Return the components of a vector, None if one has another form or no value."""
    if vector is None:
        return None
    components = [affine_component(component, values) for component in vector.components]
    known = tuple(component for component in components if component is not None)
    return known if len(known) == _COMPONENTS else None


def affine_component(expression: Expression, values: Values) -> Affine | None:
    """Return the value at zero and the factor of each parameter, None if it is not affine."""
    names = {str(use.name) for use in symbols(expression) if isinstance(use, ParameterUse)}
    at_zero = {**values, **dict.fromkeys(names, 0.0)}
    constant = expression.value(at_zero)
    if constant is None:
        return None
    factors: list[tuple[str, float]] = []
    for name in sorted(names):
        at_one = expression.value({**at_zero, name: 1.0})
        if at_one is None:
            return None
        factors.append((name, at_one - constant))
    # Somewhere else, to tell what is not linear, or a product of two parameters.
    value = expression.value({**at_zero, **dict.fromkeys(names, _ELSEWHERE)})
    linear = constant + _ELSEWHERE * sum(factor for _, factor in factors)
    if value is None or abs(value - linear) > 1e-9:
        return None
    return constant, tuple(factors)
