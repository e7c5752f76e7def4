"""A drag writes one number, in the author's hand, and nothing else."""

import random
from math import pi, radians
from pathlib import Path

import pytest
from tests.support.amount import usually
from tests.support.models import random_model

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.handles import handles
from kindsl.frontends.features.manipulation.set_component import ComponentChange, set_component
from kindsl.frontends.features.manipulation.things import Thing
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.language.syntax.scanner import scan
from kindsl.language.syntax.value_forms import accepted_by
from kindsl.language.text.edits import TextEdit, apply_edits
from kindsl.robots.mechanism.reading import named_frames

ROOT = Path(__file__).parents[3]
N_DRAGS = usually(500, thoroughly=2000)
FILES = [
    *sorted((ROOT / "examples").glob("*.kindsl")),
    *sorted((ROOT.parent / "shared" / "corpus").glob("*.kindsl")),
]
JOINT = """\
Robot r {{ RobotBase base {{ children {{ a via j }} }}
link a {{ id = 1 children {{}} frames {{ tip {{ translation = ({x}, l, 0.0)
rotation = (0.0, 0.0, 0.0) }} }} }}
r_joint j {{ ref_frame {{ translation = ({x}, 0.0, 0.0) rotation = ({rx}, 0.0, 0.0) }} }} }}
"""
EVERY_FORM = (
    "0.350", "0.0", "-0.5", "007.50", "+1.0", ".5", "1.", "1e-3", "x", "-x", "x/2.0", "-x/2.0",
    "2.0*x", "2.0 x", "-2.0 x", "x/2", "x[1.0]", "-x[1.0]", "2.0*x[1.0]", "x[1.0]/2.0", "<k=1.0>",
    "-<k=1.0>", "2.0*<k=1.5>", "<k=1.0>/2.0", "1.0/3.0", "PI", "-PI", "PI/2.0", "-PI/2.0", "PI/.5",
    "PI/2", "2*PI", "2.0 PI", "pitch", "^link",
)  # fmt: skip


def things(analysis: Analysis):
    model = analysis.model
    yield from (Thing("joint", name) for name in model.joint_named)
    yield from (Thing("frame", name) for name, _, _ in named_frames(model.bodies))
    yield from (Thing("com", name) for name in model.body_named)


def all_values(analysis: Analysis) -> dict:
    return {
        (thing, handle.component): (handle.value, handle.text, handle.symbol)
        for thing in things(analysis)
        for handle in handles(analysis, thing)
    }


def documents():
    yield from (file.read_text(encoding="utf-8", errors="surrogateescape") for file in FILES)
    yield from (random_model(links, links) for links in (1, 3, 8, 20))
    for form in EVERY_FORM:
        yield JOINT.format(x=form, rx=form)


def random_drag(generator: random.Random, old: float, is_angle: bool):
    step = generator.choice([None, radians(15), radians(5)] if is_angle else [None, 0.01, 0.001])
    reach = 3.0 if is_angle else 0.5
    new = round(old + generator.uniform(-reach, reach), 6)
    return new, step


def assert_one_number_changed(analysis, before, thing, handle, new, step):
    change = set_component(analysis, thing, handle.component, new, step)
    if isinstance(change, Refusal):
        assert handle.locked or handle.value is None
        return 0
    wanted = new if step is None else round(new / step) * step
    if change.preview:
        assert not change.edits and handle.symbol == change.preview[0][0]
        return 0
    moved = analysis.edited(change.edits)
    after = all_values(moved)
    assert after[thing, handle.component][0] == pytest.approx(change.value, abs=1e-12)
    scale = abs(handle.value) if handle.symbol else 1.0
    assert change.value == pytest.approx(wanted, abs=1e-9 * max(1.0, scale, abs(wanted)))
    for key, (value, text, symbol) in after.items():
        if key != (thing, handle.component) and symbol != handle.symbol:
            assert (value, text) == before[key][:2]
    assert len(change.edits) <= 1 or handle.symbol
    assert_undone(analysis.text, moved.text, change.edits)
    assert len(syntax_errors(moved)) <= len(syntax_errors(analysis))
    for edit in change.edits:
        assert accepted_by(list(scan(edit.text))) == {"robcogen", "robcogen2"}
    return len(change.edits)


def assert_undone(old: str, new: str, edits):
    back, shift = [], 0
    for edit in edits:
        start = edit.start + shift
        back.append(TextEdit(start, start + len(edit.text), old[edit.start : edit.end]))
        shift += len(edit.text) - (edit.end - edit.start)
    assert apply_edits(new, back) == old


def syntax_errors(analysis):
    return [finding for finding in analysis.findings if finding.code.startswith("KD0")]


def test_any_drag_changes_one_number():
    generator = random.Random(15)
    analyses = [(analysis, all_values(analysis)) for analysis in map(analyse, documents())]
    n_edits = 0
    for _ in range(N_DRAGS):
        analysis, before = generator.choice(analyses)
        thing = generator.choice(list(things(analysis)))
        handle = generator.choice(list(handles(analysis, thing)))
        new, step = random_drag(generator, handle.value or 0.0, handle.component.startswith("r"))
        n_edits += assert_one_number_changed(analysis, before, thing, handle, new, step)
    assert n_edits > N_DRAGS / 2


@pytest.mark.parametrize(
    ("old", "value", "step", "new"),
    [
        ("0.350", 0.3612, 0.01, "0.360"),
        ("0.35", 0.3612, 0.001, "0.361"),
        ("0.0", 0.3612, 0.01, "0.36"),
        ("0.35", 0.004, 0.01, "0.0"),
        ("0.35", -0.12345678949, None, "-0.1234567895"),
        ("1e-3", 0.25, 0.01, "0.25"),
        ("0.0", 1.0, 1.0, "1.0"),
    ],
)
def test_lengths(old, value, step, new):
    change = set_component(
        analyse(JOINT.format(x=old, rx="0.0")), Thing("joint", "j"), "x", value, step
    )
    assert change.text == new


@pytest.mark.parametrize(
    ("old", "degrees", "new"),
    [
        ("0.0", 90, "PI/2.0"),
        ("0.0", -15, "-PI/12.0"),
        ("PI/2.0", 180, "PI"),
        ("PI/2.0", 120, "PI/1.5"),
        ("PI/2.0", 360, "PI/0.5"),
        ("PI", 0, "0.0"),
        ("PI/2.0", 135, "2.3561944902"),
        ("1.5708", 30, "0.5235987756"),
        ("2.0*PI", 75, "PI/2.4"),
    ],
)
def test_angles(old, degrees, new):
    analysis = analyse(JOINT.format(x="0.0", rx=old))
    assert (
        set_component(analysis, Thing("joint", "j"), "rx", radians(degrees), radians(5)).text == new
    )


@pytest.mark.parametrize(
    ("old", "value", "new"),
    [
        ("x[1.0]", 0.25, "x[0.25]"),
        ("-x[1.00]", 0.25, "-x[-0.25]"),
        ("2.0*x[1.0]", 0.5, "2.0*x[0.25]"),
        ("<k=1.0>", -0.5, "<k=-0.5>"),
        ("<k=1.0>/2.0", 0.5, "<k=1.0>/2.0"),
    ],
)
def test_defaults_and_constants_are_solved_for(old, value, new):
    analysis = analyse(JOINT.format(x=old, rx="0.0"))
    change = set_component(analysis, Thing("joint", "j"), "x", value)
    assert f"translation = ({new}, 0.0, 0.0)" in analysis.edited(change.edits).text


@pytest.mark.parametrize("old", ["<k={}>", "x[{}]"])
def test_all_places_that_give_a_symbol_its_value_are_written(old):
    analysis = analyse(JOINT.format(x=old.format("1.0"), rx="0.0"))
    change = set_component(analysis, Thing("joint", "j"), "x", 0.5)
    assert analysis.edited(change.edits).text.count(old.format("0.5")) == 2


def test_a_bound_parameter_is_bound_anew():
    settings = Settings(bindings={"x": Binding(0.3, 0.2, 0.5, "kindsl.toml")})
    analysis = analyse(JOINT.format(x="-x/2.0", rx="0.0"), settings)
    change = set_component(analysis, Thing("joint", "j"), "x", -0.2, 0.01)
    assert change == ComponentChange("Set x of joint 'j'", "0.4", -0.2, bindings=(("x", 0.4),))
    refused = set_component(analysis, Thing("joint", "j"), "x", -0.3)
    assert refused == Refusal("parameter 'x' would be out of bounds at 0.6")


def test_an_unbound_parameter_moves_in_the_preview_only():
    analysis = analyse(JOINT.format(x="x", rx="0.0"))
    change = set_component(analysis, Thing("joint", "j"), "x", 0.25)
    assert change == ComponentChange("Set x of joint 'j'", "0.25", 0.25, preview=(("x", 0.25),))


def test_a_card_says_what_moves_along():
    analysis = analyse(JOINT.format(x="x[0.5]", rx="0.0"))
    first = next(handles(analysis, Thing("joint", "j")))
    assert first.symbol == "x"
    assert first.moves_along == ("frame 'tip' translation x",)


@pytest.mark.parametrize(
    ("thing", "name", "value", "reason"),
    [
        (Thing("joint", "k"), "x", 0.1, "there is no joint 'k'"),
        (Thing("joint", "j"), "q", 0.1, "joint 'j' has no component 'q'"),
        (Thing("com", "a"), "x", 0.1, "link 'a' has no inertia section"),
        (Thing("com", "base"), "x", 0.1, "link 'base' has no inertia section"),
        (Thing("joint", "j"), "x", float("nan"), "a component takes a finite number"),
        (Thing("wheel", "j"), "x", 0.1, "there is no wheel 'j'"),
    ],
)
def test_refusals(thing, name, value, reason):
    analysis = analyse(JOINT.format(x="0.1", rx="0.0"))
    assert set_component(analysis, thing, name, value) == Refusal(reason)


def test_a_step_is_no_divisor_that_makes_a_value_infinite():
    analysis = analyse(JOINT.format(x="0.1", rx="0.0"))
    refused = set_component(analysis, Thing("joint", "j"), "x", 1e308, 1e-300)
    assert refused == Refusal("a component takes a finite number")


def test_broken_numbers_are_locked():
    analysis = analyse(JOINT.format(x="0.1.2", rx=f"{pi:.15f}"))
    assert isinstance(set_component(analysis, Thing("joint", "j"), "x", 0.5), Refusal)
    assert isinstance(set_component(analysis, Thing("joint", "j"), "rx", 0.5), ComponentChange)
