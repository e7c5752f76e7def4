"""What is told of limbs (KD208 to KD210, KD509, KD510), with which fixes, and what it costs."""

from collections.abc import Iterator
from itertools import product
from math import cos, pi, radians, sin
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
from tests.support.examples import STEEL_BALL, four_legs, link, placed_joint, robot, two_arms
from tests.support.one_rule import found, section, told
from tests.support.published import CORPUS, published, published_model

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.diagnosis.body_verdicts import BodyVerdict
from kindsl.judgement.diagnosis.judgements import keyword
from kindsl.judgement.rules import limb_verdicts
from kindsl.judgement.rules.base import Finding
from kindsl.judgement.rules.checks import kd312_mirrored_pair_differs
from kindsl.judgement.rules.inertia import shapes
from kindsl.judgement.rules.inertia.shapes import shape_verdicts
from kindsl.judgement.rules.limb_attachments import crossed_findings, elsewhere_findings
from kindsl.judgement.rules.limb_writing import retyped
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.semantics.places import Located
from kindsl.language.text.edits import TextEdit, apply_edits
from kindsl.robots.limbs.attachments import Attachment, Misplaced
from kindsl.robots.limbs.limb import Limbs
from kindsl.robots.limbs.verdicts import ComparedLimbs, verdicts
from kindsl.robots.limbs.weighing import LimbVerdict, Masses

CODES = ("KD208", "KD209", "KD210", "KD509", "KD510")
ZERO = "0.0, 0.0, 0.0"
FIXTURES = Path(__file__).parents[1] / "fixtures"
THIGH = "0.08, 0.0, 0.0"


def codes(text: str) -> list[str]:
    return [finding.code for finding in analyse(text).findings if finding.code in CODES]


@pytest.mark.parametrize(
    ("numbers", "fixed"),
    [
        ("0.8, 0.0, 0.0", THIGH),
        ("-0.08, 0.0, 0.0", THIGH),
        ("0.0, 0.08, 0.0", THIGH),
        ("0.0, 0.0, 0.0", THIGH),
        ("0.09, 0.0, 0.0", THIGH),
    ],
)
@pytest.mark.parametrize("leg", ["LF", "RF", "LH", "RH"])
def test_one_leg_differs_from_three(leg: str, numbers: str, fixed: str) -> None:
    text = four_legs(**{leg: numbers})
    (finding,) = found("KD509", text)
    assert finding.message == f"translation of '{leg}_HFE' is ({numbers}), by its twins ({fixed})"
    assert len(finding.related) == 2
    assert all("translation of" in related.message for related in finding.related)
    assert finding.fix is not None and not finding.fix.is_safe
    assert apply_edits(text, finding.fix.edits) == four_legs()


@pytest.mark.parametrize("number", ["0.8\u00a0", "0.0\u00a08", "\u00a00.8"])
def test_a_number_in_broken_text_is_left_to_the_rules_of_syntax(number: str) -> None:
    """A fix that writes another number, and one that reads this one, would contradict."""
    for text in (four_legs(RH=f"{number}, 0.0, 0.0"), two_arms(f"{number}, -0.1, 0.02")):
        assert codes(text) == []
        assert any(finding.code.startswith("KD0") for finding in analyse(text).findings)


def test_a_leg_that_is_up_at_its_zero_is_left_in_peace() -> None:
    """Some ways to read it agree that its thigh is half a turn off, but none of the cheapest."""
    assert codes((FIXTURES / "robots" / "leg_up.kindsl").read_text()) == []


@pytest.mark.parametrize(
    ("one", "other", "message", "n_choices"),
    [
        (
            *("right_forearm via right_elbow", "right_wrist via right_roll"),
            "link 'left_forearm' moves by joint 'left_elbow', 'right_forearm' by 'right_roll': "
            "the joints of one of the two sides are exchanged",
            2,
        ),
        (
            *("left_wrist via left_roll", "right_wrist via right_roll"),
            "link 'left_wrist' moves by joint 'right_roll', by its name by 'left_roll'",
            0,
        ),
    ],
)
def test_exchanged_joints_are_told_once(one: str, other: str, message: str, n_choices: int) -> None:
    text = two_arms("0.3, -0.1, 0.02")
    (here, mine), (there, his) = (each.split(" via ") for each in (one, other))
    spoilt = text.replace(one, f"{here} via {his}").replace(other, f"{there} via {mine}")
    (finding,) = found("KD209", spoilt)
    assert finding.message == message
    fixes = [fix for fix in (finding.fix, *finding.choices) if fix is not None]
    assert len(finding.choices) == n_choices
    assert text in [apply_edits(spoilt, fix.edits) for fix in fixes]


def test_front_and_hind_legs_may_differ() -> None:
    assert codes(four_legs(LH="0.1, 0.0, 0.0", RH="0.1, 0.0, 0.0")) == []


def test_a_fix_is_written_in_the_words_of_the_twins() -> None:
    text = four_legs(
        LF="hip, 0.0, 0.0", RF="hip, 0.0, 0.0", LH="hip, 0.0, 0.0", RH="-hip, 0.0, 0.0"
    )
    for values in ({}, {"hip": 0.08}):
        (finding,) = found("KD509", text, **values)
        assert finding.message == (
            "translation of 'RH_HFE' is (-hip, 0.0, 0.0), by its twins (hip, 0.0, 0.0)"
        )
        assert finding.fix is not None
        assert apply_edits(text, finding.fix.edits) == text.replace("-hip", "hip")


def test_parameters_are_compared_by_their_names() -> None:
    """What is equal at the values given is no slip; nor is what is equal by chance."""
    same = dict.fromkeys(("LF", "RF", "LH"), "hip, 0.0, 0.0")
    assert told("KD509", four_legs(**same, RH="thigh, 0.0, 0.0"), hip=0.08, thigh=0.08) == []
    assert told("KD509", four_legs(**same, RH="hip, 0.0, 0.0")) == []


def test_angles_are_written_as_fractions_of_pi() -> None:
    text = four_legs()
    first = text.index("PI/2.0, 0.0, 0.0", text.index("r_joint RF_HFE"))
    spoilt = f"{text[:first]}0.0, 0.0, 0.0{text[first + len('PI/2.0, 0.0, 0.0') :]}"
    (finding,) = found("KD509", spoilt)
    assert finding.fix is not None
    assert apply_edits(spoilt, finding.fix.edits) == text


def test_sides_have_two_choices() -> None:
    text = two_arms("0.03, -0.1, 0.02")
    (finding,) = found("KD510", text)
    assert finding.fix is None
    made = {apply_edits(text, fix.edits) for fix in finding.choices}
    assert two_arms("0.3, -0.1, 0.02") in made
    assert text.replace("0.3, 0.1, 0.02", "0.03, 0.1, 0.02") in made
    assert len(made) == 2


@pytest.mark.parametrize(
    ("right", "n_choices"),
    [
        ("0.1, 0.02, -0.01", None),
        ("0.1, 0.02, 0.01", None),
        ("0.1, -0.02, 0.01", 2),
        ("0.1, -0.02, -0.01", 2),
        ("0.13, 0.02, -0.01", None),
    ],
)
def test_a_com_that_only_a_sign_keeps_from_that_of_the_other_side(
    right: str, n_choices: int | None
) -> None:
    """Copies are left in peace, and what KD312 tells."""
    text = two_arms("0.3, -0.1, 0.02")
    for side, com in (("left", "0.1, 0.02, 0.01"), ("right", right)):
        at = text.index("inertia_params", text.index(f"link {side}_forearm"))
        inertia = section(2.0, com, 0.01, 0.04, 0.041)
        text = text[:at] + inertia + text[text.index("}", at) + 1 :]
    findings = [f for f in analyse(text).findings if f.code in CODES]
    assert [(f.code, len(f.choices)) for f in findings] == (
        [("KD510", n_choices)] if n_choices else []
    )
    for finding in findings:
        for fix in finding.choices:
            assert told("KD510", apply_edits(text, fix.edits)) == []


MIRRORED = "0.00051", "-0.00079", "-0.0003"
TURNED = "-0.00051", "-0.00079", "0.0003"


@pytest.mark.parametrize(
    ("com", "products", "is_told"),
    [
        ("0.101, 0.0203, -0.0102", MIRRORED, False),
        ("0.101, -0.0203, -0.0102", MIRRORED, True),
        ("0.101, 0.0203, 0.0102", MIRRORED, True),
        ("0.101, 0.0203, 0.0102", ("0.00051", "0.00079", "0.0003"), False),
        ("0.101, 0.0203, 0.0102", ("0.0005", "-0.0005", "-0.0002"), False),
        ("0.1015, 0.0205, 0.0102", ("0.0005", "-0.0005", "-0.0002"), False),
        ("0.101, -0.0203, -0.0102", TURNED, False),
        ("0.101, -0.0257, -0.0102", MIRRORED, False),
    ],
)
def test_a_sign_of_a_com_is_told_of_parts_with_drawings_of_their_own(
    com: str, products: tuple[str, ...], is_told: bool
) -> None:
    """Not where the products show that the whole body was turned, or may have been copied."""
    text = two_arms("0.3, -0.1, 0.02")
    left = section(2.0, "0.1, 0.02, 0.01", 0.01, 0.04, 0.041, 0.0005, 0.0008, 0.0003)
    right = section(2.02, com, 0.0101, 0.0402, 0.0409, *products)
    for side, inertia in (("left", left), ("right", right)):
        at = text.index("inertia_params", text.index(f"link {side}_forearm"))
        text = text[:at] + inertia + text[text.index("}", at) + 1 :]
    assert codes(text) == ["KD510"] * is_told
    for finding in found("KD510", text):
        mended = [apply_edits(text, fix.edits) for fix in finding.choices]
        assert [codes(each) for each in mended] == [[], []]
        assert any("(0.101, 0.0203, -0.0102)" in each for each in mended)


def test_a_number_that_both_sides_have_alike_is_told_where_the_rest_is_mirrored() -> None:
    text = two_arms("0.3, -0.001, 0.02").replace("0.3, 0.1, 0.02", "0.3, -0.001, 0.02")
    left, wrist, right = text.rpartition("0.25, 0.0, 0.0")
    mirrored = left.replace(wrist, "0.25, 0.05, 0.0") + "0.25, -0.05, 0.0" + right
    assert (codes(text), codes(mirrored)) == ([], ["KD510"])


def test_a_number_that_no_slip_explains_is_meant() -> None:
    assert codes(two_arms("0.37, -0.13, 0.02")) == []


@pytest.mark.parametrize(
    ("left", "expected"),
    [
        ("0.1, 0.3, 0.2", []),
        ("0.1, 0.3, -0.2", []),
        ("0.3, 0.1, 0.2", ["KD510"]),
        ("0.1, 300.0, 0.2", ["KD510"]),
        ("0.1, 0.3, 0.25", []),
        ("0.1, 0.0, 0.2", []),
    ],
)
def test_of_two_single_bodies_only_order_and_unit_tell(left: str, expected: list[str]) -> None:
    """A sign makes a half turn of them, and a number that differs may be meant."""
    wheels = link("wheel_l", 1), link("wheel_r", 2)
    places = ("j_l", left), ("j_r", "0.1, -0.3, 0.2")
    joints = [placed_joint(name, place, "PI/2.0, 0.0, 0.0") for name, place in places]
    assert codes(robot(*wheels, *joints, base="wheel_l via j_l wheel_r via j_r")) == expected


def with_wheels(
    places: dict[str, str], turns: dict[str, str] | None = None, kind: str = "r"
) -> str:
    """Return a cart whose wheels turn about y."""
    names = [*places]
    links = [link(name, n) for n, name in enumerate(names, 1)]
    turned = dict.fromkeys(names, "PI/2.0, 0.0, 0.0") | (turns or {})
    joints = [placed_joint(f"to_{name}", places[name], turned[name]) for name in names]
    base = " ".join(f"{name} via to_{name}" for name in names)
    return robot(*links, *joints, base=base).replace("r_joint", f"{kind}_joint")


@pytest.mark.parametrize("wrong", ["left_wheel_2", "right_wheel_2"])
def test_a_wheel_is_mounted_as_others_of_its_cart(wrong: str) -> None:
    places = {
        f"{side}_wheel_{row}": f"{x}, {y}, -0.05"
        for row, x in (("1", "0.2"), ("2", "-0.2"))
        for side, y in (("left", "0.175"), ("right", "-0.175"))
    }
    text = with_wheels(places)
    assert codes(text) == []
    slipped = with_wheels({**places, wrong: places[wrong].replace("-0.05", "0.05")})
    (finding,) = found("KD510", slipped)
    assert text in [apply_edits(slipped, choice.edits) for choice in finding.choices]


@pytest.mark.parametrize("place", ["0.0, 0.35, -0.1", "0.2, -0.35, 0.0", "0.0, 0.35, 0.0"])
def test_two_wheels_at_one_place_are_reported(place: str) -> None:
    text = with_wheels({"left_wheel": place, "right_wheel": place})
    (finding,) = found("KD510", text)
    other = place.replace("-0.35", "0.35") if "-0.35" in place else place.replace("0.35", "-0.35")
    assert {apply_edits(text, choice.edits) for choice in finding.choices} == {
        with_wheels({"left_wheel": place, "right_wheel": other}),
        with_wheels({"left_wheel": other, "right_wheel": place}),
    }


@pytest.mark.parametrize(
    ("part", "kind", "place"),
    [
        ("leg", "r", "0.1, 0.0, -0.1"),
        ("finger", "r", "0.0, 0.1, 0.05"),
        ("rail", "p", "0.0, 0.1, 0.05"),
    ],
)
def test_what_is_at_one_place_in_a_plane_or_moves_away_is_meant(
    part: str, kind: str, place: str
) -> None:
    assert codes(with_wheels({f"left_{part}": place, f"right_{part}": place}, kind=kind)) == []


@pytest.mark.parametrize(
    ("turn", "expected"),
    [("PI/2.0, 0.0, PI/2.0", []), ("0.0, 0.0, 0.0", ["KD510"]), ("PI/2.0, 0.3, 0.0", [])],
)
def test_a_wheel_turns_about_the_axis_of_its_peer(turn: str, expected: list[str]) -> None:
    places = {"left_wheel": "0.1, 0.35, -0.1", "right_wheel": "0.1, -0.35, -0.1"}
    assert codes(with_wheels(places, {"right_wheel": turn})) == expected


def test_a_limb_on_another_leg_is_told_alone() -> None:
    """Its numbers are not compared with those of limbs that are whole."""
    moved = four_legs(RF="0.9, 0.0, 0.0").replace("{ RF_shank via RF_KFE }", "{ }")
    moved = moved.replace("{ LF_shank via", "{ RF_shank via RF_KFE LF_shank via")
    assert codes(moved) == ["KD208"]


HIP = section(2.0, "0.02, 0.01, 0.05", 0.03, 0.031, 0.032)


def legs_with(**hips: str) -> str:
    """Return legs whose hips have an inertia, some another."""
    text = four_legs()
    for leg in ("LF", "RF", "LH", "RH"):
        at = text.index("inertia_params", text.index(f"link {leg}_hip"))
        end = text.index("}", at) + 1
        text = text[:at] + hips.get(leg, HIP) + text[end:]
    return text


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("mass = 2.0", "mass = 2.5", "mass of 'RH_hip' is 2.5, by its twins 2.0"),
        (
            "0.02, 0.01, 0.05",
            "0.06, 0.01, 0.05",
            "CoM of 'RH_hip' is (0.06, 0.01, 0.05), by its twins (0.02, 0.01, 0.05)",
        ),
        ("Iy=0.031", "Iy=0.037", "Iy of 'RH_hip' is 0.037, by its twins 0.031"),
    ],
)
def test_numbers_of_an_inertia_are_those_of_the_twins(old: str, new: str, message: str) -> None:
    """KD312 compares left and right; where there are more, KD509 knows better."""
    assert told("KD509", legs_with()) == []
    text = legs_with(RH=HIP.replace(old, new))
    findings = [f for f in analyse(text).findings if f.code in ("KD312", "KD509")]
    assert [(f.code, f.message) for f in findings] == [("KD509", message)]
    assert findings[0].fix is not None
    assert apply_edits(text, findings[0].fix.edits) == legs_with()


@pytest.mark.parametrize(("mass", "is_told"), [("2.05", False), ("2.6", True)])
def test_bodies_that_were_measured_each_by_itself_differ_a_little(mass: str, is_told: bool) -> None:
    """Cables make hips differ by a per cent or two; where three are copies, that tells."""
    hips = {
        leg: HIP.replace("mass = 2.0", f"mass = {m}") for leg, m in (("RF", 2.01), ("LH", 1.996))
    }
    hips["RH"] = HIP.replace("mass = 2.0", f"mass = {mass}")
    assert bool(told("KD509", legs_with(**hips))) == is_told
    assert told("KD509", legs_with(RH=hips["RH"])) != []


def with_mirrored_hips(product: str) -> str:
    """Return legs of which hips are mirrored at both planes, thighs and shanks at one."""
    hip = HIP.replace("Iyz=0.0", f"Iyz=%s{product}")
    hips = {
        leg: hip.replace("0.02, 0.01", f"0.02, {y}0.01").replace("0.05)", f"{z}0.05)") % product
        for leg, y, z, product in (
            ("LF", "", "-", "-"), ("RF", "-", "-", ""), ("LH", "", "", ""), ("RH", "-", "", "-")
        )
    }  # fmt: skip
    text = legs_with(**hips)
    for name in (f"{leg}_{part}" for leg in hips for part in ("thigh", "shank")):
        at = text.index("inertia_params", text.index(f"link {name}"))
        com = f"0.02, 0.03, {'' if name[0] == 'L' else '-'}0.02"
        text = text[:at] + section(2.0, com, 0.01, 0.011, 0.012) + text[text.index("}", at) + 1 :]
    return text


def other_sign(text: str, leg: str) -> str:
    """Return legs with the other sign of the last coordinate of a hip's CoM."""
    at = text.index("0.05)", text.index(f"link {leg}_hip"))
    is_negative = text[at - 1] == "-"
    return f"{text[: at - is_negative]}{'' if is_negative else '-'}{text[at:]}"


@pytest.mark.parametrize("leg", ["LF", "RF", "LH", "RH"])
def test_hips_may_be_mirrored_where_the_rest_is_copied(leg: str) -> None:
    text = with_mirrored_hips("0.002")
    assert told("KD509", text) == []
    (finding,) = found("KD509", other_sign(text, leg))
    assert finding.message.startswith(f"CoM of '{leg}_hip' is ")
    assert finding.fix is not None
    assert apply_edits(other_sign(text, leg), finding.fix.edits) == text


@pytest.mark.parametrize("leg", ["LF", "RF", "LH", "RH"])
def test_of_two_hips_that_may_both_be_wrong_none_is_to_be_mended(leg: str) -> None:
    """Without products nothing tells whether hips are mirrored or copied."""
    (finding,) = found("KD509", other_sign(with_mirrored_hips("0.0"), leg))
    assert f"CoM of '{leg}_hip'" in finding.message
    assert " or " in finding.message
    assert finding.fix is None


@pytest.mark.parametrize("wrong", ["leg1", "leg2", "leg3", "leg4"])
def test_numbered_legs_may_be_mirrored_at_one_plane_alone(wrong: str) -> None:
    """Of a CoM with another sign either side may be the odd one, and none is to be mended."""

    def thighs(text: str, wrong: str) -> str:
        for leg, sign in (("leg1", "-"), ("leg2", ""), ("leg3", "-"), ("leg4", "")):
            at = text.index("inertia_params", text.index(f"link {leg}_thigh"))
            z = sign if leg != wrong else "" if sign else "-"
            bar = section(2.0, f"0.02, 0.03, {z}0.02", 0.01, 0.011, 0.012)
            text = text[:at] + bar + text[text.index("}", at) + 1 :]
        return text

    legs = four_legs()
    for n, leg in enumerate(("LF", "RF", "LH", "RH"), 1):
        legs = legs.replace(f"{leg}_", f"leg{n}_")
    assert told("KD509", thighs(legs, "")) == []
    (finding,) = found("KD509", thighs(legs, wrong))
    assert f"'{wrong}_thigh'" in finding.message and finding.fix is None


COPIED = (
    "inertia of 'RH_hip' differs from its twins: its moments are those of 'LF_shank', "
    "which is another part"
)


def with_shanks(text: str, inertia: str) -> str:
    """Return legs whose shanks have an inertia."""
    for leg in ("LF", "RF", "LH", "RH"):
        at = text.index("inertia_params", text.index(f"link {leg}_shank"))
        text = text[:at] + inertia + text[text.index("}", at) + 1 :]
    return text


def test_a_copied_inertia_is_that_of_its_twins_instead() -> None:
    knee = section(1.2345, "0.012345, 0.0, 0.10123", 0.015678, 0.016789, 0.005123)
    text = with_shanks(legs_with(RH=knee), knee)
    (finding,) = found("KD509", text)
    assert finding.message == COPIED
    assert finding.fix is not None
    assert told("KD509", apply_edits(text, finding.fix.edits)) == []


@published
@pytest.mark.parametrize("leg", ["LF", "RF", "LH", "RH"])
def test_signs_of_small_numbers_are_those_of_another_pair(leg: str) -> None:
    text = published_model("robcogen2__hyq").read_text()

    def inertia_of(link: str) -> tuple[int, int]:
        start = text.index("inertia_properties", text.index(f"link {link}"))
        return start, text.index("}", start) + 1

    (start, end), (other, its_end) = inertia_of(f"{leg}_upperleg"), inertia_of("LF_lowerleg")
    copied = text[:start] + text[other:its_end] + text[end:]
    finding = next(f for f in found("KD509", copied) if f"'{leg}_upperleg'" in f.message)
    assert finding.fix is not None
    here, there = analyse(text), analyse(apply_edits(copied, finding.fix.edits))
    bodies = [
        mass_distribution(each.model.body_named[f"{leg}_upperleg"].inertia, {})
        for each in (here, there)
    ]
    assert bodies[0] == bodies[1]


def test_of_a_copied_mass_the_link_is_told_that_it_was_copied_from() -> None:
    knee = section(1.2345, "0.02, 0.01, 0.05", 0.015678, 0.016789, 0.015123)
    hind = section(2.0, "0.02, 0.01, 0.05", 0.05, 0.052, 0.053)
    text = legs_with(RH=knee, LH=hind)
    (finding,) = found("KD509", with_shanks(text, knee))
    assert finding.message == COPIED
    assert finding.fix is None


@pytest.mark.parametrize("signs", list(product(("", "-"), repeat=4)))
def test_one_leg_at_most_is_told_to_be_unlike_its_twins(signs: tuple[str, ...]) -> None:
    """As mirror images one may be odd, as copies another: two fixes would contradict."""
    legs = {
        leg: HIP.replace("0.02, 0.01", f"0.02, {sign}0.01").replace("Ixy=0.0", f"Ixy={sign}0.002")
        for leg, sign in zip(("LF", "RF", "LH", "RH"), signs, strict=True)
    }
    assert len(told("KD509", legs_with(**legs))) <= 1
    for leg in legs:
        one = {leg: legs[leg].replace("Ixy=", "Ixy=-").replace("--", "")}
        assert len(told("KD509", legs_with(**{**legs, **one}))) <= 1


def test_where_the_twins_are_impossible_too_they_still_tell_the_slip() -> None:
    """No cause makes such a body possible, and their value is not offered."""
    impossible = section(2.0, "0.02, 0.01, 0.05", 0.03, 0.031, 0.072)
    legs = dict.fromkeys(("LF", "RF", "LH"), impossible)
    text = legs_with(**legs, RH=impossible.replace("2.0", "20.0", 1))
    (finding,) = found("KD509", text)
    assert finding.fix is None
    assert finding.message == (
        "mass of 'RH_hip' is 20.0, by its twins 2.0, which are physically impossible"
    )
    assert told("KD509", legs_with(**legs, RH=impossible)) == []


def test_what_an_inertia_tells_itself_is_not_told_again_by_its_twins() -> None:
    """They are impossible, too, so that only they tell what was done; it is told once."""
    impossible = section(2.0, "0.013, 0.001, 0.057", 0.0956, 0.1012, 0.0006, 0.0, 0.011)
    by_rows = section(2.0, "0.013, 0.001, 0.057", 0.0956, 0.0, 0.011, 0.1012, 0.0, 0.0006)
    legs = dict.fromkeys(("LF", "RF", "LH"), impossible)
    findings = analyse(legs_with(**legs, RH=by_rows)).findings
    causes = [f.code for f in findings if "in the order xx xy xz yy yz zz" in f.message]
    assert causes == ["KD509"]


def test_legs_across_are_no_other_part() -> None:
    """Whose moments a leg has besides those beside and behind it tells nothing of a copy."""
    crossed = {
        leg: HIP.replace("Ixz=0.0", f"Ixz={sign}0.0023456").replace("Ix=0.03 ", "Ix=0.0312345 ")
        for leg, sign in (("LF", ""), ("RF", ""), ("LH", ""), ("RH", "-"))
    }
    messages = told("KD509", legs_with(**crossed))
    assert not any("another part" in message for message in messages)


def test_a_placeholder_among_twins_is_told_as_such() -> None:
    text = legs_with(RH=section(2.0, "0.02, 0.01, 0.05", 0.02, 0.02, 0.02))
    (finding,) = found("KD509", text)
    assert finding.message == (
        "moments of 'RH_hip' differ from its twins: Ix, Iy and Iz are all 0.02, a placeholder"
    )
    assert finding.fix is not None
    assert apply_edits(text, finding.fix.edits) == legs_with()


def test_moments_shifted_twice_are_told_as_such() -> None:
    twice = section(2.0, "0.02, 0.01, 0.05", 0.0352, 0.0368, 0.033)
    twice = twice.replace("Ixy=0.0", "Ixy=0.0004").replace("Ixz=0.0", "Ixz=0.002")
    text = legs_with(RH=twice.replace("Iyz=0.0", "Iyz=0.001"))
    (finding,) = found("KD509", text)
    assert finding.message == (
        "inertia of 'RH_hip' would be that of 'LF_hip', 'RF_hip' and 'LH_hip' if "
        "the moments were shifted to the frame origin once, not twice"
    )
    assert finding.fix is not None
    assert apply_edits(text, finding.fix.edits) == legs_with()


def test_a_slip_in_an_inertia_of_another_frame_is_told_in_that_frame() -> None:
    turned = "frames { fr_com { translation = (0.02, 0.01, 0.05) rotation = (0.0, 0.0, 0.3) } }"
    hip = section(2.0, "0.0, 0.0, 0.0", 0.03, 0.021, 0.032).replace("Ixy=0.0", "Ixy=0.004")
    hip = f"{hip[:-1]}    ref_frame = fr_com\n    }}\n    {turned}"
    legs = dict.fromkeys(("LF", "RF", "LH"), hip)
    assert told("KD509", legs_with(**legs, RH=hip)) == []
    assert told("KD509", legs_with(**legs, RH=hip.replace("Ixy=", "Ixy=-"))) == [
        "moments of 'RH_hip' differ from its twins: they would be theirs if "
        "the sign of Ixy were changed"
    ]


def test_signs_alone_may_also_be_those_of_a_turned_frame() -> None:
    hip = HIP.replace("Ixz=0.0", "Ixz=0.002")
    turned = hip.replace("0.02, 0.01", "-0.02, -0.01").replace("Ixz=0.002", "Ixz=-0.002")
    (finding,) = found("KD509", legs_with(LF=hip, RF=hip, LH=hip, RH=turned))
    assert finding.message == (
        "signs of inertia of 'RH_hip' differ from its twins, unless rotation of 'RH_HAA' is wrong"
    )
    assert finding.fix is None


def test_of_a_limb_that_is_a_copy_as_a_whole_no_single_number_is_mended() -> None:
    """A mount that was turned round would make it alike too, and is not what was meant."""
    aside = dict.fromkeys(("LF", "RF", "LH"), "0.08, 0.1, 0.0")
    of_limbs = analyse(four_legs(**aside, RH="0.08, -0.1, 0.0")).findings
    told = {f.code: f.fix for f in of_limbs if f.code in CODES}
    assert told == {"KD509": None, "KD510": None}


@pytest.mark.parametrize("leg", ["LF", "RF", "LH", "RH"])
def test_where_all_legs_are_copies_a_sign_is_not_that_of_a_mirrored_one(leg: str) -> None:
    thigh = section(0.34, "0.058, 0.011, 0.003", 0.00012, 0.00165, 0.0017, "0.000217", "0.000059")
    text = four_legs()
    for each in ("LF", "RF", "LH", "RH"):
        at = text.index("inertia_params", text.index(f"link {each}_thigh"))
        text = text[:at] + thigh + text[text.index("}", at) + 1 :]
    at = text.index("0.011", text.index(f"link {leg}_thigh"))
    spoilt = f"{text[:at]}-{text[at:]}"
    (finding,) = [f for f in analyse(spoilt).findings if f.probability is not None]
    assert "would be consistent if the sign of the y of the CoM were changed" in finding.message
    assert finding.fix is not None
    assert apply_edits(spoilt, finding.fix.edits) == text


def test_a_com_behind_its_joint_is_told_once() -> None:
    """It is not what its twins have, either: KD509 knows which number is meant."""
    text = four_legs()
    for leg in ("LF", "RF", "LH", "RH"):
        at = text.index("inertia_params", text.index(f"link {leg}_thigh"))
        end = text.index("}", at) + 1
        com = "-0.17, 0.0, 0.0" if leg == "RH" else "0.17, 0.0, 0.0"
        text = text[:at] + section(2.0, com, 0.006, 0.0807, 0.0807) + text[end:]
    of_coms = [f for f in analyse(text).findings if f.code in (*CODES, "KD312", "KD511")]
    assert [f.code for f in of_coms] == ["KD509"]
    assert of_coms[0].fix is not None
    assert of_coms[0].fix.title == "Set CoM of 'RH_thigh' to (0.17, 0.0, 0.0)"


def test_the_sign_of_a_great_product_is_told_without_those_of_small_ones() -> None:
    """Without all three signs the moments would be nearly those of the twins, too."""
    hip = section(2.0, "0.02, 0.01, 0.05", 0.031, 0.033, 0.037, 0.003, 0.00001, 0.00002)
    (finding,) = found("KD509", legs_with(LF=hip, RF=hip, LH=hip, RH=hip.replace("Ixy=", "Ixy=-")))
    assert finding.message == (
        "inertia of 'RH_hip' would be that of 'LF_hip', 'RF_hip' and 'LH_hip' "
        "if the sign of Ixy were changed"
    )


def test_a_shape_is_judged_again_only_where_it_has_changed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Who has a slip to tell of asks each time whether another rule tells of that body."""
    judged: list[str] = []

    def listening(body: Link, *given: Any) -> Iterator[BodyVerdict]:
        judged.append(str(body.name))
        return shape_verdicts(body, *given)

    monkeypatch.setattr(shapes, "shape_verdicts", listening)
    analysis = analyse(legs_with(RH=HIP.replace("0.02, 0.01", "0.06, 0.01")))
    assert analysis.findings
    for old, new in (("mass = 2.0", "mass = 2.01"), ("0.06, 0.01", "0.07, 0.01")):
        judged.clear()
        at = analysis.text.index(old)
        analysis = analysis.edited([TextEdit(at, at + len(old), new)])
        assert "KD509" in {finding.code for finding in analysis.findings}
        assert set(judged) == {"LF_hip" if "mass" in old else "RH_hip"}


def test_only_limbs_that_changed_are_compared_again(monkeypatch: pytest.MonkeyPatch) -> None:
    compared: list[object] = []
    judged: list[object] = []

    def counted(limbs: Limbs) -> ComparedLimbs:
        compared.append(limbs)
        return ComparedLimbs(limbs)

    def verdicts_counted(limbs: ComparedLimbs, masses: Masses) -> list[LimbVerdict]:
        judged.append(limbs)
        return verdicts(limbs, masses)

    monkeypatch.setattr(limb_verdicts, "ComparedLimbs", counted)
    monkeypatch.setattr(limb_verdicts, "verdicts", verdicts_counted)
    text = four_legs()
    analysis = analyse(text)
    hip, mass = text.index("0.08"), text.index("mass = 4.1") + len("mass = ")
    of_base = text.index("Arm")
    steps = (
        (mass, "4.1", "4.2", 0, 1, ["KD509"]),
        (hip, "0.08", "0.80", 1, 1, ["KD509"]),
        (mass, "4.2", "4.1", 0, 1, ["KD509"]),
        (hip, "0.80", "0.81", 1, 1, ["KD509"]),
        (of_base, "Arm", "Leg", 0, 0, ["KD509"]),
        (hip, "0.81", "0.08", 1, 1, []),
    )
    assert [f.code for f in analysis.findings if f.code in CODES] == []
    for at, old, new, n_compared, n_judged, expected in steps:
        compared.clear()
        judged.clear()
        assert analysis.text[at : at + len(old)] == old
        analysis = analysis.edited([TextEdit(at, at + len(old), new)])
        assert [f.code for f in analysis.findings if f.code in CODES] == expected
        assert (len(compared), len(judged)) == (n_compared, n_judged)
        assert analysis.findings == analyse(analysis.text).findings


def test_a_thousand_numbered_limbs_are_not_compared(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limb_verdicts, "ComparedLimbs", lambda _: pytest.fail("compared"))
    numbers = range(1, 1001)
    links = [link(f"finger{n}", n) for n in numbers]
    joints = [placed_joint(f"j{n}", f"0.{n}, 0.1, 0.0", "0.0, 0.0, 0.0") for n in numbers]
    base = " ".join(f"finger{n} via j{n}" for n in numbers)
    assert codes(robot(*links, *joints, base=base)) == []


@published
def test_published_robots_are_left_in_peace() -> None:
    """But one, whose fourth leg is the only possible one."""
    found = {
        path.name: [f.message for f in analyse(text).findings if f.code in CODES]
        for path in sorted(CORPUS.glob("*.kindsl"))
        for text in (path.read_text("utf-8", "replace"),)
    }
    assert [each for each in found.items() if each[1]] == [
        (
            "dslkin__FixedHyQ__v06_2d4930f.kindsl",
            [
                "CoM of 'RH_leg' is (0.14796, -0.02958, 0.00000), by its twins "
                "(0.14796, 0.02958, 0.00000), which are physically impossible"
            ],
        )
    ]


def ball_beside(y: str) -> str:
    """Return the inertia of a ball of steel beside its link's origin."""
    ball = STEEL_BALL.replace("(0.0, 0.0, 0.0)", f"(0.0, {y}, 0.0)")
    return ball.replace("Ix=0.0041", "Ix=0.00779").replace("Iz=0.0041", "Iz=0.00779")


def walker(right_arm: str, aside: str = "0.0", hands: tuple[str, ...] = ()) -> str:
    """Return a robot with mirrored legs, and arms of which the right one's offsets are given.

    Args:
        right_arm: The offsets.
        aside: How far the centres of mass of the arms are outside.
        hands: The offsets of the left and the right hand, if there are hands.
    """
    offsets = {
        "left_leg": ("0.0, 0.1, -0.1", "0.02, 0.05, -0.3", "0.0, 0.03, -0.3"),
        "right_leg": ("0.0, -0.1, -0.1", "0.02, -0.05, -0.3", "0.0, -0.03, -0.3"),
        "left_arm": ("0.0, 0.2, 0.4", "0.1, 0.05, -0.2", "0.05, 0.03, -0.25"),
        "right_arm": ("0.0, -0.2, 0.4", *right_arm.split("; ")),
    }
    parts, number = [], 1
    for limb, places in offsets.items():
        for part, place in zip(("upper", "lower", "end"), places, strict=True):
            below = {"upper": "lower", "lower": "end"}.get(part)
            child = f"{limb}_{below} via {limb}_{below}_joint" if below else ""
            if part == "end" and hands and "arm" in limb:
                child = f"{limb}_hand via {limb}_wrist"
            outside = aside if limb == "left_arm" else f"-{aside}"
            inertia = ball_beside(outside) if "arm" in limb and aside != "0.0" else STEEL_BALL
            parts.append(link(f"{limb}_{part}", number, child, inertia))
            parts.append(placed_joint(f"{limb}_{part}_joint", place, "0.0, 0.0, 0.0"))
            number += 1
    for limb, hand in zip(("left_arm", "right_arm"), hands, strict=False):
        parts.append(link(f"{limb}_hand", number))
        parts.append(placed_joint(f"{limb}_wrist", hand, "0.0, 0.0, 0.0"))
        number += 1
    heads = " ".join(f"{limb}_upper via {limb}_upper_joint" for limb in offsets)
    return robot(*sorted(parts, key=lambda part: "joint" in part[:8]), base=heads)


def test_a_limb_that_is_copied_where_others_are_mirrored_is_reported() -> None:
    copied = walker("0.1, 0.05, -0.2; 0.05, 0.03, -0.25")
    (finding,) = found("KD510", copied)
    assert finding.message == (
        "limb 'right_arm_upper' is a copy of 'left_arm_upper', not its mirror image as the other "
        "limbs of this robot are"
    )
    assert codes(walker("0.1, -0.05, -0.2; 0.05, -0.03, -0.25")) == []


MIRRORED_ARM, COPIED_ARM = (
    "0.1, -0.05, -0.2; 0.05, -0.03, -0.25",
    "0.1, 0.05, -0.2; 0.05, 0.03, -0.25",
)


def test_joints_may_be_copied_alone() -> None:
    (finding,) = found("KD510", walker(COPIED_ARM, aside="0.03"))
    assert "is a copy of" in finding.message
    assert codes(walker(MIRRORED_ARM, aside="0.03")) == []


@pytest.mark.parametrize("y", ["0.03", "-0.03"])
def test_hands_do_not_tell_whether_arms_are_copies(y: str) -> None:
    hands = "0.02, 0.03, -0.04", f"0.02, {y}, -0.04"
    (finding,) = found("KD510", walker(COPIED_ARM, hands=hands))
    assert "is a copy of" in finding.message
    assert codes(walker(MIRRORED_ARM, hands=hands)) == []


def test_one_slip_that_makes_nearly_a_copy_is_told_alone() -> None:
    text = walker("0.1, -0.001, -0.2; 0.05, 0.03, -0.25").replace("(0.1, 0.05,", "(0.1, 0.001,")
    (finding,) = found("KD510", text)
    assert "one slip" in finding.message


def test_both_moves_are_offered_where_either_of_two_links_may_be_wrong() -> None:
    text = two_arms("0.3, -0.1, 0.02")
    entry = "right_wrist via right_roll"
    assert entry in text
    moved = text.replace(entry, "").replace("right_forearm via", f"{entry} right_forearm via")
    (finding,) = found("KD208", moved)
    assert finding.message == (
        "link 'left_wrist' is a child of 'left_forearm', 'right_wrist' of 'right_arm': one of the "
        "two sides is attached wrongly"
    )
    assert [fix.title for fix in finding.choices] == [
        "Move 'left_wrist' to 'left_arm'",
        "Move 'right_wrist' to 'right_forearm'",
    ]


def test_a_link_is_moved_with_its_line() -> None:
    text = four_legs().replace("{ RF_shank via RF_KFE }", "{\n        RF_shank via RF_KFE\n    }")
    wheel = "\n        RF_wheel via RF_axle"
    text = text.replace("RF_shank via RF_KFE\n", f"RF_shank via RF_KFE{wheel}\n")
    moved = text.replace("\n        RF_shank via RF_KFE", "")
    moved = moved.replace("{ LF_shank via LF_KFE }", "{ LF_shank via LF_KFE RF_shank via RF_KFE }")
    back = text.replace("\n        RF_shank via RF_KFE", "").replace(
        wheel, f"{wheel}\n        RF_shank via RF_KFE"
    )
    (finding,) = found("KD208", moved)
    assert finding.fix is not None and apply_edits(moved, finding.fix.edits) == back


def test_of_a_link_alone_on_its_line_no_line_is_left() -> None:
    lines = "{\n        LF_shank via LF_KFE\n        RF_shank via RF_KFE\n    }"
    moved = four_legs().replace("{ RF_shank via RF_KFE }", "{}")
    moved = moved.replace("{ LF_shank via LF_KFE }", lines)
    (finding,) = found("KD208", moved)
    assert finding.fix is not None
    fixed = four_legs().replace("{ LF_shank via LF_KFE }", "{\n        LF_shank via LF_KFE\n    }")
    assert apply_edits(moved, finding.fix.edits) == fixed


def with_turned_mount(text: str, place: str, rotation: str) -> str:
    old = f"({place})\n        rotation = (0.0, 0.0, 0.0)"
    assert old in text
    return text.replace(old, f"({place})\n        rotation = ({rotation})")


def test_a_number_before_its_carrier_s_tells_the_parent_of_a_wheel() -> None:
    """Renumbering would hide that the parent is wrong."""
    places = {"left_wheel": "0.0, 0.2, 0.0", "right_wheel": "0.0, -0.2, 0.0", "mast": ZERO}
    text = with_wheels(places)
    wheel = " right_wheel via to_right_wheel"
    at = text.index("children", text.index("link mast"))
    wrong = text[:at] + text[at:].replace("{  }", f"{{{wheel} }}", 1)
    wrong = wrong.replace(f"{wheel} mast", " mast")
    (finding,) = found("KD208", wrong)
    assert finding.message == "link 'right_wheel' is a child of 'mast', by its twin of 'ground'"
    assert finding.fix is not None and found("KD110", wrong)[0].fix is None
    assert [f.code for f in analyse(apply_edits(wrong, finding.fix.edits)).findings] == []


def test_a_like_arm_on_a_turned_mount_is_meant() -> None:
    arm = "0.02, 0.3, -0.05; 0.0, 0.25, -0.02"
    text = walker(arm).replace("(0.1, 0.05, -0.2)", "(0.02, 0.3, -0.05)")
    text = text.replace("(0.05, 0.03, -0.25)", "(0.0, 0.25, -0.02)")
    assert [f.code for f in found("KD510", text)] == ["KD510"]
    assert codes(with_turned_mount(text, "0.0, -0.2, 0.4", "0.0, 0.0, PI")) == []


@pytest.mark.parametrize("elbow", ["0.3, 0.0, 0.0", "0.0, %s0.1, -0.17", "0.0, 0.0, -0.2"])
def test_two_arms_at_one_place_are_told_though_a_map_explains_them(elbow: str) -> None:
    """As mirror images in a plane through both, but then their CoMs are not."""

    def arms(right: str) -> str:
        blocks = []
        for n, (side, place, sign) in enumerate(
            (("left", "0.0, 0.2, 0.5", ""), ("right", right, "-"))
        ):
            bar = section(2.0, f"0.02, {sign}0.03, 0.1", 0.06, 0.06, 0.01, 0.0, 0.0, f"{sign}0.006")
            at = elbow % sign if "%" in elbow else elbow
            blocks += [
                link(f"{side}_arm", 3 * n + 1, f"{side}_forearm via {side}_elbow", bar),
                link(f"{side}_forearm", 3 * n + 2, f"{side}_wrist via {side}_roll"),
                link(f"{side}_wrist", 3 * n + 3),
                placed_joint(f"{side}_shoulder", place, ZERO),
                placed_joint(f"{side}_elbow", at, "PI/2.0, 0.0, 0.0"),
                placed_joint(f"{side}_roll", "0.25, 0.0, 0.0", ZERO),
            ]
        return robot(*blocks, base="left_arm via left_shoulder right_arm via right_shoulder")

    assert codes(arms("0.0, -0.2, 0.5")) == []
    (finding,) = found("KD510", arms("0.0, 0.2, 0.5"))
    fixed = [apply_edits(arms("0.0, 0.2, 0.5"), fix.edits) for fix in finding.choices]
    assert arms("0.0, -0.2, 0.5") in fixed


def test_a_copy_on_a_mirrored_mount_is_reported() -> None:
    text = with_turned_mount(walker(COPIED_ARM), "0.0, 0.2, 0.4", "0.3, 0.0, 0.0")
    (finding,) = found("KD510", with_turned_mount(text, "0.0, -0.2, 0.4", "-0.3, 0.0, 0.0"))
    assert "is a copy of" in finding.message


@pytest.mark.parametrize("right", ["0.6, 0.0, 0.0", "0.0, 0.5, 0.0"])
def test_a_base_may_lie_at_one_of_two_arms(right: str) -> None:
    text = two_arms("0.3, -0.1, 0.02")
    moved = text.replace("0.0, 0.2, 0.5", "0.0, 0.0, 0.0").replace("0.0, -0.2, 0.5", right)
    assert codes(moved) == []


@pytest.mark.parametrize(
    ("kind", "left", "right"),
    [
        # Fingers that turn begin at one place, those that slide on both sides of it.
        ("r", "0.0, 0.024, 0.089; 0.024, 0.0, 0.089", "0.0, 0.024, 0.089"),
        ("p", "0.0, 0.015, 0.166; 0.0, 0.0, 0.166", "0.0, -0.015, 0.166"),
    ],
)
def test_fingers_are_offered_the_place_that_they_had(kind: str, left: str, right: str) -> None:
    def hand(place: str) -> str:
        slide = "PI/2.0, 0.0, 0.0" if kind == "p" else "-PI/2.0, 0.0, -0.05"
        other = "-PI/2.0, 0.0, 0.0" if kind == "p" else "-PI/2.0, 0.0, 0.05"
        tip = "0.0, -0.14, 0.0"
        links = "".join(
            link(f"{side}_finger", 2 * n, f"{side}_tip via {side}_bend")
            + link(f"{side}_tip", 2 * n + 1)
            + placed_joint(f"{side}_slide", at, turn).replace("r_joint", f"{kind}_joint")
            + placed_joint(f"{side}_bend", tip, "0.0, 0.0, 0.0")
            for n, (side, at, turn) in enumerate(
                (("left", place, slide), ("right", right, other)), 1
            )
        )
        return robot(links, base="left_finger via left_slide right_finger via right_slide")

    meant, wrong = map(hand, left.split("; "))
    assert codes(meant) == []
    (finding,) = found("KD510", wrong)
    assert meant in [apply_edits(wrong, fix.edits) for fix in finding.choices]


def test_a_rotation_of_one_slip_is_meant_rather_than_the_moments_of_twins() -> None:
    """Products are the same in fingers that are mirrored, as those of the Allegro hand."""

    def hand(turn: str) -> str:
        moments = (8.09e-5, 7.97e-5, 2.86e-5, 4.2e-6, -1.48e-5, 2.14e-5)
        blocks = []
        for n, (place, tilt) in enumerate(
            (("0.0435, -0.0015", "-0.0873"), ("0.0, 0.0007", "0.0"), ("-0.0435, -0.0015", "0.0873"))
        ):
            blocks += [
                link(f"finger{n}", 3 * n + 1, f"middle{n} via bend{n}"),
                link(f"middle{n}", 3 * n + 2, f"tip{n} via end{n}", section(0.065, ZERO, *moments)),
                link(f"tip{n}", 3 * n + 3),
                placed_joint(f"spread{n}", f"0.0, {place}", f"{tilt}, 0.0, 0.0"),
                placed_joint(
                    f"bend{n}", "0.0, 0.0, 0.0164", turn if n == 2 else "-PI/2.0, 0.0, 0.0"
                ),
                placed_joint(f"end{n}", "0.0, -0.054, 0.0", "0.0, 0.0, 0.0"),
            ]
        return robot(*blocks, base=" ".join(f"finger{n} via spread{n}" for n in range(3)))

    assert codes(hand("-PI/2.0, 0.0, 0.0")) == []
    (finding,) = found("KD509", hand("0.0, 0.0, 0.0"))
    assert finding.fix is not None
    meant = apply_edits(hand("0.0, 0.0, 0.0"), finding.fix.edits)
    assert meant == hand("-PI/2.0, 0.0, 0.0")


@pytest.mark.parametrize("wrong", ["-0.15, -0.017, 0.08", "-0.015, 0.08, -0.017"])
def test_fingers_half_a_turn_apart_are_offered_a_place_of_one_slip(wrong: str) -> None:
    """Were they mirrored, a sign would be wrong as well."""

    def hand(left: str) -> str:
        places = {"left_finger": left, "right_finger": "0.015, 0.017, 0.08"}
        return with_wheels(places, dict.fromkeys(places, "0.0, PI/2.0, 0.0"), "p")

    assert codes(hand("-0.015, -0.017, 0.08")) == []
    (finding,) = found("KD510", hand(wrong))
    fixed = [apply_edits(hand(wrong), fix.edits) for fix in finding.choices]
    assert hand("-0.015, -0.017, 0.08") in fixed


_FIVE, _THREE = tuple(range(0, 360, 72)), (10, 130, 250)


def ring(bearings: tuple[int, ...], place: str = "", turn: str = "") -> str:
    """Return a robot with numbered arms in a ring, the second's place or last angle given."""
    blocks = []
    for n, bearing in enumerate(bearings, 1):
        angle = radians(bearing if bearing <= 180 else bearing - 360)
        at = (n == 2 and place) or f"{0.3 * cos(angle):.6f}, {0.3 * sin(angle):.6f}, 0.1"
        turned = (n == 2 and turn) or f"{angle:.6f}"
        blocks += [
            link(f"arm{n}", 2 * n - 1, f"fist{n} via elbow{n}"),
            link(f"fist{n}", 2 * n),
            placed_joint(f"shoulder{n}", at, f"0.0, 0.0, {turned}"),
            placed_joint(f"elbow{n}", "0.2, 0.03, 0.05", "0.5, 0.0, 0.0"),
        ]
    base = " ".join(f"arm{n} via shoulder{n}" for n in range(1, len(bearings) + 1))
    return robot(*blocks, base=base)


@pytest.mark.parametrize(
    ("bearings", "slip", "message"),
    [
        # Its place is that of another arm, or would be.
        (
            _FIVE,
            {"place": "0.092705, -0.285317, 0.1"},
            "translation of 'shoulder2' is (0.092705, -0.285317, 0.1), by its twins "
            "(0.092705, 0.285317, 0.1)",
        ),
        (
            _FIVE,
            {"turn": "-1.256637"},
            "rotation of 'shoulder2' is (0.0, 0.0, -1.256637), by its twins (0.0, 0.0, 1.256637)",
        ),
        # Nobody types the angle that would be needed otherwise, or both numbers of a place.
        (
            _THREE,
            {"place": "0.229813, -0.192836, 0.1"},
            "translation of 'shoulder2' is (0.229813, -0.192836, 0.1), by its twins "
            "(-0.192836, 0.229813, 0.1)",
        ),
        *(
            (
                _THREE,
                {"turn": angle},
                f"rotation of 'shoulder2' is (0.0, 0.0, {angle}), by its twins "
                "(0.0, 0.0, 2.268929)",
            )
            for angle in ("2.468928", "3.839724", "130.0")
        ),
        # Either sign may be wrong.
        *(
            (
                _THREE,
                slip,
                "rotation of 'shoulder2' or translation of 'shoulder2' differs from its twins",
            )
            for slip in ({"place": "-0.192836, -0.229813, 0.1"}, {"turn": "-2.268928"})
        ),
    ],
)
def test_in_a_ring_place_or_rotation_of_an_arm_may_be_wrong(
    bearings: tuple[int, ...], slip: dict[str, str], message: str
) -> None:
    assert told("KD509", ring(bearings)) == []
    (finding,) = found("KD509", ring(bearings, **slip))
    assert finding.message == message
    assert (finding.fix is None) == (" or " in message)


def test_a_link_with_no_expected_place_is_unlike_its_twin() -> None:
    own, peer = Attachment("a", "base", "j"), Attachment("b", "base", "k")
    names: Any = SimpleNamespace(crossed=[], elsewhere=[])
    names.crossed = names.elsewhere = [Misplaced(own, None, (peer,))]
    for findings in (crossed_findings, elsewhere_findings):
        ((finding, _),) = findings(names, lambda _: cast(Located, None))
        assert finding.message.endswith(", unlike its twin")


@pytest.mark.parametrize(
    ("own", "peer", "expected"), [("0.0", "0.0", "1.570796"), ("0.0", "0.25", "1.57")]
)
def test_zeros_tell_nothing_of_the_digits_that_are_meant(
    own: str, peer: str, expected: str
) -> None:
    """A quarter turn beside zeros alone is not 1.6."""
    wheels = link("a", 1), link("b", 2)
    turns = ("j", f"{own}, 0.0, 0.0"), ("k", f"{peer}, 0.0, 0.0")
    joints = [placed_joint(name, "0.0, 0.0, 0.0", turn) for name, turn in turns]
    model = analyse(robot(*wheels, *joints, base="a via j b via k")).model
    mine, other = (joint.pose.rotation for joint in model.joints)
    assert mine is not None and other is not None
    texts = retyped(mine.components, [other.components], [(pi / 2, 0.0, 0.0)], [{}])
    assert texts == (expected, "0.0", "0.0")


def test_a_cause_in_a_limb_that_its_peers_outvote_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """The peers leave it to the cause, so that nobody else tells it."""
    text = legs_with(RH=HIP.replace("0.02, 0.01, 0.05", "0.06, 0.01, 0.05"))
    assert codes(text) == ["KD509"]

    def explained(model: Model, *_: object) -> Iterator[Finding]:
        inertia = model.body_named["RH_hip"].inertia
        assert inertia is not None
        yield Finding(keyword(inertia), "told by its cause")

    monkeypatch.setattr(kd312_mirrored_pair_differs, "explained", explained)
    assert [each.message for each in found("KD312", text)] == ["told by its cause"]


def test_a_com_in_millimetres_is_told_without_what_its_twins_have() -> None:
    thin = section(0.039158, "0.1, 0.1, 0.0", 0.000734782, 0.000734782, 0.001351121, 0.00061634)
    legs = dict.fromkeys(("LF", "RF", "LH"), thin)
    text = legs_with(**legs, RH=thin.replace("0.1, 0.1", "100.0, 100.0"))
    (finding,) = (f for f in analyse(text).findings if f.code in (*CODES, "KD502"))
    assert finding.code == "KD502"
    assert finding.fix is not None
    assert apply_edits(text, finding.fix.edits) == legs_with(**legs, RH=thin)


@pytest.mark.parametrize("side", ["left", "right"])
def test_of_two_sides_the_one_with_a_com_in_millimetres_is_told(side: str) -> None:
    forearm = section(2.0, "0.02, 0.0, 0.05", 0.03, 0.031, 0.02)
    text = two_arms("0.3, -0.1, 0.02")
    for name in ("left_forearm", "right_forearm"):
        at = text.index("inertia_params", text.index(f"link {name}"))
        text = text[:at] + forearm + text[text.index("}", at) + 1 :]
    at = text.index("0.02, 0.0, 0.05", text.index(f"link {side}_forearm"))
    far = f"{text[:at]}20.0, 0.0, 50.0{text[at + len('0.02, 0.0, 0.05') :]}"
    told = [f.code for f in analyse(far).findings if f.code in (*CODES, "KD312", "KD502")]
    assert (codes(text), told) == ([], ["KD502"])
