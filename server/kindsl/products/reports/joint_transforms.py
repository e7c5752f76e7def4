"""The transform of a joint in closed form: `predecessor_T_link` as formulas of q and parameters."""

from collections.abc import Mapping, Sequence
from math import cos, pi, sin
from typing import NamedTuple

from kindsl.language.semantics.declarations import Joint, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.robots.scene.formulas import affine_component

_EXACT = 1e-9  # radians from a quarter turn that count as one, as written with nine digits
VARIABLE = "q"


class _Factor(NamedTuple):
    """A sign, 0 for nothing at all, and functions that are multiplied."""

    sign: int
    parts: tuple[str, ...] = ()

    def times(self, other: "_Factor") -> "_Factor":
        return _Factor(self.sign * other.sign, (*self.parts, *other.parts))


class _Linear(NamedTuple):
    """A constant and names with factors."""

    constant: float
    terms: tuple[tuple[str, float], ...] = ()


_ONE, _MINUS = _Factor(1), _Factor(-1)
Rows = tuple[tuple[str, ...], ...]


def joint_transform(joint: Joint, values: Mapping[str, float]) -> Rows | None:
    """Return the 4 rows of the link's pose in its predecessor, None if the pose is not whole.

    Args:
        joint: A joint.
        values: Of parameters by name, and of constants by `<name>`.
    """
    at, turned = (_components(v, values) for v in (joint.pose.translation, joint.pose.rotation))
    if at is None or turned is None:
        return None
    a, b, c = turned
    if joint.kind == "revolute":
        c = _Linear(c.constant, (*c.terms, (VARIABLE, 1.0)))
    rotation = _rotation(a, b, c)
    position = [_sum([_linear(x)]) for x in at]
    if joint.kind == "prismatic":
        q = _Factor(1, (VARIABLE,))
        columns = [[term.times(q) for term in row[2]] for row in rotation]
        position = [_sum([_linear(x)], slide) for x, slide in zip(at, columns, strict=True)]
    rows = [
        (*(_sum([], entry) for entry in row), place)
        for row, place in zip(rotation, position, strict=True)
    ]
    return (*rows, ("0", "0", "0", "1"))


def _components(
    vector: Vector | None, values: Mapping[str, float]
) -> tuple[_Linear, _Linear, _Linear] | None:
    if vector is None:
        return None
    x, y, z = (_affine(component, values) for component in vector.components)
    return None if x is None or y is None or z is None else (x, y, z)


def _affine(expression: Expression, values: Mapping[str, float]) -> _Linear | None:
    found = affine_component(expression, values)
    return None if found is None else _Linear(found[0], tuple(found[1]))


def _rotation(a: _Linear, b: _Linear, c: _Linear) -> list[list[list[_Factor]]]:
    """Return the entries of turns about x, the new y, the new z, each a sum of products."""
    (cx, sx), (cy, sy), (cz, sz) = (_cosine_and_sine(angle) for angle in (a, b, c))

    def product(*factors: _Factor) -> _Factor:
        result = _ONE
        for factor in factors:
            result = result.times(factor)
        return result

    return [
        [[product(cy, cz)], [product(_MINUS, cy, sz)], [sy]],
        [
            [product(cx, sz), product(sx, sy, cz)],
            [product(cx, cz), product(_MINUS, sx, sy, sz)],
            [product(_MINUS, sx, cy)],
        ],
        [
            [product(sx, sz), product(_MINUS, cx, sy, cz)],
            [product(sx, cz), product(cx, sy, sz)],
            [product(cx, cy)],
        ],
    ]


def _cosine_and_sine(angle: _Linear) -> tuple[_Factor, _Factor]:
    """Return both, quarter turns taken out of the angle."""
    quarters = round(angle.constant / (pi / 2.0))
    is_exact = abs(angle.constant - quarters * pi / 2.0) < _EXACT
    if not angle.terms:
        if is_exact:
            return _Factor(round(cos(quarters * pi / 2.0))), _Factor(round(sin(quarters * pi / 2)))
        return _Factor(1, (_called("cos", angle),)), _Factor(1, (_called("sin", angle),))
    rest = _Linear(0.0 if is_exact else angle.constant, angle.terms)
    c, s = (_Factor(1, (_called(name, rest),)) for name in ("cos", "sin"))
    turns = ((c, s), (_MINUS.times(s), c), (_MINUS.times(c), _MINUS.times(s)), (s, _MINUS.times(c)))
    return turns[quarters % 4] if is_exact else (c, s)


def _called(name: str, angle: _Linear) -> str:
    return f"{name}({_linear(angle)})"


def _linear(value: _Linear) -> str:
    terms = [_scaled(factor, name) for name, factor in value.terms if factor]
    return _joined([*terms, *([_number(value.constant)] if value.constant else [])])


def _scaled(factor: float, name: str) -> str:
    return {1.0: name, -1.0: f"-{name}"}.get(factor, f"{_number(factor)}*{name}")


def _sum(first: Sequence[str], products: Sequence[_Factor] = ()) -> str:
    """Return the sum of formulas and products; zeros are left out."""
    terms = [formula for formula in first if formula != "0"]
    return _joined([*terms, *(_product(factor) for factor in products if factor.sign)])


def _product(factor: _Factor) -> str:
    return ("-" if factor.sign < 0 else "") + ("*".join(factor.parts) or "1")


def _joined(terms: Sequence[str]) -> str:
    return " + ".join(terms).replace("+ -", "- ") or "0"


def _number(value: float) -> str:
    return f"{value:.12g}"
