"""A rod across its link (KD313) or behind its joint (KD511): which bodies are, and the repairs."""

import pytest
from tests.support.examples import joint, link, placed_joint, robot
from tests.support.one_rule import found, told

from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits

SECTION = "inertia_params { mass = 2.0 CoM = (%s) Ix=%s Iy=%s Iz=%s Ixy=0.0 Ixz=0.0 Iyz=0.0 }"
MESSAGE = "inertia of 'upper' describes a rod %s m long across the link, which is 0.4 m long"


def arm(com: str, moments: str, *, length: float = 0.4) -> str:
    """Return a link that goes along z to its elbow; moments are Ix, Iy and Iz."""
    inertia = SECTION % (com, *moments.split())
    upper = link("upper", 1, "lower via elbow", inertia)
    joints = joint("shoulder"), joint("elbow", length)
    return robot(upper, link("lower", 2), *joints, base="upper via shoulder")


@pytest.mark.parametrize(
    ("com", "moments", "length", "rod"),
    [
        # A rod of 0.4 m has 2.0 * 0.4^2 / 12 = 0.027; 0.08 more at 0.2 m.
        ("0.0, 0.0, 0.2", "0.081 0.107 0.027", 0.4, "0.399"),  # along x
        ("0.0, 0.0, 0.2", "0.107 0.081 0.027", 0.4, "0.399"),  # along y
        ("0.0, 0.0, 0.2", "0.107 0.107 0.001", 0.4, None),  # along z, as the link
        ("0.0, 0.0, 0.2", "0.107 0.107 0.027", 0.4, None),  # a box
        ("0.0, 0.0, 0.2", "0.081 0.107 0.027", -0.4, None),  # the CoM is behind the joint
        ("0.0, 0.0, 0.2", "0.081 0.107 0.027", 0.22, None),  # next to the elbow
        ("0.0, 0.0, 0.05", "0.006 0.032 0.027", 0.4, None),  # next to the shoulder
        ("0.0, 0.0, 0.2", "0.081 0.0845 0.0045", 0.4, None),  # a rod of 0.14 m: a knob
        ("0.0, 0.0, 0.2", "0.081 0.28 0.20", 0.4, None),  # of 1.1 m: a cross-beam
        ("0.0, 0.0, 0.2", "0.001 0.027 0.027", 0.4, None),  # impossible
    ],
)
def test_a_rod_across_its_link(com: str, moments: str, length: float, rod: str | None) -> None:
    expected = [] if rod is None else [MESSAGE % rod]
    assert told("KD313", arm(com, moments, length=length)) == expected


def test_of_two_mistakes_the_second_stays_told() -> None:
    """The moments of a rod along x are given about the CoM; the link goes along z."""
    text = arm("0.0, 0.0, 0.2", "0.001 0.027 0.027")
    (finding,) = found("KD306", text)
    assert "though then long across its link" in finding.message
    assert finding.fix is not None
    whole = apply_edits(text, finding.fix.edits)
    found_then = [f for f in analyse(whole).findings if f.code.startswith("KD3")]
    assert [(f.code, f.message) for f in found_then] == [("KD313", MESSAGE % "0.399")]


def test_of_one_mistake_nothing_is_left() -> None:
    text = arm("0.0, 0.0, 0.2", "0.027 0.027 0.001")
    (finding,) = found("KD306", text)
    assert "across" not in finding.message
    assert finding.fix is not None
    after = analyse(apply_edits(text, finding.fix.edits)).findings
    assert [f.code for f in after if f.code.startswith("KD3")] == []


def test_a_body_in_the_axes_of_another_format_is_turned() -> None:
    """As the UR5 was published: centre of mass and moments are those about axes one further on."""
    section = """inertia_params { mass = 2.0 CoM = (0.02, -0.01, 0.2)
        Ix=0.108 Iy=0.109 Iz=0.003 Ixy=0.0001 Ixz=0.006 Iyz=-0.003 }"""
    upper = link("upper", 1, "lower via elbow", section)
    joints = joint("shoulder"), placed_joint("elbow", "0.4, 0.0, 0.0", "0.0, 0.0, 0.0")
    text = robot(upper, link("lower", 2), *joints, base="upper via shoulder")
    (finding,) = found("KD313", text)
    assert finding.fix is not None and not finding.fix.is_safe
    turned = apply_edits(text, finding.fix.edits)
    assert "CoM = (0.2, 0.02, -0.01)" in turned
    assert "Ix=0.003 Iy=0.108 Iz=0.109 Ixy=0.006 Ixz=-0.003 Iyz=0.0001" in turned
    assert told("KD313", turned) == []


def test_a_body_behind_its_joint_has_two_repairs() -> None:
    text = arm("0.01, 0.0, -0.2", "0.107 0.107 0.0011")
    (finding,) = found("KD511", text)
    assert finding.message == (
        "CoM of 'upper' lies 0.2 m behind its joint, though the next one is 0.4 m ahead"
    )
    made = [apply_edits(text, choice.edits) for choice in finding.choices]
    assert made == [text.replace("-0.2", "0.2"), text.replace("0.0, 0.0, 0.4", "0.0, 0.0, -0.4")]
    assert all(told("KD511", each) == [] for each in made)


@pytest.mark.parametrize(
    ("com", "moments", "length"),
    [
        ("0.0, 0.0, 0.2", "0.107 0.107 0.001", 0.4),
        ("0.0, 0.0, -0.02", "0.0278 0.0278 0.001", 0.4),  # hardly behind
        ("0.0, 0.0, -0.2", "0.0828 0.0828 0.001", 0.4),  # a counterweight of 0.13 m
        ("0.0, 0.0, -0.2", "0.34 0.34 0.001", 0.4),  # a beam of 1.25 m
        ("0.0, 0.0, -0.2", "0.11 0.11 0.02", 0.4),  # a box
    ],
)
def test_what_is_honestly_behind_its_joint(com: str, moments: str, length: float) -> None:
    assert told("KD511", arm(com, moments, length=length)) == []
