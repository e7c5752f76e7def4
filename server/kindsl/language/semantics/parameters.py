"""Parameters and named constants of a document, with all their places."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple, TypeVar

from kindsl.language.semantics.declarations import Declarations
from kindsl.language.semantics.expressions import ConstantUse, Expression, ParameterUse, symbols
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.places import Name
from kindsl.language.syntax.tables import ValueKind
from kindsl.language.syntax.tree import Island
from kindsl.language.syntax.value_forms import formed_values
from kindsl.language.text.facts import kept
from kindsl.language.text.groups import grouped


class Use(NamedTuple):
    """One place of a parameter.

    Attributes:
        name: The name where it stands.
        kind: The class of the value that it stands in.
        default: The default value given there, if any.
    """

    name: Name
    kind: ValueKind
    default: Expression | None


class Parameter(NamedTuple):
    """A name that stands for a value.

    Attributes:
        name: Its name at its first place.
        kind: The class of its first place.
        uses: All its places, in the order of the document.
        value: Its default in the document, None without one.
    """

    name: Name
    kind: ValueKind
    uses: tuple[Use, ...]
    value: float | None


class Constant(NamedTuple):
    """A named constant: places that define it, and all its places."""

    name: Name
    definitions: tuple[ConstantUse, ...]
    uses: tuple[ConstantUse, ...]


class Symbols(NamedTuple):
    """The parameters and constants that one island uses."""

    parameters: tuple[Use, ...]
    constants: tuple[ConstantUse, ...]


class Binding(NamedTuple):
    """A value given to a parameter from outside the document.

    Attributes:
        value: In SI units.
        minimum: Lower end of its range, None without one.
        maximum: Upper end of its range, None without one.
        origin: Where it comes from, for people: `kindsl.toml`, `--param`.
    """

    value: float
    minimum: float | None = None
    maximum: float | None = None
    origin: str = ""


class JointProperties(NamedTuple):
    """The limits and resistances of a joint, given outside the document; None where not given.

    Units are those of the joint: radians and N m, or metres and N.

    Attributes:
        minimum: Lower end of its range.
        maximum: Upper end of its range.
        effort: The greatest force of its motor.
        velocity: Its greatest speed.
        armature: Inertia of its rotor, seen from the joint, kg m^2 or kg.
        damping: Viscous friction, force a speed.
        friction: Coulomb friction, a force.
    """

    minimum: float | None = None
    maximum: float | None = None
    effort: float | None = None
    velocity: float | None = None
    armature: float | None = None
    damping: float | None = None
    friction: float | None = None

    @property
    def limits(self) -> tuple[float | None, float | None]:
        """The two ends of the range."""
        return self.minimum, self.maximum


UNTOLD = JointProperties()
_NO_SYMBOLS = Symbols((), ())
_Use = TypeVar("_Use", Use, ConstantUse)


@kept
def island_symbols(island: Island) -> Symbols:
    """Return what an island uses; computed once in its life."""
    return _collect(declarations(island)) if formed_values(island) else _NO_SYMBOLS


def parameters_of(uses: Iterable[Use]) -> tuple[Parameter, ...]:
    """Group uses by name, in the order of their first places."""
    return tuple(
        Parameter(group[0].name, group[0].kind, group, _first_default(group))
        for group in _by_name(uses)
    )


def constants_of(uses: Iterable[ConstantUse]) -> tuple[Constant, ...]:
    """Group uses by name, in the order of their first places."""
    return tuple(
        Constant(group[0].name, tuple(u for u in group if u.value is not None), group)
        for group in _by_name(uses)
    )


def _by_name(uses: Iterable[_Use]) -> Iterator[tuple[_Use, ...]]:
    return map(tuple, grouped((str(use.name), use) for use in uses).values())


def values_of(
    parameters: Iterable[Parameter], constants: Iterable[Constant], given: Mapping[str, float]
) -> dict[str, float]:
    """Return the value of each bound parameter by name, and of each constant by `<name>`.

    Values given from outside win over defaults in the document; of several defaults or
    definitions the first wins, as in robcogen2.
    """
    values = dict(given)
    for parameter in parameters:
        if parameter.value is not None:
            values.setdefault(str(parameter.name), parameter.value)
    for constant in constants:
        value = constant.definitions[0].value if constant.definitions else None
        number = value.value({}) if value is not None else None
        if number is not None:
            values[f"<{constant.name}>"] = number
    return values


def _first_default(uses: Iterable[Use]) -> float | None:
    defaults = (use.default.value({}) for use in uses if use.default is not None)
    return next((value for value in defaults if value is not None), None)


def _collect(declared: Declarations) -> Symbols:
    parameters: list[Use] = []
    constants: list[ConstantUse] = []
    for expression in declared.values():
        if expression.literal is not None:
            continue
        for symbol in symbols(expression):
            if isinstance(symbol, ParameterUse):
                parameters.append(Use(symbol.name, expression.meaning.kind, symbol.default))
            else:
                constants.append(symbol)
    parameters.sort(key=lambda use: use.name.start)
    constants.sort(key=lambda use: use.name.start)
    return Symbols(tuple(parameters), tuple(constants))
