"""What a robot weighs, and whether that is all of it."""

from math import fsum

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.support.models import Style, random_model
from tests.support.robots import LIFT, ONE_LINK

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.context import ROBCOGEN2
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.text.edits import TextEdit
from kindsl.robots.mechanism.total_mass import Weight, missing_masses, total_mass, unknown_bodies

FLOATING = LIFT.replace("RobotBase base {", "RobotBase base floating {")
SECTION = LIFT[LIFT.rindex("    inertia_params") : LIFT.rindex("    children {}")]


def weighed(text: str) -> Weight:
    analysis = analyse(text)
    return total_mass(analysis.model, analysis.context.values)


def test_a_whole_robot_weighs_what_its_links_weigh():
    assert weighed(LIFT) == Weight(3.0)
    assert weighed(LIFT).is_whole


@pytest.mark.parametrize("text", [LIFT.replace("mass = 1.0", "mass = m[1.0]"), LIFT])
def test_a_parameter_with_a_value_is_a_mass(text):
    assert weighed(text) == Weight(3.0)


@pytest.mark.parametrize(
    ("text", "known", "reason"),
    [
        (LIFT.replace("mass = 1.0", "mass = x"), 2.0, "the parameter 'x' has no value"),
        (LIFT.replace("mass = 1.0", "mass = -1.0"), 2.0, "mass of 'slider' is negative"),
        (LIFT.replace("mass = 1.0", "mass = <c>"), 2.0, "the constant 'c' has no value"),
        (LIFT.replace("mass = 1.0", "mass = "), 2.0, "link 'slider' has no mass"),
        (LIFT.replace("        mass = 1.0\n", ""), 2.0, "link 'slider' has no mass"),
        (LIFT.replace(SECTION, ""), 2.0, "link 'slider' has no mass"),
        (LIFT.replace("mass = 1.0", "mass = 1.0/0.0"), 2.0, "mass of 'slider' is not a number"),
        (LIFT.replace("mass = 1.0", "mass = 1.0 *"), 2.0, "mass of 'slider' is not a number"),
        (LIFT.replace("link slider", "link other"), 3.0, "there is no link 'slider'"),
        (LIFT.replace("slider via lift", "via lift"), 3.0, "joint 'lift' has no link"),
        (FLOATING, 3.0, "base 'base' has no mass"),
        (LIFT[: LIFT.index("RobotBase")] + LIFT[LIFT.index("link") :], 3.0, "there is no base"),
    ],
)
def test_what_is_missing_is_told(text, known, reason):
    found = weighed(text)
    assert (found.known, found.is_whole) == (known, False)
    assert found.plain_reason == reason


def test_a_fixed_base_weighs_nothing_whatever_is_written():
    for mass in ("7.0", "x", ""):
        text = LIFT.replace("base {\n", f"base {{\n inertia_params {{ mass = {mass} }}\n", 1)
        assert weighed(text) == Weight(3.0)


def test_everything_that_is_missing_is_listed():
    text = LIFT.replace("mass = 1.0", "mass = x").replace("mass = 2.0", "mass = 2.0 +")
    analysis = analyse(text)
    missing = missing_masses(analysis.model, analysis.context.values)
    assert [owner for owner, _ in missing] == ["upper", "slider"]
    found = weighed(text)
    assert (found.known, found.n_missing) == (0.0, 2)
    assert found.plain_reason == "mass of 'upper' is not a number; 1 more missing"


@pytest.mark.parametrize(
    ("weight", "told"),
    [
        (Weight(2.0), "2 kg"),
        (Weight(2.0, 1, Unknown("r")), "at least 2 kg"),
        (Weight(0.0, 1, Unknown("r")), "unknown"),
        (Weight(0.0), "0 kg"),
        (Weight(-1.0, 1, Unknown("r")), "unknown"),
    ],
)
def test_a_part_never_reads_like_the_whole(weight, told):
    assert weight.in_words(f"{weight.known:g} kg") == told


@given(st.integers(0, 500), st.data())
def test_each_lost_mass_makes_a_part_of_the_whole(seed, data):
    """Whichever masses are taken away: the sum is that of the others, and as many are missing."""
    analysis = analyse(random_model(6, seed, Style(has_expressions=False)))
    masses = [body.inertia.mass for body in analysis.model.bodies]
    lost = data.draw(st.sets(st.sampled_from(masses)))
    kept = fsum(mass.value({}) for mass in masses if mass not in lost)
    edits = [TextEdit(*analysis.resolver.span(mass), "unbound_mass") for mass in lost]
    edits.sort(key=lambda edit: edit.start)
    analysis = analysis.edited(edits)
    found = total_mass(analysis.model, analysis.context.values)
    assert found.known == pytest.approx(kept)
    assert found.n_missing == len(lost)
    assert len(missing_masses(analysis.model, analysis.context.values)) == len(lost)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("mass = 1.0", "mass = x"),
        ("(0.0, 0.0, 0.1)", "(0.0, 0.0, x)"),
        ("Ix = 0.02", "Ix = x"),
        ("        Ix = 0.02\n", ""),
        (SECTION, ""),
    ],
)
def test_a_body_is_known_only_as_a_whole(old, new):
    analysis = analyse(LIFT.replace(old, new))
    assert set(unknown_bodies(analysis.model, {})) == {"slider"}
    assert unknown_bodies(analyse(LIFT).model, {}) == {}


@pytest.mark.parametrize("written", ["1.0e3", "+1.0e3"])
def test_a_mass_that_is_read_in_two_ways_is_told_as_such(written: str) -> None:
    text = ONE_LINK.replace("mass = m", f"mass = {written}")
    for targets, whole in ((frozenset[str](), False), (frozenset({ROBCOGEN2}), True)):
        analysis = analyse(text, Settings(targets=targets))
        weight = total_mass(analysis.model, {})
        assert weight.is_whole is whole
        assert weight.plain_reason == ("" if whole else f"'{written}' is read in two ways")
