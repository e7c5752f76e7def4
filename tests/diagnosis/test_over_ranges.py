"""What is said of an inertia over ranges of its parameters is proved."""

import random
from itertools import product

import pytest
from tests.support.bodies import document_of_bodies

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.diagnosis.over_ranges import Conclusion, _is_proved, is_possible, over_ranges
from kindsl.language.semantics.declarations import Inertia
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import Binding

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
        assert (proof.outcome is Conclusion.IMPOSSIBLE) != all_possible
        if proof.where is not None:
            assert not is_possible(inertia, proof.where)
    assert outcomes == {Conclusion.POSSIBLE, Conclusion.IMPOSSIBLE}


def test_what_is_impossible_inside_alone_is_found_by_halving() -> None:
    section = SECTION % ("1.0", "0.0", "0.0", "c", "1.0/10.0-c*c*0.0", "0.1", "0.1", "0.0")
    inertia = inertia_of(section)
    assert over_ranges(inertia, {"c": (-0.1, 0.1)}, {"c": 0.0}).outcome is Conclusion.POSSIBLE


@pytest.mark.parametrize(
    ("iz", "outcome", "where"),
    [
        ("0.25-c*c", Conclusion.IMPOSSIBLE, {"d": 1.0, "c": -0.05}),
        ("0.25-c*c*d", Conclusion.IMPOSSIBLE, {"d": 1.0, "c": -0.05}),
        ("0.201-c*c", Conclusion.UNDECIDED, None),
        ("0.19-c*c*d", Conclusion.POSSIBLE, None),
        ("0.4-c*c", Conclusion.IMPOSSIBLE, {"d": 1.0, "c": 0.3}),
    ],
)
def test_a_range_without_extent_is_not_halved(
    iz: str, outcome: Conclusion, where: dict[str, float] | None
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
        assert not wrong or proof.outcome is Conclusion.IMPOSSIBLE
    assert outcomes == {Conclusion.POSSIBLE, Conclusion.IMPOSSIBLE}


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
        assert over_ranges(inertia, {"other": (0.0, 1.0)}, {}).outcome is Conclusion.POSSIBLE


def test_a_body_without_mass_is_impossible() -> None:
    for mass in ("0.0", "-1.0", "m"):
        inertia = inertia_of(SECTION % (mass, "0.0", "0.0", "0.0", "0.1", "0.1", "0.1", "0.0"))
        assert not is_possible(inertia, {"m": 0.0})


# Ends are 2.5, and 2 is between them, at 1: no polynomial, and worse inside than at the ends.
DIP = "(m + 1.000/m)"


@pytest.mark.parametrize(
    "numbers",
    [
        (f"5.000 - {DIP}", "0.000", "0.000", "0.1000", "0.0325", "0.0325", "0.0100", "0.0"),
        ("1.000", f"0.500 - 0.100*{DIP}", "0.000", "0.000", "0.020", "0.085", "0.085", "0.0"),
        ("1.000", "0.000", f"0.500 - 0.100*{DIP}", "0.000", "0.085", "0.020", "0.085", "0.0"),
        ("1.000", "0.000", "0.000", f"0.500 - 0.100*{DIP}", "0.085", "0.085", "0.020", "0.0"),
        ("1.000", "0.000", "0.000", "0.000", f"0.500 - 0.100*{DIP}", "0.130", "0.130", "0.0"),
        ("1.000", "0.000", "0.000", "0.000", "0.100", "0.100", "0.100", f"0.350 - 0.130*{DIP}"),
    ],
)
def test_the_corners_alone_do_not_decide_on_what_is_no_polynomial(numbers: tuple[str, ...]) -> None:
    """Each is possible at both ends of `m`, and impossible at 1.25, half way between them."""
    inertia = inertia_of(SECTION % numbers)
    assert is_possible(inertia, {"m": 0.5}) and is_possible(inertia, {"m": 2.0})
    proof = over_ranges(inertia, {"m": (0.5, 2.0)}, {})
    assert proof == (Conclusion.IMPOSSIBLE, {"m": 1.25})


PLATE = SECTION % ("1.0", "0.0", "0.0", "0.0", "a", "a", "2.0*a", "0.0")


@pytest.mark.parametrize(
    ("count", "outcome"), [(12, Conclusion.POSSIBLE), (13, Conclusion.UNDECIDED)]
)
def test_of_more_than_twelve_parameters_not_all_corners_are_tried(
    count: int, outcome: Conclusion
) -> None:
    """A plate of any size has no extent in one direction: no bounds prove it, corners do."""
    others = {f"p{n}": (0.0, 1.0) for n in range(count - 1)}
    assert over_ranges(inertia_of(PLATE), {"a": (0.1, 0.2), **others}, {}).outcome is outcome


def test_without_corners_no_mass_is_taken_to_be_possible() -> None:
    ball = SECTION % ("a", "0.0", "0.0", "0.0", "0.1", "0.1", "0.1", "0.0")
    others = {f"p{n}": (0.0, 1.0) for n in range(12)}
    proof = over_ranges(inertia_of(ball), {"a": (0.0, 1.0), **others}, {})
    assert proof.outcome is Conclusion.UNDECIDED


def test_a_mass_that_is_negative_between_is_found() -> None:
    """`(m - 0.3)^2 - 0.001` is negative within 0.032 of 0.3; halves of halves come to 0.3125."""
    ball = SECTION % ("m*m - 0.6*m + 0.089", "0.0", "0.0", "0.0", "0.1", "0.1", "0.1", "0.0")
    proof = over_ranges(inertia_of(ball), {"m": (-1.0, 1.0)}, {})
    assert proof == (Conclusion.IMPOSSIBLE, {"m": 0.3125})


def test_what_may_be_divided_by_zero_is_not_proved() -> None:
    ball = SECTION % ("1.0", "0.0", "0.0", "0.0", "0.1", "0.1", "0.1", "0.0*1.0/m")
    assert over_ranges(inertia_of(ball), {"m": (-0.3, 0.2)}, {}).outcome is Conclusion.UNDECIDED
    assert over_ranges(inertia_of(ball), {"m": (0.1, 0.2)}, {}).outcome is Conclusion.POSSIBLE


def test_the_range_that_is_halved_is_the_widest_for_what_it_was() -> None:
    """`Iz` is from 0.05 to 0.19 of at most 0.2, as bounds tell when `d` is halved once, not `c`."""
    iz = "0.050 + 875000.0*d*d + 0.0*c"
    inertia = inertia_of(SECTION % ("1.0", "0.0", "0.0", "0.0", "0.100", "0.100", iz, "0.0"))
    ranges = {"c": (-1.0, 1.0), "d": (-0.0004, 0.0003)}
    assert over_ranges(inertia, ranges, {}).outcome is Conclusion.POSSIBLE


FULL = "inertia_params {{ mass = n CoM = ({com}) Ix={} Iy={} Iz={} Ixy={} Ixz={} Iyz={} }}"


@pytest.mark.parametrize(
    ("moments", "radii", "is_proved"),
    [
        # Second moments of 0.1 each. A row's radii together are how far an eigenvalue may move.
        ("0.2 0.2 0.2 p 0.0 0.0", {"p": 0.099}, True),
        ("0.2 0.2 0.2 p 0.0 0.0", {"p": 0.101}, False),
        ("0.2 0.2 0.2 p q 0.0", {"p": 0.049, "q": 0.049}, True),
        ("0.2 0.2 0.2 p q 0.0", {"p": 0.051, "q": 0.051}, False),
        ("0.2 0.2 0.2 p 0.0 q", {"p": 0.051, "q": 0.051}, False),
        ("0.2 0.2 0.2 0.0 p q", {"p": 0.051, "q": 0.051}, False),
        # Half of what a moment varies by is how much each second moment does.
        ("0.2+d 0.2 0.2 p q 0.0", {"d": 0.1, "p": 0.024, "q": 0.024}, True),
        ("0.2+d 0.2 0.2 p q 0.0", {"d": 0.1, "p": 0.026, "q": 0.026}, False),
        ("0.2 0.2+d 0.2 p 0.0 q", {"d": 0.1, "p": 0.026, "q": 0.026}, False),
        ("0.2 0.2 0.2+d 0.0 p q", {"d": 0.1, "p": 0.026, "q": 0.026}, False),
        # Nothing is negative where an eigenvalue reaches zero and no more.
        ("0.5 0.5 0.5 p 0.0 0.0", {"p": 0.25}, True),
        # Second moments of 0.175, 0.175 and 0.025: the smallest counts.
        ("0.2 0.2 0.35 p 0.0 0.0", {"p": 0.024}, True),
        ("0.2 0.2 0.35 p 0.0 0.0", {"p": 0.026}, False),
    ],
)
def test_what_bounds_of_second_moments_prove(
    moments: str, radii: dict[str, float], is_proved: bool
) -> None:
    inertia = inertia_of(FULL.format(*moments.split(), com="0.0, 0.0, 0.0"))
    part = {name: (-radius, radius) for name, radius in radii.items()}
    assert _is_proved(inertia, part, {"n": 1.0}) == is_proved


@pytest.mark.parametrize(("mass", "is_proved"), [(0.9, True), (1.1, False)])
def test_the_mass_is_taken_at_its_greatest(mass: float, is_proved: bool) -> None:
    """A rod of 0.1 kg·m² about its end, its CoM 0.3 m away: `m c c` is at most 0.09."""
    text = FULL.format("0.1", "0.1", "0.02", "0.0", "0.0", "0.0", com="0.0, 0.0, 0.3")
    assert _is_proved(inertia_of(text), {"n": (0.8, mass)}, {}) == is_proved
