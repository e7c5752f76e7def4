"""The one name that carries a value, and by what it is multiplied there."""

from typing import NamedTuple

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.language.semantics.expressions import (
    ConstantUse,
    Expression,
    ParameterUse,
    number_of,
    symbols,
)
from kindsl.language.syntax.tree import Node

_NAMED = frozenset(("parameter", "defaulted", "constant", "constant_use"))


class Carrier(NamedTuple):
    """A parameter or constant in a value.

    Attributes:
        use: Its only use there.
        factor: The value is the symbol's times this.
    """

    use: ParameterUse | ConstantUse
    factor: float

    @property
    def key(self) -> str:
        """Its key among the values: a parameter's name, `<name>` for a constant."""
        name = str(self.use.name)
        return name if isinstance(self.use, ParameterUse) else f"<{name}>"


def carrier_of(expression: Expression) -> Carrier | Refusal | None:
    """Return what carries a value, why it cannot be solved for, None where it has no names."""
    use = next(symbols(expression), None)
    if use is None:
        return None
    factor = _factor(expression.node)
    if not factor:
        return Refusal(f"'{expression.text}' cannot be solved for one name")
    return Carrier(use, factor)


def _factor(node: Node) -> float:
    """Return what the name in a value is multiplied by, zero where there is no one name.

    Only the shapes that a generator takes are looked into: no sums, no brackets.
    """
    if node.kind == "juxtaposed_parameter":
        return _number(node)
    if node.kind in _NAMED:
        return 1.0
    operands = [child for child in node.children if isinstance(child, Node)]
    if node.kind == "negate":
        return -_factor(operands[0])
    if node.kind == "multiply":
        return _number(operands[0]) * _factor(operands[1])
    if node.kind == "divide":
        divisor = _number(operands[1])
        return _factor(operands[0]) / divisor if divisor else 0.0
    return 0.0


def _number(node: Node) -> float:
    """Return the number that a construct begins with, zero where it is a sign or a name."""
    return number_of(node.children[0]) or 0.0
