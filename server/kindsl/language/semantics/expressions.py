"""Values as written: what they mean, and how exactly they were given."""

from collections.abc import Iterator, Mapping
from math import pi
from typing import NamedTuple, cast

from kindsl.language.semantics.places import Construct, Name
from kindsl.language.syntax.arithmetic import FLOATS, evaluate, name_of, name_token, number_of
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.value_forms import is_signed_product
from kindsl.language.syntax.vocabulary import NO_MEANING, Meaning

_MOST_DECIMALS = 300
# What multiplies the number that a value begins with; None where that is a parameter.
_SYMBOLS_BEHIND_NUMBERS = {"number": 1.0, "juxtaposed_pi": pi, "juxtaposed_parameter": None}
# A zero without a point in XML is exact: as a decimal it has more digits than any number beside it.
EXACT_ZERO = "0.000000000000000"


# Of parameters by name, and of constants by `<name>`.
Values = Mapping[str, float]


class Expression(Construct):
    """A value as written.

    Attributes:
        literal: Its value if it is a plain decimal number, else None.
        meaning: The section and component that it is the value of, their class and unit.
    """

    __slots__ = ("literal", "meaning")

    def __init__(self, node: Node, island: Island, meaning: Meaning = NO_MEANING) -> None:
        self.node = node
        self.island = island
        self.meaning = meaning
        self.literal = number_of(node.children[0]) if node.kind == "number" else None

    @property
    def text(self) -> str:
        """As written, characters as what they stand for."""
        if self.node.kind == "number":
            return cast(Token, self.node.children[0]).text
        written = self.island.text[self.start : self.end]
        return written if written.isascii() else " ".join(t.text for t in self.node.tokens())

    def value(self, bindings: Values) -> float | None:
        """Return the value in SI units, or None where a name is unbound or nothing is defined.

        Args:
            bindings: Values of parameters by name, and of constants by `<name>`.
        """
        return self.literal if self.literal is not None else evaluate(self.node, bindings, FLOATS)

    def rounding(self, bindings: Values) -> float:
        """Return how far the true value may be from the written one, to first order.

        A decimal number stands for all that round to it: half a unit of its last digit.
        """
        return _rounding(self.node, bindings)


class ParameterUse(NamedTuple):
    """A parameter in a value, with the default that stands there, if any."""

    name: Name
    default: Expression | None


class ConstantUse(NamedTuple):
    """A named constant in a value; `value` is None where it is only referred to."""

    name: Name
    value: Expression | None


def half_unit(text: str) -> float:
    """Return half a unit of the last digit of a decimal number as written."""
    mantissa, _, exponent = text.lower().partition("e")
    _, _, decimals = mantissa.partition(".")
    unit = float(f"1e{exponent}") if exponent else 1.0
    return 0.5 * unit / 10.0 ** min(len(decimals), _MOST_DECIMALS)


def symbols(expression: Expression) -> Iterator[ParameterUse | ConstantUse]:
    """Yield the parameters and constants of a value, in the order of the text."""
    island = expression.island
    for node in expression.node.walk():
        token = name_token(node) if node.kind in _USES else None
        if token is not None and token.text:
            name = Name.at(token.text.lstrip("^"), island, token.start, token.end)
            default = Expression(node.parts[0], island) if node.parts else None
            yield _USES[node.kind](name, default)


def is_undecided(expression: Expression) -> bool:
    """Return whether the generators read a value differently and no target decides."""
    return any(node.kind == "undecided" for node in expression.node.walk())


_USES: dict[str, type[ParameterUse | ConstantUse]] = {
    "parameter": ParameterUse,
    "defaulted": ParameterUse,
    "juxtaposed_parameter": ParameterUse,
    "constant": ConstantUse,
    "constant_use": ConstantUse,
}


def _rounding(node: Node, bindings: Values) -> float:
    if node.kind in _SYMBOLS_BEHIND_NUMBERS:
        token, symbol = node.children[0], _SYMBOLS_BEHIND_NUMBERS[node.kind]
        factor = bindings.get(name_of(node), 0.0) if symbol is None else symbol
        return abs(factor) * half_unit(cast(Token, token).text) if number_of(token) else 0.0
    parts = node.parts
    if is_signed_product(node):
        factor = evaluate(parts[1], bindings, FLOATS) or 0.0
        return abs(factor) * _rounding(parts[0], bindings)
    if node.kind in ("add", "subtract", "group", "plus", "negate"):
        return sum(_rounding(part, bindings) for part in parts)
    if node.kind in ("multiply", "divide"):
        return _rounding_of_product(node, parts, bindings)
    return 0.0


def _rounding_of_product(node: Node, parts: list[Node], bindings: Values) -> float:
    left, right = (evaluate(part, bindings, FLOATS) or 0.0 for part in parts)
    left_error, right_error = (_rounding(part, bindings) for part in parts)
    if node.kind == "multiply":
        return abs(right) * left_error + abs(left) * right_error
    if not right:
        return 0.0
    return (left_error + abs(left / right) * right_error) / abs(right)
