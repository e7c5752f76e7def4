import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.features.samples import ARM, PARAMETRIC
from tests.support.cursor import at_cursor
from tests.support.published import published_models

from kindsl.frontends.features.code_lenses import code_lenses
from kindsl.frontends.features.inlay_hints import InlayHintOptions, inlay_hints
from kindsl.frontends.features.signature_help import signature_help
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding

ALL_HINTS = InlayHintOptions(units=True)


def hints(text, options=ALL_HINTS, bindings=None):
    analysis = analyse(text, Settings(bindings=bindings or {}))
    return [
        (text[: hint.offset].rsplit(None, 1)[-1], hint.text, hint.kind)
        for hint in inlay_hints(analysis, 0, len(text), options)
    ]


def test_angles_are_hinted_in_degrees():
    assert ("(-PI/2.0", "-90°", "angle") in hints(ARM)
    assert not [h for h in hints(ARM) if h[1] == "0°"]


def test_values_of_expressions_are_hinted_where_they_are_known():
    assert ("2.0*<offset>", "= 0.1", "value") in hints(PARAMETRIC)
    found = hints(PARAMETRIC, bindings={"width": Binding(0.3)})
    assert ("(width/2.0", "= 0.15", "value") in found
    assert not [h for h in hints(PARAMETRIC) if h[0].startswith("(width")]


def test_plain_numbers_need_no_hint():
    assert not [h for h in hints(ARM.replace("0.25, 0.0", "- 0.25, 0.0")) if h[2] == "value"]


def test_a_moving_body_is_hinted_as_the_box_that_has_its_inertia():
    found = [hint for hint in hints(ARM) if hint[2] == "inertia"]
    assert [hint[1] for hint in found] == [
        "as a 173 × 173 × 648 mm box of 0.1 g/cm³",
        "as a 245 × 245 × 624 mm box of 0.027 g/cm³",
    ]


def test_an_impossible_body_is_hinted_by_its_moments():
    found = hints(PARAMETRIC.replace("Iz=0.001", "Iz=0.1"), bindings={"width": Binding(0.3)})
    texts = [text for _, text, kind in found if kind == "inertia"]
    assert texts[-1] == "about CoM 0.009, 0.009, 0.1 kg·m²"


@pytest.mark.parametrize("path", published_models())
def test_hints_fit_the_43_characters_that_vs_code_shows(path):
    assert all(len(text) <= 43 for _, text, _ in hints(path.read_text()))


@given(st.floats(1e-30, 1e30), st.lists(st.floats(-1e100, 1e100), min_size=3, max_size=3))
@settings(deadline=None, derandomize=True)
def test_an_inertia_is_told_in_what_an_editor_shows_of_a_hint(mass, moments):
    """VS Code shows 43 characters."""
    numbers = " ".join(f"{name}={m!r}" for name, m in zip(("Ix", "Iy", "Iz"), moments, strict=True))
    body = f"mass = {mass!r} CoM = (0.0, 0.0, 0.0) {numbers} Ixy=0.0 Ixz=0.0 Iyz=0.0"
    ((_, text, _),) = hints(f"link l {{ inertia_params {{ {body} }} }}", InlayHintOptions())
    assert len(text) <= 43


@pytest.mark.parametrize(("mass", "side"), [("1e-6", 1e4), ("2e5", 1.2e-3), ("1e30", 77777.0)])
def test_the_hint_of_an_odd_box_is_no_longer(mass, side):
    moment = float(mass) * side**2 / 6
    numbers = " ".join(f"{name}={moment!r}" for name in ("Ix", "Iy", "Iz"))
    body = f"mass = {mass} CoM = (0.0, 0.0, 0.0) {numbers} Ixy=0.0 Ixz=0.0 Iyz=0.0"
    ((_, text, _),) = hints(f"link l {{ inertia_params {{ {body} }} }}", InlayHintOptions())
    assert len(text) <= 43


def test_hints_can_be_turned_off():
    assert hints(PARAMETRIC, InlayHintOptions(False, False, False, False)) == []
    assert {h[2] for h in hints(ARM, InlayHintOptions(units=True))} > {"unit", "angle"}


def test_hints_of_a_range():
    analysis = analyse(ARM)
    start = ARM.index("r_joint shoulder")
    assert [h.text for h in inlay_hints(analysis, start, len(ARM))] == ["-90°"]


@pytest.mark.parametrize(
    ("marked", "label", "active"),
    [
        (ARM.replace("(-PI/2.0,", "(-PI/2.$00,"), "rotation = (rx, ry, rz)", 0),
        (ARM.replace("(0.25, 0.0,", "(0.25, $00.0,"), "CoM = (x, y, z)", 1),
        ("r_joint j { ref_frame { translation = ($0", "translation = (x, y, z)", 0),
        ("r_joint j { ref_frame { translation = (1.0, 2.0,$0", "translation = (x, y, z)", 2),
        ("r_joint j { ref_frame { rotation = (1.0, , , ,$0)", "rotation = (rx, ry, rz)", 2),
        ("link l { inertia_params { CoM (1.0,$0", "CoM = (x, y, z)", 1),
        ("link l { inertia_params { CoM = ((1.0)/2.0,$0", "CoM = (x, y, z)", 1),
    ],
)
def test_a_vector_tells_its_components(marked, label, active):
    signature = signature_help(*at_cursor(marked))
    assert signature is not None
    assert (signature.label, signature.active) == (label, active)
    first = signature.parameters[0]
    assert signature.label[first.start : first.end] in ("x", "rx")


@pytest.mark.parametrize(
    "marked",
    [
        ARM.replace("(-PI/2.0, 0.0, 0.0)", "(-PI/2.0, 0.0, 0.0)$0", 1),
        ARM.replace("mass = ", "mass = $0", 1),
        "Robot R { $0",
        "link l { mass = (1.0$0",
    ],
)
def test_elsewhere_there_is_no_vector(marked):
    assert signature_help(*at_cursor(marked)) is None


def test_lenses_tell_what_is_carried_and_where_it_is_named():
    lenses = [(ARM[s.start : s.end], s.kind, s.title) for s in code_lenses(analyse(ARM))]
    assert lenses == [
        ("Arm", "preview", "▶ Preview"),
        ("base", "subtree", "carries 2 joints, 3 kg"),
        ("upper", "references", "1 reference"),
        ("upper", "subtree", "carries 1 joint, 3 kg with itself"),
        ("lower", "references", "1 reference"),
        ("shoulder", "references", "1 reference"),
        ("elbow", "references", "1 reference"),
    ]
