"""The transform of a joint in closed form: `predecessor_T_link` as formulas of q and parameters."""

from math import cos, pi, sin

from kindsl.language.semantics.declarations import Joint
from kindsl.language.semantics.expressions import Values
from kindsl.robots.scene.formulas import affine_vector
from kindsl.robots.scene.messages import Affine

_EXACT = 1e-9  # radians from a quarter turn that count as one, as written with nine digits
VARIABLE = "q"

Rows = tuple[tuple[str, ...], ...]


def joint_transform(joint: Joint, values: Values) -> Rows | None:
    """Return the 4 rows of the link's pose in its predecessor, None if the pose is not whole.

    Values are those of parameters by name, and of constants by `<name>`.
    """
    at = affine_vector(joint.pose.translation, values)
    turned = affine_vector(joint.pose.rotation, values)
    if at is None or turned is None:
        return None
    a, b, (angle, terms) = turned
    if joint.kind == "revolute":
        terms = (*terms, (VARIABLE, 1.0))
    rotation = _rotation(a, b, (angle, terms))
    slides = [_product(row[2], VARIABLE) if joint.kind == "prismatic" else "0" for row in rotation]
    places = (_sum(_linear(x), slide) for x, slide in zip(at, slides, strict=True))
    rows = ((*row, place) for row, place in zip(rotation, places, strict=True))
    return (*rows, ("0", "0", "0", "1"))


def _rotation(a: Affine, b: Affine, c: Affine) -> Rows:
    """Return the matrix of turns about x, the new y, the new z."""
    (cx, sx), (cy, sy), (cz, sz) = map(_cosine_and_sine, (a, b, c))
    return (
        (_product(cy, cz), _product("-1", cy, sz), sy),
        (
            _sum(_product(cx, sz), _product(sx, sy, cz)),
            _sum(_product(cx, cz), _product("-1", sx, sy, sz)),
            _product("-1", sx, cy),
        ),
        (
            _sum(_product(sx, sz), _product("-1", cx, sy, cz)),
            _sum(_product(sx, cz), _product(cx, sy, sz)),
            _product(cx, cy),
        ),
    )


def _cosine_and_sine(angle: Affine) -> tuple[str, str]:
    """Return both, quarter turns taken out of the angle."""
    constant, terms = angle
    quarters = round(constant / (pi / 2.0))
    is_exact = abs(constant - quarters * pi / 2.0) < _EXACT
    if is_exact and not terms:
        return str(round(cos(quarters * pi / 2.0))), str(round(sin(quarters * pi / 2.0)))
    rest = _linear((0.0 if is_exact else constant, terms))
    c, s = f"cos({rest})", f"sin({rest})"
    turns = ((c, s), (f"-{s}", c), (f"-{c}", f"-{s}"), (s, f"-{c}"))
    return turns[quarters % 4] if is_exact else (c, s)


def _linear(value: Affine) -> str:
    constant, terms = value
    return _sum(*(_scaled(factor, name) for name, factor in terms if factor), _number(constant))


def _scaled(factor: float, name: str) -> str:
    return {1.0: name, -1.0: f"-{name}"}.get(factor, f"{_number(factor)}*{name}")


def _product(*factors: str) -> str:
    """Return a product of 0, 1, -1 and functions with perhaps a sign before them."""
    if "0" in factors:
        return "0"
    sign = "-" * (sum(factor.startswith("-") for factor in factors) % 2)
    parts = (factor.removeprefix("-") for factor in factors)
    return sign + ("*".join(part for part in parts if part != "1") or "1")


def _sum(*terms: str) -> str:
    return " + ".join(term for term in terms if term != "0").replace("+ -", "- ") or "0"


def _number(value: float) -> str:
    return f"{value or 0.0:.12g}"
