"""A digit that the other numbers contradict is told; what is honestly rounded is taken over."""

import random
from itertools import product

import pytest
from tests.support.amount import usually

import kindsl

AXES = "XYZ"
PAIRS = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
Numbers = dict[str, str]


def report(numbers: Numbers) -> str:
    lines = [f"Mass = {numbers['Mass']} kilograms", "Center of mass: ( meters )"]
    lines += [f"\t{axis} = {numbers[axis]}" for axis in AXES]
    for letter, place in (
        ("L", "center of mass and aligned with the output coordinate system"),
        ("I", "output coordinate system"),
    ):
        lines += [
            "Moments of inertia: ( kilograms * square meters )",
            f"Taken at the {place}.",
            *("\t".join(f"{letter}{a}{b} = {numbers[letter + a + b]}" for b in "xyz")
              for a in "xyz"),
        ]  # fmt: skip
    return "\n".join(lines) + "\n"


def random_numbers(generator: random.Random) -> Numbers:
    """Return the numbers of a random body, rounded, its products of either convention."""
    sign = generator.choice((1, -1))
    mass = generator.uniform(0.1, 20.0)
    c = [generator.uniform(-0.4, 0.4) for _ in range(3)]
    points = [[generator.gauss(0.0, 0.1) for _ in range(3)] for _ in range(8)]
    mean = [sum(column) / 8 for column in zip(*points, strict=True)]
    spread = [
        [sum((p[i] - mean[i]) * (p[j] - mean[j]) for p in points) * mass / 8 for j in range(3)]
        for i in range(3)
    ]
    decimals = generator.randint(3, 9)
    numbers = {"Mass": f"{mass:.{decimals}f}"}
    numbers |= {axis: f"{x:.{decimals}f}" for axis, x in zip(AXES, c, strict=True)}
    trace = sum(spread[i][i] for i in range(3))
    for letter, arms in (("L", 0.0), ("I", mass)):
        total = trace + arms * sum(x * x for x in c)
        for i, j in product(range(3), repeat=2):
            moment = spread[i][j] + arms * c[i] * c[j]
            value = total - moment if i == j else sign * moment
            numbers[f"{letter}{'xyz'[i]}{'xyz'[j]}"] = f"{value:z.{decimals}f}"
    return numbers


def spoiled(numbers: Numbers, name: str, generator: random.Random) -> Numbers:
    """Return the numbers with one digit of one of them changed, at both its places in a tensor."""
    text = numbers[name]
    at = generator.choice([index for index, c in enumerate(text) if c.isdigit()])
    digit = str((int(text[at]) + generator.randint(1, 9)) % 10)
    new = text[:at] + digit + text[at + 1 :]
    return {**numbers, name: new, name[:-2] + name[:-3:-1] if len(name) == 3 else name: new}


def contradicts(numbers: Numbers) -> bool:
    """Return whether no exact numbers, each rounded to what is printed, are those of a body."""
    half = 0.5 * 10.0 ** -len(numbers["Mass"].partition(".")[2]) * (1.0 + 1e-5)
    mass, *c = (float(numbers[name]) for name in ("Mass", *AXES))
    is_wrong = {1: False, -1: False}
    for i, j in PAIRS:
        name = "xyz"[i] + "xyz"[j]
        found = float(numbers["I" + name]) - float(numbers["L" + name])
        for sign in (1, -1):
            values = [_arm(i, j, sign, m, x) for m, x in _corners(mass, c, half)]
            is_wrong[sign] |= not min(values) - 2 * half <= found <= max(values) + 2 * half
    return all(is_wrong.values())


def _corners(mass: float, c: list[float], half: float) -> list[tuple[float, list[float]]]:
    """Return all numbers at the ends of what rounds to them, and zeros between."""
    ends = [
        (x - half, x + half, 0.0) if abs(x) < half else (x - half, x + half) for x in (mass, *c)
    ]
    return [(m, list(x)) for m, *x in product(*ends)]


def _arm(i: int, j: int, sign: int, mass: float, c: list[float]) -> float:
    if i != j:
        return sign * mass * c[i] * c[j]
    return mass * sum(x * x for index, x in enumerate(c) if index != i)


@pytest.mark.parametrize("seed", range(usually(400, 20_000)))
def test_a_digit_that_matters_is_told(seed: int) -> None:
    generator = random.Random(seed)
    numbers = random_numbers(generator)
    kindsl.mass_properties(report(numbers))
    wrong = spoiled(numbers, generator.choice(list(numbers)), generator)
    if contradicts(wrong):
        with pytest.raises(kindsl.ReportError):
            kindsl.mass_properties(report(wrong))


def test_most_digits_matter() -> None:
    generators = [random.Random(seed) for seed in range(400)]
    bodies = [(random_numbers(generator), generator) for generator in generators]
    wrong = [spoiled(numbers, generator.choice(list(numbers)), generator)
             for numbers, generator in bodies]  # fmt: skip
    assert sum(map(contradicts, wrong)) > 200
