"""A number that gets a name, a name that becomes a number: what is written, and where."""

import pytest
from tests.features.samples import ARM, PARAMETRIC
from tests.support.cursor import at_cursor

from kindsl.frontends.features.actions.action import CodeAction
from kindsl.frontends.features.actions.named_numbers import extract_parameter, inline_parameter
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding

ROBCOGEN = Settings(frozenset({"robcogen"}))
JOINT = "r_joint j {{ ref_frame {{ translation = ({}, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }} }}"


def extracted(marked: str, settings: Settings | None = None) -> tuple[str, str, CodeAction] | None:
    """Return the new name, the new text and the action, None where nothing is offered."""
    analysis, offset = at_cursor(marked, settings)
    action = next(extract_parameter(analysis, offset, offset), None)
    if action is None:
        return None
    return action.title.split("'")[1], analysis.edited(action.edits).text, action


@pytest.mark.parametrize(
    ("link", "name"),
    [
        ("link hip { inertia_params { mass = $02.0 } }", "hip_mass"),
        ("link hip { inertia_params { CoM = (0.0, 0.0, $02.0) } }", "hip_com_z"),
        ("link hip { inertia_params { Ixy = $02.0 } }", "hip_ixy"),
        ("link ^link { inertia_params { mass = $02.0 } }", "link_mass"),
        ("link LF_Hip { inertia_params { mass = $02.0 } }", "lf_hip_mass"),
        ("link hip { frames { Foot { translation = (0.0, $02.0, 0.0) } } }", "foot_y"),
        ("r_joint Knee { ref_frame { translation = ($02.0, 0.0, 0.0) } }", "knee_x"),
        ("r_joint Knee { ref_frame { rotation = (0.0, 0.0, $02.0) } }", "knee_rz"),
        # Where a parameter begins with "pi", robcogen2 stops reading.
        ("link pitch { inertia_params { mass = $02.0 } }", "p_pitch_mass"),
        ("link PItch { inertia_params { mass = $02.0 } }", "p_pitch_mass"),
        ("link { inertia_params { mass = $02.0 } }", "mass"),
    ],
)
def test_the_name_of_a_number_tells_whose_it_is(link: str, name: str) -> None:
    found = extracted(link)
    assert found is not None
    assert found[:2] == (name, link.replace("$02.0", f"{name}[2.0]"))


@pytest.mark.parametrize("taken", ["parameter", "binding", "link", "joint"])
def test_the_name_is_one_that_nothing_has(taken: str) -> None:
    marked = ARM.replace("mass = 1.0", "mass = $01.0")
    settings = Settings()
    if taken == "parameter":
        marked = marked.replace("reach", "lower_mass")
    elif taken == "binding":
        settings = Settings(bindings={"lower_mass": Binding(1.0)})
    elif taken == "link":
        marked = marked.replace("upper", "lower_mass")
    else:
        marked = marked.replace("elbow", "lower_mass")
    assert extracted(marked, settings)[0] == "lower_mass_2"
    settings = settings._replace(bindings={**settings.bindings, "lower_mass_2": Binding(1.0)})
    assert extracted(marked, settings)[0] == "lower_mass_3"


@pytest.mark.parametrize(
    ("value", "written", "bound"),
    [
        ("2.5", "[2.5]", 2.5),
        ("+2.5", "[2.5]", 2.5),
        ("-2.5", "[-2.5]", -2.5),
        ("1e-3", "[1e-3]", 1e-3),
    ],
)
def test_the_value_stays_as_it_was_written(value: str, written: str, bound: float) -> None:
    marked = JOINT.format(f"$0{value}")
    assert extracted(marked)[1] == JOINT.format(f"j_x{written}")
    _, text, action = extracted(marked, ROBCOGEN)
    assert text == JOINT.format("j_x")
    assert action.bindings == (("j_x", bound),)


@pytest.mark.parametrize(
    "value",
    ["$01.0*x", "x[$01.0]", "<k=$01.0>", "$01.0/2.0", "($01.0)", "$0x", "$0PI", "$01", "1.0$0.2"],
)
def test_only_a_number_that_is_the_whole_value_gets_a_name(value: str) -> None:
    assert extracted(JOINT.format(value)) is None


def test_a_selection_that_goes_on_behind_the_number_names_nothing() -> None:
    text = JOINT.format("1.25")
    analysis, start = at_cursor(text.replace("1.25", "$01.25"))
    assert [*extract_parameter(analysis, start, start + 4)]
    assert not [*extract_parameter(analysis, start, start + 5)]


@pytest.mark.parametrize("marked", ["$0", "link hip { id = $01 }", "link hip { mass$0 = 1.0 }"])
def test_other_words_get_no_name(marked: str) -> None:
    assert extracted(marked) is None


def inlined(marked: str, bindings: dict[str, float] | None = None) -> str | None:
    """Return the text without the parameter, None where that is not offered."""
    values = {name: Binding(value) for name, value in (bindings or {}).items()}
    analysis, offset = at_cursor(marked, Settings(bindings=values))
    actions = [*inline_parameter(analysis, offset, offset)]
    assert len(actions) < 2
    return analysis.edited(actions[0].edits).text if actions else None


@pytest.mark.parametrize(
    ("value", "new"),
    [
        ("x$0", "0.5"),
        ("-$0x", "-0.5"),
        ("-$0x/2.0", "-0.25"),
        ("2.0*($0x)", "1.0"),
        ("$0x[3.0]", "0.5"),
        ("$0x*x", "0.25"),
        # What has another name in it is no number.
        ("$0x*y", None),
        ("$0x*<k=2.0>", None),
        ("y$0", None),
        # Of this, nobody knows what it comes to.
        ("$0x/0.0", None),
    ],
)
def test_a_whole_value_is_written_for_the_name_in_it(value: str, new: str | None) -> None:
    assert inlined(JOINT.format(value), {"x": 0.5}) == (new and JOINT.format(new))


def test_a_name_stays_where_one_of_its_places_cannot_do_without() -> None:
    assert inlined(JOINT.format("$0x") + JOINT.format("x*y"), {"x": 0.5, "y": 2.0}) is None
    both = JOINT.format("$0x") + JOINT.format("x/4.0")
    assert inlined(both, {"x": 0.5}) == JOINT.format("0.5") + JOINT.format("0.125")


def test_a_selection_that_goes_on_behind_the_name_inlines_nothing() -> None:
    settings = Settings(bindings={"width": Binding(0.5)})
    analysis, start = at_cursor(PARAMETRIC.replace("width/2.0", "$0width/2.0"), settings)
    assert [*inline_parameter(analysis, start, start + 5)]
    assert not [*inline_parameter(analysis, start, start + 6)]


def test_a_constant_is_not_inlined() -> None:
    assert inlined(JOINT.format("<$0k=1.0>")) is None


def test_a_parameter_that_the_robot_does_not_use_is_left_alone() -> None:
    """As in the second of two sections, of which the first counts."""
    twice = "link a { inertia_params { mass = 1.0 } inertia_params { mass = $0m } }"
    assert inlined(twice, {"m": 2.0}) is None
