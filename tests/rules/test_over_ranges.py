"""What is said of an inertia over ranges of its parameters is proved."""

import random
from itertools import product

import pytest
from tests.support.bodies import document_of_bodies

from kindsl.analysis.analysis import analyse
from kindsl.analysis.settings import Settings
from kindsl.rules.inertia.over_ranges import Outcome, is_possible, over_ranges
from kindsl.semantics.declarations import Inertia
from kindsl.semantics.model import Model
from kindsl.semantics.parameters import Binding

SECTION = "inertia_params { mass = %s CoM = (%s, %s, %s) Ix=%s Iy=%s Iz=%s Ixy=%s Ixz=0.0 Iyz=0.0 }"
TEN = tuple(f"p{n}" for n in range(10))


def inertia_of(section: str) -> Inertia:
    model = analyse(document_of_bodies([section])).model
    assert isinstance(model, Model)
    inertia = model.links[0].inertia
    assert inertia is not None
    return inertia


def test_affine_parameters_are_decided_at_the_corners() -> None:
    generator = random.Random("corners")
    outcomes = set()
    for _ in range(40):
        section = SECTION % ("m", "0.1", "0.0", "c", "a", "b", "0.3", "0.01")
        middle = {"m": 1.0, "c": 0.1, "a": 0.4, "b": 0.4}
        width = generator.uniform(0.02, 0.5)
        ranges = {name: (v * (1 - width), v * (1 + width)) for name, v in middle.items()}
        inertia = inertia_of(section)
        proof = over_ranges(inertia, ranges, middle)
        outcomes.add(proof.outcome)
        grid = product(*((low, 0.5 * (low + high), high) for low, high in ranges.values()))
        all_possible = all(is_possible(inertia, dict(zip(ranges, v, strict=True))) for v in grid)
        assert (proof.outcome is Outcome.IMPOSSIBLE) != all_possible
        if proof.where is not None:
            assert not is_possible(inertia, proof.where)
    assert outcomes == {Outcome.POSSIBLE, Outcome.IMPOSSIBLE}


def test_what_is_impossible_inside_alone_is_found_by_halving() -> None:
    section = SECTION % ("1.0", "0.0", "0.0", "c", "1.0/10.0-c*c*0.0", "0.1", "0.1", "0.0")
    inertia = inertia_of(section)
    assert over_ranges(inertia, {"c": (-0.1, 0.1)}, {"c": 0.0}).outcome is Outcome.POSSIBLE


@pytest.mark.parametrize(
    ("iz", "outcome", "where"),
    [
        ("0.25-c*c", Outcome.IMPOSSIBLE, {"d": 1.0, "c": -0.05}),
        ("0.25-c*c*d", Outcome.IMPOSSIBLE, {"d": 1.0, "c": -0.05}),
        ("0.201-c*c", Outcome.UNDECIDED, None),
        ("0.19-c*c*d", Outcome.POSSIBLE, None),
        ("0.4-c*c", Outcome.IMPOSSIBLE, {"d": 1.0, "c": 0.3}),
    ],
)
def test_a_range_without_extent_is_not_halved(
    iz: str, outcome: Outcome, where: dict[str, float] | None
) -> None:
    inertia = inertia_of(SECTION % ("1.000", "0.0", "0.0", "0.0", "0.100", "0.100", iz, "0.0"))
    proof = over_ranges(inertia, {"d": (1.0, 1.0), "c": (-0.4, 0.3)}, {})
    assert proof == (outcome, where if where is None else pytest.approx(where))


@pytest.mark.parametrize("place", range(6))
def test_what_is_proved_possible_is_so_everywhere(place: int) -> None:
    """Where one moment varies with the square of a parameter, in whichever place."""
    generator = random.Random(f"squares {place}")
    outcomes = set()
    for _ in range(12):
        moments = ["0.200", "0.200", "0.200", "0.000", "0.000", "0.000"]
        width = generator.uniform(0.1, 0.75)
        moments[place] += f"+c*c*{generator.choice((0.5, -0.5, 0.9)):.1f}"
        names = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")
        told = " ".join(f"{n}={v}" for n, v in zip(names, moments, strict=True))
        inertia = inertia_of(f"inertia_params {{ mass = 1.000 CoM = (0.0, 0.0, 0.0) {told} }}")
        proof = over_ranges(inertia, {"c": (-width, width)}, {})
        outcomes.add(proof.outcome)
        grid = [width * (k / 50.0 - 1.0) for k in range(101)]
        wrong = [c for c in grid if not is_possible(inertia, {"c": c})]
        assert not wrong or proof.outcome is Outcome.IMPOSSIBLE
    assert outcomes == {Outcome.POSSIBLE, Outcome.IMPOSSIBLE}


def test_ten_ranges_are_no_hindrance() -> None:
    mass, x, y, z, ix, iy, iz, ixy, *_ = TEN
    section = SECTION % (mass, x, y, z, ix, iy, iz, ixy)
    values = dict(zip(TEN, (1.0, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.01, 0.0, 0.0), strict=True))
    bindings = {n: Binding(v, v - 0.05, v + 0.05) for n, v in values.items() if v}
    found = analyse(document_of_bodies([section]), Settings(bindings=bindings)).findings
    (told,) = [f for f in found if f.code == "KD411"]
    assert "physically impossible at p0 = " in told.message


def test_what_is_not_known_is_not_called_impossible() -> None:
    for place in range(8):
        written = ["1.0", "0.0", "0.0", "0.0", "0.1", "0.1", "0.1", "0.0"]
        written[place] = "unbound"
        inertia = inertia_of(SECTION % tuple(written))
        assert is_possible(inertia, {})
        assert over_ranges(inertia, {"other": (0.0, 1.0)}, {}).outcome is Outcome.POSSIBLE


def test_a_body_without_mass_is_impossible() -> None:
    for mass in ("0.0", "-1.0", "m"):
        inertia = inertia_of(SECTION % (mass, "0.0", "0.0", "0.0", "0.1", "0.1", "0.1", "0.0"))
        assert not is_possible(inertia, {"m": 0.0})
