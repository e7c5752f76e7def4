"""The one name that carries a value, and by what it is multiplied there."""

from math import pi
from typing import NamedTuple

from kindsl.semantics.expressions import ConstantUse, Expression, ParameterUse, number_of, symbols
from kindsl.syntax.tree import Node

_NAMED = frozenset(("parameter", "defaulted", "juxtaposed_parameter", "constant", "constant_use"))
_SAME = frozenset(("plus", "group"))


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


def carrier_of(expression: Expression) -> Carrier | None:
    """Return what carries a value, None where no name does, or it cannot be solved for."""
    uses = list(symbols(expression))
    factor = _factor(expression.node)
    return Carrier(uses[0], factor) if len(uses) == 1 and factor else None


def has_names(expression: Expression) -> bool:
    """Return whether a value has parameters or constants in it."""
    return any(True for _ in symbols(expression))


def unsolvable(expression: Expression) -> str:
    """Return why a value with names in it cannot be changed."""
    return f"'{expression.text}' cannot be solved for one name"


def _factor(node: Node) -> float | None:
    """Return what the name in a value is multiplied by, None where there is no one name."""
    if node.kind in _NAMED:
        return number_of(node.children[0]) if node.kind == "juxtaposed_parameter" else 1.0
    parts = [child for child in node.children if isinstance(child, Node)]
    if len(parts) == 1:
        inner = _factor(parts[0])
        if inner is None:
            return None
        return -inner if node.kind == "negate" else inner if node.kind in _SAME else None
    if len(parts) != 2 or node.kind not in ("multiply", "divide"):
        return None
    left, right = parts
    if node.kind == "divide":
        return _quotient(_factor(left), _plain(right))
    return _product(_factor(left), _plain(right)) or _product(_plain(left), _factor(right))


def _plain(node: Node) -> float | None:
    """Return the value of a number, with a sign or not."""
    if node.kind == "number":
        return number_of(node.children[0])
    if node.kind == "pi":
        return pi
    inner = [_plain(child) for child in node.children if isinstance(child, Node)]
    if len(inner) != 1 or inner[0] is None:
        return None
    return -inner[0] if node.kind == "negate" else inner[0] if node.kind in _SAME else None


def _product(left: float | None, right: float | None) -> float | None:
    return None if left is None or right is None else left * right


def _quotient(left: float | None, right: float | None) -> float | None:
    return None if left is None or not right else left / right
