"""What rules find and fixes write, over ranges of numbers and ways to lay a document out."""

import re
from math import cos, sin

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.support.examples import STEEL_BALL, joint, link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.diagnosis.body_verdicts import GREATEST_LENGTH
from kindsl.judgement.rules.checks.kd404_unused_binding import unused_bindings
from kindsl.language.text.edits import apply_edits

steady = settings(deadline=None, max_examples=60)
small = st.floats(-8.0, -3.0).map(lambda exponent: 10.0**exponent)
names = st.lists(st.sampled_from(["reach", "raech", "l1", "l2", "m", "tilt"]), max_size=6)
lengths = st.floats(-5000.0, 5000.0).map(lambda value: round(value, 2))
blanks = st.sampled_from([" ", "\n", "\r\n", "\t", "\n        ", " // c\n", " /* c */ ", "\n\n"])


def found(code: str, text: str) -> list[Diagnostic]:
    analysis = analyse(text)
    assert analysis.faults == ()
    return [finding for finding in analysis.findings if finding.code == code]


def chain(elbow: str, kind: str = "r_joint") -> str:
    """Return two links; the second joint of a kind has the given frame, the first its own."""
    links = link("upper", 1, "lower via elbow"), link("lower", 2)
    joints = (
        joint("shoulder").replace("r_joint", kind),
        f"{kind} elbow {{ ref_frame {{ {elbow} }} }}\n",
    )
    return robot(*links, *joints, base="upper via shoulder")


@steady
@given(offset=small, direction=st.floats(0.0, 6.3), turn=st.floats(-3.0, 3.0))
def test_axes_coincide_within_a_micrometre(offset: float, direction: float, turn: float) -> None:
    assume(abs(offset - 1e-6) > 1e-8)
    x, y = offset * cos(direction), offset * sin(direction)
    frame = f"translation = ({x:.12f}, {y:.12f}, 0.4) rotation = (0.0, 0.0, {turn:.6f})"
    assert bool(found("KD506", chain(frame))) == (offset < 1e-6)
    assert found("KD506", chain(frame, "p_joint"))


@steady
@given(tilt=small, turn=st.floats(-3.0, 3.0))
def test_axes_are_parallel_within_a_microradian(tilt: float, turn: float) -> None:
    assume(abs(tilt - 1e-6) > 1e-8)
    frame = f"translation = (0.0, 0.0, 0.4) rotation = ({tilt:.12f}, 0.0, {turn:.6f})"
    for kind in ("r_joint", "p_joint"):
        assert bool(found("KD506", chain(frame, kind))) == (tilt < 1e-6)


@steady
@given(bound=names, used=names)
def test_bindings_are_unused_where_no_document_has_the_name(
    bound: list[str], used: list[str]
) -> None:
    unused = dict.fromkeys(name for name in bound if name not in used)
    assert list(unused_bindings(bound, used)) == list(unused)


@steady
@given(vector=st.lists(lengths.filter(lambda x: not 0.0 < abs(x) < 1.0), min_size=3, max_size=3))
def test_millimetres_are_told_and_become_metres(vector: list[float]) -> None:
    written = ", ".join(map(str, vector))
    text = joint("elbow").replace("0.0, 0.0, 0.3", written)
    findings = found("KD502", chain_of(text))
    assert bool(findings) == any(abs(value) > GREATEST_LENGTH for value in vector)
    for finding in findings:
        assert finding.fix is not None
        fixed = apply_edits(chain_of(text), finding.fix.edits)
        changed = re.findall(r"translation = \(([^)]*)\)", fixed)[0].split(", ")
        assert [float(value) for value in changed] == pytest.approx([v / 1000.0 for v in vector])


def test_millimetres_beside_a_parameter_are_left_to_the_author() -> None:
    text = joint("elbow").replace("0.0, 0.0, 0.3", "425.0, reach, 0.0")
    assert [finding.fix for finding in found("KD502", chain_of(text))] == [None]


def chain_of(elbow: str) -> str:
    return robot(link("upper", 1), elbow, base="upper via elbow")


@steady
@given(before=blanks, after=blanks)
def test_a_repetition_goes_with_its_line_if_it_has_one(before: str, after: str) -> None:
    text = robot(link("arm", 1), base=f"arm via shoulder{before}@{after}", joints="shoulder")
    whole = text.replace("@", "arm via shoulder")
    (finding,) = found("KD207", whole)
    assert finding.fix is not None
    fixed = apply_edits(whole, finding.fix.edits)
    assert fixed.split() == text.replace("@", " ").split()
    line = re.search(r"[^\r\n]*@[^\r\n]*", text)
    assert line is not None
    stands_alone = line[0].strip() == "@"
    assert len(fixed.splitlines()) == len(whole.splitlines()) - stands_alone


IMPOSSIBLE = {
    "a negative mass": ("mass = 4.1", "mass = -4.1"),
    "a negative moment": ("Ix=0.0041", "Ix=-0.0041"),
    "three unlike moments": ("Ix=0.0041", "Ix=0.9"),
    "a plate": ("Ix=0.0041", "Ix=0.0082"),
    "a CoM far away": ("CoM = (0.0, 0.0, 0.0)", "CoM = (9.0, 0.0, 0.0)"),
}


@pytest.mark.parametrize("defect", IMPOSSIBLE)
def test_the_inertia_of_a_fixed_base_is_nobodys_business(defect: str) -> None:
    inertia = STEEL_BALL.replace(*IMPOSSIBLE[defect])
    told = {}
    for kind in ("", " floating"):
        text = robot(link("arm", 1), base="arm via shoulder", joints="shoulder")
        text = text.replace("ground {", f"ground{kind} {{\n    {inertia}", 1)
        place = text.index("inertia_params")
        end = text.index("children")
        findings = analyse(text).findings
        told[kind] = [f.code for f in findings if f.code < "KD4" and place <= f.start < end]
    assert told[""] == []
    assert told[" floating"] != []
