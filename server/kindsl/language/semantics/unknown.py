"""Unknown properties of a model, and the reasons."""

from collections.abc import Iterable, Mapping
from math import isfinite
from typing import NamedTuple

from kindsl.language.semantics.declarations import Inertia, Pose, Vector
from kindsl.language.semantics.expressions import ConstantUse, Expression, is_undecided, symbols
from kindsl.language.syntax.vocabulary import MOMENTS


class Unknown(NamedTuple):
    """The reason why a number is not known: a clause, names in it as Markdown marks code."""

    reason: str

    @property
    def plain(self) -> str:
        """The clause with its names in quotes."""
        return self.reason.replace("`", "'")


def why_unknown(values: Iterable[Expression], bindings: Mapping[str, float]) -> Unknown:
    """Return why some of these values are not known."""
    for expression in values:
        value = expression.value(bindings)
        if value is not None:
            if isfinite(value):
                continue
            return Unknown(f"`{expression.text}` is not finite")
        for symbol in symbols(expression):
            if isinstance(symbol, ConstantUse):
                if f"<{symbol.name}>" not in bindings:
                    return Unknown(f"the constant `{symbol.name}` has no value")
            elif str(symbol.name) not in bindings and symbol.default is None:
                return Unknown(f"the parameter `{symbol.name}` has no value")
        if is_undecided(expression):
            return Unknown(f"`{expression.text}` is read in two ways")
        if expression.text:
            return Unknown(f"`{expression.text}` is not a number")
    return Unknown("a number is missing")


def pose_expressions(pose: Pose) -> Iterable[Expression]:
    """Yield the values of a pose."""
    for vector in pose:
        yield from vector_expressions(vector)


def vector_expressions(vector: Vector | None) -> Iterable[Expression]:
    """Yield the components of a vector, if there is one."""
    return vector.components if vector is not None else ()


def inertia_expressions(inertia: Inertia) -> list[Expression]:
    """Return the values of an inertia that are there: mass, CoM, moments, ten where it is whole."""
    mass = [] if inertia.mass is None else [inertia.mass]
    moments = (inertia.moments[name] for name in MOMENTS if name in inertia.moments)
    return [*mass, *vector_expressions(inertia.com), *moments]
