"""A rod across its link (KD313): which bodies are, and that another slip's fix leaves it told."""

import pytest
from tests.support.one_rule import found, told

from kindsl.analysis.analysis import analyse
from kindsl.rules.examples import joint, link, robot
from kindsl.text.edits import apply_edits

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
