"""Random rigid bodies, and how an author writes their numbers down."""

import random
from collections.abc import Callable
from decimal import Decimal
from math import cos, pi, sin, sqrt

from kindsl.mechanics.rigid.body import MassDistribution, moments_of

Matrix = list[list[float]]
Writer = Callable[[float], str]

SHAPES = ("block", "plate", "rod", "point", "slender", "flat")


def random_body(generator: random.Random, shape: str = "block") -> MassDistribution:
    """Return a body that is possible, in a random orientation and place.

    Args:
        generator: Source of randomness.
        shape: One of `SHAPES`; plate, rod and point have no extent in one, two, three directions.
    """
    size = 10.0 ** generator.uniform(-1.7, -0.1)
    mass = 10.0 ** generator.uniform(-1.0, 1.7)
    radii = [size * generator.uniform(0.15, 0.5) for _ in range(3)]
    thin = {"block": 1.0, "slender": 0.02, "flat": 0.02}.get(shape, 0.0)
    for axis in range({"block": 0, "plate": 1, "flat": 1, "point": 3}.get(shape, 2)):
        radii[axis] *= thin
    com = [generator.uniform(-0.6, 0.6) * size for _ in range(3)]
    rotation = random_rotation(generator)
    about_com = [
        [
            sum(rotation[i][k] * rotation[j][k] * mass * radii[k] ** 2 for k in range(3))
            for j in range(3)
        ]
        for i in range(3)
    ]
    return body_of(mass, com, about_com)


def body_of(mass: float, com: list[float], second_moments: Matrix) -> MassDistribution:
    """Return the body with these second moments about the CoM, as the DSL gives it."""
    s = [[second_moments[i][j] + mass * com[i] * com[j] for j in range(3)] for i in range(3)]
    about_origin = (s[0][0], s[1][1], s[2][2], s[0][1], s[0][2], s[1][2])
    return MassDistribution(mass, (com[0], com[1], com[2]), moments_of(about_origin))


def random_rotation(generator: random.Random) -> Matrix:
    """Return a uniformly random rotation matrix; a multiple of a right angle in half of cases."""
    if generator.random() < 0.5:
        angle = generator.choice((0.0, pi / 2))
        c, s = round(cos(angle)), round(sin(angle))
        return [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]
    q = [generator.gauss(0.0, 1.0) for _ in range(4)]
    norm = sqrt(sum(x * x for x in q))
    w, x, y, z = (component / norm for component in q)
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def decimals(digits: int) -> Writer:
    """Return the writer of a fixed number of decimals: `0.1200`."""
    return lambda value: f"{value:.{digits}f}"


def short_decimals(digits: int) -> Writer:
    """Return the writer who rounds to decimals and drops trailing zeros: `0.12`, `0.0`."""
    return lambda value: _with_point(repr(Decimal(f"{value:.{digits}f}").normalize() + 0)[9:-2])


def significant(digits: int) -> Writer:
    """Return the writer of a number of significant digits: `0.00120`, `12.0`."""

    def write(value: float) -> str:
        text = f"{Decimal(f'{value:.{digits - 1}e}'):f}"
        return _with_point(text)

    return write


def mixed(generator: random.Random, kind: str, shorten: str) -> Writer:
    """Return the writer of as many digits as comes, `decimals` or `significant` ones.

    Args:
        generator: Source of randomness.
        kind: `decimals` or `significant`.
        shorten: How the other digits are dropped, as `decimal` calls it.
    """

    def write(value: float) -> str:
        exact, digits = Decimal(value), generator.choice((2, 3, 4, 5, 6, 6, 12))
        last = exact.adjusted() - digits + 1 if kind == "significant" and value else -digits
        return _with_point(f"{exact.quantize(Decimal(1).scaleb(last), rounding=shorten):f}")

    return write


def plainly(value: float) -> str:
    """Return a number with all of its digits and no exponent."""
    return _with_point(repr(value))


def inertia_text(body: MassDistribution, write: Writer) -> str:
    """Return an inertia section with the body's numbers."""
    names = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")
    com = ", ".join(write(component) for component in body.com)
    moments = " ".join(
        f"{name}={write(value)}" for name, value in zip(names, body.moments, strict=True)
    )
    return f"inertia_params {{ mass = {write(body.mass)} CoM = ({com}) {moments} }}"


def document_of_bodies(inertias: list[str]) -> str:
    """Return a star of links with these inertia sections."""
    numbers = range(1, len(inertias) + 1)
    children = " ".join(f"body{n} via joint{n}" for n in numbers)
    links = "\n".join(
        f"link body{n} {{ id = {n} {text} children {{}} }}"
        for n, text in zip(numbers, inertias, strict=True)
    )
    pose = "ref_frame { translation = (0.0, 0.0, %.1f) rotation = (0.0, 0.0, 0.0) }"
    joints = "\n".join(f"r_joint joint{n} {{ {pose % n} }}" for n in numbers)
    base = f"RobotBase ground {{ children {{ {children} }} }}"
    return f"Robot Bodies {{\n{base}\n{links}\n{joints}\n}}\n"


def _with_point(text: str) -> str:
    text = f"{Decimal(text):f}"
    return text if "." in text else f"{text}.0"


def tilted_rotation(generator: random.Random, spread: float) -> Matrix:
    """Return a rotation by a small random angle about a random axis, radians by `spread`."""
    x, y, z = (generator.gauss(0.0, spread) for _ in range(3))
    angle = sqrt(x * x + y * y + z * z) or 1.0
    x, y, z = x / angle, y / angle, z / angle
    c, s, d = cos(angle), sin(angle), 1.0 - cos(angle)
    return [
        [c + x * x * d, x * y * d - z * s, x * z * d + y * s],
        [y * x * d + z * s, c + y * y * d, y * z * d - x * s],
        [z * x * d - y * s, z * y * d + x * s, c + z * z * d],
    ]
