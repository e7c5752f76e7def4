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
from tests.support.examples import joint, link, robot
from tests.support.one_rule import found, row

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.diagnosis import judge
from kindsl.judgement.rules.inertia import repairs
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.edits import TextEdit, apply_edits
from kindsl.mechanics.rigid.body import MassDistribution, shifted

INERTIA = Settings(select=("KD301", "KD302", "KD306", "KD307", "KD308", "KD311"))
ROD = (0.05, 0.06, 0.09)
CAUSES = ("KD306", "KD307", "KD308")
CAUSES_ONLY = Settings(select=CAUSES)
LIGHT = "inertia_params { mass = 0.02 CoM = (0.0, 0.0, 0.0) Ix=60.0 Iy=55.0"
LIGHT += " Iz=20.0 Ixy=0.0 Ixz=0.0 Iyz=0.0 }"


def arm_with(inertia: str, length: float) -> str:
    """Return an arm whose first link has an inertia and is so long."""
    links = link("upper", 1, "lower via elbow", inertia), link("lower", 2)
    return robot(*links, joint("shoulder"), joint("elbow", length), base="upper via shoulder")


UPPER, LOWER = (
    f"inertia_params {{ mass = {mass} CoM = (0.0, 0.0, 0.3)"
    " Ix=0.020 Iy=0.020 Iz=0.002 Ixy=0.0 Ixz=0.0 Iyz=0.0 }"
    for mass in ("2.0", "2.1")
)


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


def along_axes(generator: random.Random) -> MassDistribution:
    """Return a box of metal along the axes, off the origin."""
    sides = [10.0 ** generator.uniform(-1.2, -0.5) for _ in range(3)]
    mass = sides[0] * sides[1] * sides[2] * 10.0 ** generator.uniform(2.8, 3.7)
    spread = [[mass * sides[i] ** 2 / 12 * (i == j) for j in range(3)] for i in range(3)]
    return body_of(mass, [generator.choice((-0.6, 0.6)) * side for side in sides], spread)


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
    bodies = [plant(make(generator)) for _ in range(150)]
    found = [found_in(inertia_text(body, significant(6))) for body in bodies]
    impossible = sum(any(f.severity == "error" for f in of_body) for of_body in found)
    named = [f for of_body in found for f in of_body if f.code in CAUSES]
    assert impossible > 30
    assert sum(f.code == code for f in named) >= 0.85 * impossible
    assert len(named) <= impossible


@pytest.mark.parametrize(("plant", "code"), [(about_com, "KD306"), (negated, "KD307")])
def test_fix_that_is_offered_is_right(
    plant: Callable[[MassDistribution], MassDistribution], code: str
) -> None:
    generator = random.Random(f"fixes {code}")
    n_offered = n_right = 0
    for _ in range(60):
        meant = cloud(generator)
        before = document_of_bodies([inertia_text(plant(meant), significant(6))])
        fixes = [f.fix for f in analyse(before, INERTIA).findings if f.fix and f.code in CAUSES]
        if fixes:
            n_offered += 1
            after = moments_in(apply_edits(before, fixes[0].edits))
            size = 0.01 * max(meant.moments)
            n_right += all(abs(a - b) < size for a, b in zip(after, meant.moments, strict=True))
    assert n_offered > 0
    assert n_right >= 0.95 * n_offered


def moments_in(text: str) -> list[float]:
    names = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")
    found = (re.search(rf"\b{name}=(\S+)", text) for name in names)
    return [float(match[1]) for match in found if match is not None]


@pytest.mark.parametrize(("plant", "code"), [(about_com, "KD306"), (negated, "KD307")])
def test_slip_that_every_body_shows_is_told_once_and_mended_at_once(
    plant: Callable[[MassDistribution], MassDistribution], code: str
) -> None:
    generator = random.Random("one author")
    bodies: list[MassDistribution] = []
    while len(bodies) < 5:
        body = cloud(generator)
        found = found_in(inertia_text(plant(body), significant(6)))
        if any(f.code == code and f.fix for f in found):
            bodies.append(body)
    before = document_of_bodies([inertia_text(plant(b), significant(6)) for b in bodies])
    (told,) = [f for f in analyse(before, INERTIA).findings if f.code in CAUSES]
    assert told.code == code
    assert len(told.related) == 4
    assert told.fix is not None
    assert analyse(apply_edits(before, told.fix.edits), INERTIA).findings == ()


def test_other_links_tell_which_of_two_causes_it_is() -> None:
    either = "inertia_params { mass = 5.59 CoM = (-0.0732, -0.048, -0.0355) Ix=0.0359"
    either += " Iy=0.0515 Iz=0.0712 Ixy=0.00412 Ixz=0.00285 Iyz=-0.000658 }"
    good = "inertia_params { mass = 2.0 CoM = (0.0, 0.0, 0.3) Ix=0.2 Iy=0.201"
    good += " Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0 }"
    alone = analyse(document_of_bodies([either, good]), INERTIA).findings
    assert [f.fix for f in alone if f.code in CAUSES] == [None]
    rods = [
        body_of(m, [0.1, 0.12, 0.2], [[m * x * y for x in ROD] for y in ROD]) for m in range(1, 5)
    ]
    clear = [inertia_text(about_com(rod), significant(5)) for rod in rods]
    together = analyse(document_of_bodies([either, *clear, good]), INERTIA).findings
    assert next(f for f in together if f.code == "KD306").fix is not None


def test_twin_is_evidence() -> None:
    leg = (
        "inertia_params { mass = 2.16 CoM = ( 0.14796, %s, 0.0) Ix=0.004785 Iy=0.076166"
        " Iz=0.078576 Ixy=%s Ixz=0.0 Iyz=0.0 }"
    )
    good, bad = leg % ("-0.02958", "-0.0071588"), leg % ("0.02958", "-0.0071588")
    text = document_of_bodies([bad, good])
    text = text.replace("body1", "LH_leg").replace("body2", "RH_leg")
    (told,) = [f for f in analyse(text, INERTIA).findings if f.code in CAUSES]
    assert "y of the CoM" in told.message
    assert any("sign of Ixy" in related.message for related in told.related)
    assert "equal to 'RH_leg'" in told.message
    assert told.fix is None


def test_few_digits_of_the_com_excuse_nothing() -> None:
    arm = "inertia_params { mass = 2.0 CoM = (0.0, 0.0, %s) Ix=0.012 Iy=0.012 Iz=0.002"
    arm += " Ixy=0.0 Ixz=0.0 Iyz=0.0 }"
    few, many = found_in(arm % "0.1"), found_in(arm % "0.10")
    assert [(f.code, str(f.severity)) for f in few] == [("KD301", "warning"), ("KD306", "info")]
    assert [(f.code, str(f.severity)) for f in many] == [("KD301", "error"), ("KD306", "info")]
    assert few[1].fix == many[1].fix or few[1].fix is not None


@pytest.mark.parametrize("write", [significant(3), decimals(4), short_decimals(5)])
def test_no_fix_leads_into_another_rule(write: Callable[[float], str]) -> None:
    generator = random.Random("no rule after a rule")
    for _ in range(60):
        plant = generator.choice((about_com, negated))
        before = document_of_bodies([inertia_text(plant(cloud(generator)), write)])
        found = analyse(before, INERTIA).findings
        for fix in [f.fix for f in found if f.fix is not None]:
            rest = analyse(apply_edits(before, fix.edits), INERTIA).findings
            assert not [f for f in rest if f.severity in ("error", "warning")]


@pytest.mark.parametrize(
    ("targets", "is_fixed"), [((), True), (("robcogen",), True), (("robcogen2",), False)]
)
def test_no_fix_for_robcogen2_writes_what_it_treats_as_zero(
    targets: tuple[str, ...], is_fixed: bool
) -> None:
    causes = Settings(frozenset(targets), select=("KD308",))
    text = arm_with(LIGHT.replace("Ix=60.0 Iy=55.0 Iz=20.0", "Ix=6000.0 Iy=5500.0 Iz=2000.0"), 0.06)
    (found,) = analyse(text, causes).findings
    assert "the moments were in g·mm²" in found.message
    assert (found.fix is not None) == is_fixed


@pytest.mark.parametrize("first", [{"robcogen"}, {"robcogen2"}])
def test_a_fix_follows_the_targets(first: set[str]) -> None:
    analysis = analyse(document_of_bodies([LIGHT]), Settings(frozenset(first)))
    assert "KD308" in {finding.code for finding in analysis.findings}
    others = Settings(frozenset({"robcogen", "robcogen2"} - first))
    assert analysis.with_settings(others).findings == analyse(analysis.text, others).findings


def test_a_message_follows_values_that_change_no_number() -> None:
    text = UPPER.replace("Ixy=0.0", "Ixy=0.0 * load")
    one, other = (Settings(select=CAUSES, bindings={"load": Binding(load)}) for load in (1.0, 2.0))
    analysis = analyse(document_of_bodies([text]), one)
    assert "at load = 1" in analysis.findings[0].message
    assert "at load = 2" in analysis.with_settings(other).findings[0].message


@settings(max_examples=60, deadline=None)
@given(seed=st.integers(0, 10**9), digits=st.integers(4, 7), is_short=st.booleans())
def test_repair_of_the_reference_point_gives_the_numbers_that_were_meant(
    seed: int, digits: int, is_short: bool
) -> None:
    write = (short_decimals if is_short else decimals)(digits)
    body = along_axes(random.Random(seed))
    rounded = MassDistribution(
        float(write(body.mass)), tuple(float(write(c)) for c in body.com), body.moments
    )
    meant, wrong = rounded, about_com(rounded)
    before = document_of_bodies([inertia_text(wrong, write)])
    found = [f for f in analyse(before, INERTIA).findings if f.code == "KD306"]
    assume(found and found[0].fix is not None and " and the signs" not in found[0].message)
    assert found[0].fix is not None
    after = apply_edits(before, found[0].fix.edits)
    assert [f.code for f in analyse(after, INERTIA).findings if f.severity == "error"] == []
    for name, value in zip(("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz"), meant.moments, strict=True):
        text = re.search(rf"\b{name}=(\S+)", after)
        assert text is not None
        assert abs(float(text[1]) - value) <= 1.01 * 10.0**-digits
        assert len(text[1].partition(".")[2]) <= digits


def test_layout_around_the_numbers_stays() -> None:
    before = arm_with(
        "inertia_params {\n  mass = 2.0 // kg\n  CoM = ( 0.0,0.0 , 0.3 )\n"
        "  Ix  =  0.0150   Iy  =  0.0150 // about the CoM\n"
        "  Iz  =  0.0100   Ixy =  0.0\n  Ixz = 0.0  Iyz = 0.0\n}",
        0.6,
    )
    (repair,) = [f.fix for f in analyse(before, INERTIA).findings if f.code == "KD306"]
    assert repair is not None
    after = apply_edits(before, repair.edits)
    assert after == before.replace("0.0150", "0.195")


@pytest.mark.parametrize(("power", "unit"), [(9, "g·mm²"), (7, "g·cm²"), (6, "kg·mm²")])
def test_unit_is_named(power: int, unit: str) -> None:
    body = MassDistribution(0.5, (0.0, 0.0, 0.0), (0.0003, 0.00032, 0.00018, 0.0, 0.0, 0.0))
    moments = tuple(moment * 10.0**power for moment in body.moments)
    found = found_in(inertia_text(body._replace(moments=moments), significant(3)))
    (named,) = found
    assert (named.code, named.severity) == ("KD308", "warning")
    assert "implies a density of" in named.message
    assert unit in named.message
    assert named.fix is None or [edit.text for edit in named.fix.edits] == [
        "0.0003",
        "0.00032",
        "0.00018",
    ]


def test_parameters_are_named_with_their_values() -> None:
    text = "inertia_params { mass = load CoM = (0.0, 0.0, 0.3) Ix=0.1 Iy=0.1 Iz=0.01"
    text = document_of_bodies([text + " Ixy=0.0 Ixz=0.0 Iyz=0.0 }"])
    light, heavy = (
        analyse(text, INERTIA._replace(bindings={"load": Binding(mass)})).findings
        for mass in (1.0, 3.0)
    )
    assert light == ()
    assert "about the CoM is -0.17 kg·m² at load = 3" in heavy[0].message


def test_moments_that_were_computed_for_one_load_are_no_slip_at_another() -> None:
    text = "inertia_params { mass = load CoM = (0.0, 0.0, 0.1) Ix=0.21 Iy=0.21 Iz=0.06"
    text = document_of_bodies([text + " Ixy=0.0 Ixz=0.0 Iyz=0.0 }"])
    found = analyse(text, Settings(bindings={"load": Binding(60.0)})).findings
    assert {f.code for f in found if f.code.startswith("KD3")} == {"KD301"}
    assert "KD405" in {f.code for f in found}


def test_two_slips_are_named_together() -> None:
    found = found_in(
        "inertia_params { mass = 2.0 CoM = (0.1, 0.0, 0.3)"
        " Ix=0.015 Iy=0.025 Iz=0.012 Ixy=0.0 Ixz=-0.0134 Iyz=0.0 }"
    )
    assert [f.code for f in found] == ["KD301"] or {f.code for f in found} & set(CAUSES)


ARM = robot(
    link("upper", 1, "lower via elbow", UPPER),
    link("lower", 2, inertia=LOWER),
    *(joint("shoulder", 0.5), joint("elbow", 0.7)),
    base="upper via shoulder",
)


@pytest.fixture
def judged(monkeypatch):
    """Return the names of the steps of judging causes, as they are taken."""
    steps: list[str] = []

    def watch(module, name):
        step = getattr(module, name)
        monkeypatch.setattr(module, name, lambda *given: steps.append(name) or step(*given))

    watch(judge, "candidates")
    watch(judge, "ranked")
    watch(repairs, "likely_cause")
    return steps


@pytest.mark.parametrize(
    ("old", "new", "anew"),
    [
        ("Robot Arm", "Robot Leg", (0, 0, 0)),
        ("0.5", "0.6", (0, 0, 0)),
        ("r_joint elbow {", "r_joint elbow { id = 7", (0, 0, 0)),
        ("0.7", "0.8", (1, 1, 1)),
        ("mass = 2.1", "mass = 2.2", (1, 2, 2)),
        ("mass = 2.1", "mass = 0.1", (0, 1, 1)),
    ],
)
def test_a_keystroke_judges_only_bodies_that_it_says_something_of(judged, old, new, anew):
    analysis = analyse(ARM, CAUSES_ONLY)
    assert [finding.code for finding in analysis.findings].count("KD306") == 2
    judged.clear()
    at = analysis.text.index(old)
    analysis.edited([TextEdit(at, at + len(old), new)]).findings  # noqa: B018
    assert tuple(map(judged.count, ("candidates", "ranked", "likely_cause"))) == anew


def test_copies_of_a_body_are_tried_together(judged):
    links = (link("upper", 1, inertia=UPPER), link("lower", 2, inertia=UPPER))
    found = analyse(robot(*links, joints="last")).findings
    assert [finding.code for finding in found].count("KD306") == 2
    assert judged.count("candidates") == 1


ARM_OF_A_ROBOT = "inertia_params { mass = 2.0 CoM = (0.02, 0.01, 0.3) Ix=%s Iy=%s Iz=%s"
ARM_OF_A_ROBOT += " Ixy=0.00040 Ixz=0.01200 Iyz=0.00600 }"


@pytest.mark.parametrize("place", range(3))
def test_a_stray_minus_is_named(place: int) -> None:
    moments = ["0.24140", "0.24160", "0.00310"]
    meant = document_of_bodies([ARM_OF_A_ROBOT % tuple(moments)])
    moments[place] = f"-{moments[place]}"
    text = document_of_bodies([ARM_OF_A_ROBOT % tuple(moments)])
    (named,) = [f for f in analyse(text, INERTIA).findings if f.code in CAUSES]
    assert f"the sign of {('Ix', 'Iy', 'Iz')[place]} were changed" in named.message
    assert named.fix is None or apply_edits(text, named.fix.edits) == meant


def test_moments_of_about_one_number_are_a_placeholder_and_no_unit() -> None:
    gripper = "inertia_params { mass = 0.99 CoM = (0.0, 0.0, 0.0) Ix=0.163 Iy=0.163 Iz=0.165"
    text = document_of_bodies([f"{gripper} Ixy=0.0 Ixz=0.0 Iyz=0.0 }}"])
    found = [f for f in analyse(text).findings if f.code.startswith("KD3")]
    assert [(f.code, f.fix) for f in found] == [("KD310", None)]
    assert "Ix, Iy and Iz are all about 0.163" in found[0].message


def test_a_round_number_of_any_size_is_a_placeholder_and_no_unit() -> None:
    leg = "inertia_params { mass = 0.1 CoM = (0.0, 0.0, 0.0) Ix=100.0 Iy=100.0 Iz=100.0"
    text = document_of_bodies([f"{leg} Ixy=0.0 Ixz=0.0 Iyz=0.0 }}"])
    (found,) = [f for f in analyse(text).findings if f.code in (*CAUSES, "KD310")]
    assert (found.code, found.fix) == ("KD310", None)
    assert "Ix, Iy and Iz are all 100" in found.message


def test_a_round_number_greater_than_any_link_s_is_in_another_unit() -> None:
    leg = "inertia_params { mass = 1.2 CoM = (0.0, 0.0, 0.0) Ix=3000.0 Iy=3000.0 Iz=3000.0"
    text = document_of_bodies([f"{leg} Ixy=0.0 Ixz=0.0 Iyz=0.0 }}"])
    (found,) = [f for f in analyse(text).findings if f.code in (*CAUSES, "KD310")]
    assert (found.code, "kg·mm²" in found.message) == ("KD308", True)


def test_no_cause_leaves_of_no_matter_a_body_whose_only_fault_is_that() -> None:
    """A finger's link of 0.2 kg in kg·mm²; in kg·cm² it would be a hundred times too light."""
    moments = "Ix=353.333 Iy=353.333 Iz=53.3333 Ixy=0.0 Ixz=0.0 Iyz=0.0"
    text = row(f"inertia_params {{ mass = 0.2 CoM = (0.0, 0.0, 0.06) {moments} }}", names="finger")
    (finding,) = found("KD308", text)
    assert "if the moments were in kg·mm² and the moments were taken about the" in finding.message
    assert not any("kg·cm²" in each.message for each in (finding, *finding.related))


FAR = """Robot Arm {
RobotBase ground { children { upper via shoulder } }
link upper { id = 1
    inertia_params { mass = 2.0 CoM = (0.0, 0.0, 0.2)
        Ix=%s Iy=%s Iz=0.0031 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children { %s } }
link lower { id = 2 children {} }
r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
r_joint elbow { ref_frame { translation = (0.0, 0.0, 0.4) rotation = (0.0, 0.0, 0.0) } }
}
"""
MARKED = "} frames { head { translation = (0.0, 0.0, 0.4) rotation = (0.0, 0.0, 0.0) }"


@pytest.mark.parametrize(
    ("moment", "below", "is_told"),
    [
        ("0.1082", "lower via elbow", False),
        ("0.1882", "lower via elbow", True),
        # A thing with places marked on it, which carries nothing, may have any shape.
        ("0.1882", MARKED, False),
    ],
)
def test_a_possible_body_that_reaches_far_beyond_its_joint(
    moment: str, below: str, is_told: bool
) -> None:
    """A rod of 0.4 m from joint to joint has `m c^2` but once: 0.0282 and 2 * 0.04 kg·m²."""
    told = [f for f in analyse(FAR % (moment, moment, below)).findings if f.code == "KD306"]
    assert len(told) == is_told
    for finding in told:
        assert "describes a body about 0.8 m long and would" in finding.message
        assert "shifted to the frame origin once, not twice" in finding.message
        # One body that is possible is a doubt, no conviction.
        assert finding.probability is not None and 0.5 < finding.probability < 0.9
        assert finding.severity == "hint"


@pytest.mark.parametrize(("name", "typed"), [("Ix", "0.09528"), ("Iy", "0.08528")])
def test_a_digit_that_was_lost_where_a_body_is_round_is_put_back(name: str, typed: str) -> None:
    """The third moment times ten would make the body possible as well."""
    moments = "Ix=0.098528 Iy=0.098528 Iz=0.00285 Ixy=0.0 Ixz=0.0 Iyz=0.0"
    meant, wrong = (
        row(f"inertia_params {{ mass = 1.714 CoM = (0.0, 0.0, 0.19) {each} }}", names="rod")
        for each in (moments, moments.replace(f"{name}=0.098528", f"{name}={typed}"))
    )
    (finding,) = (f for code in CAUSES for f in found(code, wrong))
    assert f"would be consistent if {name} were 0.09853 (" in finding.message
    assert finding.fix is not None
    assert apply_edits(wrong, finding.fix.edits) == meant
