"""The likely mistake behind an impossible inertia, and its repair."""

import random
import re
from collections.abc import Callable

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.support.bodies import (
    body_of,
    decimals,
    document_of_bodies,
    inertia_text,
    short_decimals,
    significant,
)

from kindsl.analysis.analysis import analyse
from kindsl.analysis.diagnostics import Diagnostic
from kindsl.analysis.settings import Settings
from kindsl.rigid.body import MassDistribution, shifted
from kindsl.semantics.parameters import Binding
from kindsl.text.edits import apply_edits

INERTIA = Settings(select=("KD301", "KD302", "KD306", "KD307", "KD308", "KD311"))
CAUSES = ("KD306", "KD307", "KD308")


def cloud(generator: random.Random) -> MassDistribution:
    """Return some point masses in a box of metal-like density, off the origin."""
    sides = [10.0 ** generator.uniform(-1.5, -0.3) for _ in range(3)]
    offset = [generator.uniform(-0.6, 0.6) * side for side in sides]
    count = generator.randrange(5, 30)
    points = [
        [offset[k] + generator.uniform(-0.5, 0.5) * sides[k] for k in range(3)]
        for _ in range(count)
    ]
    mass = sides[0] * sides[1] * sides[2] * 10.0 ** generator.uniform(2.3, 3.7)
    com = [sum(point[k] for point in points) / count for k in range(3)]
    spread = [
        [sum((p[i] - com[i]) * (p[j] - com[j]) for p in points) * mass / count for j in range(3)]
        for i in range(3)
    ]
    return body_of(mass, com, spread)


def few_points(generator: random.Random) -> MassDistribution:
    """Return eight equal point masses, spread and placed by the same normal distribution."""
    offset = [generator.gauss(0.0, 0.1) for _ in range(3)]
    points = [[x + generator.gauss(0.0, 0.1) for x in offset] for _ in range(8)]
    mass = generator.uniform(0.5, 10.0)
    com = [sum(point[k] for point in points) / 8 for k in range(3)]
    spread = [
        [sum((p[i] - com[i]) * (p[j] - com[j]) for p in points) * mass / 8 for j in range(3)]
        for i in range(3)
    ]
    return body_of(mass, com, spread)


def negated(body: MassDistribution) -> MassDistribution:
    ix, iy, iz, ixy, ixz, iyz = body.moments
    return body._replace(moments=(ix, iy, iz, -ixy, -ixz, -iyz))


def about_com(body: MassDistribution) -> MassDistribution:
    return shifted(body, -1.0)


def found_in(inertia: str) -> list[Diagnostic]:
    return list(analyse(document_of_bodies([inertia]), INERTIA).findings)


@pytest.mark.parametrize("make", [cloud, few_points])
@pytest.mark.parametrize(("plant", "code"), [(about_com, "KD306"), (negated, "KD307")])
def test_right_cause_comes_first(
    make: Callable[[random.Random], MassDistribution],
    plant: Callable[[MassDistribution], MassDistribution],
    code: str,
) -> None:
    generator = random.Random(f"causes {code}")
    bodies = [plant(make(generator)) for _ in range(600)]
    text = document_of_bodies([inertia_text(body, significant(6)) for body in bodies])
    found = analyse(text, INERTIA).findings
    impossible = sum(f.severity == "error" for f in found)
    named = [f.code for f in found if f.code in CAUSES]
    assert impossible > 100
    assert named.count(code) >= 0.95 * impossible
    assert len(named) <= impossible


@settings(max_examples=60, deadline=None)
@given(seed=st.integers(0, 10**9), digits=st.integers(4, 7), is_short=st.booleans())
def test_repair_of_the_reference_point_gives_the_numbers_that_were_meant(
    seed: int, digits: int, is_short: bool
) -> None:
    write = (short_decimals if is_short else decimals)(digits)
    body = cloud(random.Random(seed))
    rounded = MassDistribution(
        float(write(body.mass)), tuple(float(write(c)) for c in body.com), body.moments
    )
    meant, wrong = rounded, about_com(rounded)
    before = document_of_bodies([inertia_text(wrong, write)])
    found = [f for f in analyse(before, INERTIA).findings if f.code == "KD306"]
    assume(found and " and " not in found[0].message)
    assert found[0].fix is not None
    after = apply_edits(before, found[0].fix.edits)
    assert [f.code for f in analyse(after, INERTIA).findings if f.severity == "error"] == []
    for name, value in zip(("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz"), meant.moments, strict=True):
        text = re.search(rf"\b{name}=(\S+)", after)
        assert text is not None
        assert abs(float(text[1]) - value) <= 1.01 * 10.0**-digits
        assert len(text[1].partition(".")[2]) <= digits


def test_layout_around_the_numbers_stays() -> None:
    before = document_of_bodies(
        [
            "inertia_params {\n  mass = 2.0 // kg\n  CoM = ( 0.0,0.0 , 0.3 )\n"
            "  Ix  =  0.0150   Iy  =  0.0150 // about the CoM\n"
            "  Iz  =  0.0100   Ixy =  0.0\n  Ixz = 0.0  Iyz = 0.0\n}"
        ]
    )
    (repair,) = [f.fix for f in analyse(before, INERTIA).findings if f.code == "KD306"]
    assert repair is not None
    after = apply_edits(before, repair.edits)
    assert after == before.replace("0.0150", "0.195")


@pytest.mark.parametrize(("power", "unit"), [(9, "g·mm²"), (7, "g·cm²"), (6, "kg·mm²")])
def test_unit_is_named(power: int, unit: str) -> None:
    body = MassDistribution(0.5, (0.0, 0.0, 0.0), (0.00015, 0.00016, 0.00009, 0.0, 0.0, 0.0))
    moments = tuple(moment * 10.0**power for moment in body.moments)
    found = found_in(inertia_text(body._replace(moments=moments), significant(3)))
    assert [f.code for f in found] == ["KD308", "KD311"] or [f.code for f in found] == [
        "KD311",
        "KD308",
    ]
    (named,) = [f for f in found if f.code == "KD308"]
    assert unit in named.message
    assert named.fix is not None
    assert [edit.text for edit in named.fix.edits] == ["0.00015", "0.00016", "0.00009"]


def test_parameters_are_named_with_their_values() -> None:
    text = "inertia_params { mass = load CoM = (0.0, 0.0, 0.3) Ix=0.1 Iy=0.1 Iz=0.01"
    text = document_of_bodies([text + " Ixy=0.0 Ixz=0.0 Iyz=0.0 }"])
    light, heavy = (
        analyse(text, INERTIA._replace(bindings={"load": Binding(mass)})).findings
        for mass in (1.0, 3.0)
    )
    assert light == ()
    assert "about the CoM is -0.17 kg·m² at load = 3" in heavy[0].message


def test_two_slips_are_named_together() -> None:
    found = found_in(
        "inertia_params { mass = 2.0 CoM = (0.1, 0.0, 0.3)"
        " Ix=0.015 Iy=0.025 Iz=0.012 Ixy=0.0 Ixz=-0.0134 Iyz=0.0 }"
    )
    assert [f.code for f in found] == ["KD301"] or {f.code for f in found} & set(CAUSES)
