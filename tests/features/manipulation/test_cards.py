"""What a card of the picture shows of a thing's numbers, form by form."""

import pytest

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.handles import handles
from kindsl.frontends.features.manipulation.things import (
    Carrier,
    Component,
    Thing,
    carrying_frame,
    component,
)
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding

ROBOT = """\
Robot r {{ RobotBase base {{ children {{ a via j }} }}
link a {{ id = 1 {inertia} children {{}} frames {{ {frames} }} }}
r_joint j {{ ref_frame {{ translation = ({x}, 0.5, 0.0) rotation = ({rx}, 0.0, 0.0) }} }} }}
"""
J = Thing("joint", "j")
FRAME = "{} {{ translation = ({}, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }}"


def robot(x: str = "0.0", rx: str = "0.0", frames: str = "", inertia: str = "") -> Analysis:
    return analyse(ROBOT.format(x=x, rx=rx, frames=frames, inertia=inertia))


def number_of(x: str) -> Component:
    found = component(robot(x).model, J, "x")
    assert isinstance(found, Component)
    return found


@pytest.mark.parametrize(
    ("text", "key", "factor"),
    [
        ("x", "x", 1.0),
        ("-x", "x", -1.0),
        ("2.0 x", "x", 2.0),
        ("-2.0 x", "x", -2.0),
        ("x[3.0]", "x", 1.0),
        ("<k=3.0>", "<k>", 1.0),
        ("<k>", "<k>", 1.0),
        ("2.0*x", "x", 2.0),
        ("-2.0*x", "x", -2.0),
        ("4.0*<k>", "<k>", 4.0),
        ("x/4.0", "x", 0.25),
        ("x/-4.0", "x", -0.25),
        ("-x/4.0", "x", -0.25),
        ("-<k>/4.0", "<k>", -0.25),
    ],
)
def test_a_value_is_a_name_times_a_number(text: str, key: str, factor: float) -> None:
    expression, carrier = number_of(text)
    assert isinstance(carrier, Carrier)
    name = str(carrier.use.name)
    assert (f"<{name}>" if "<" in key else name) == key
    assert carrier.factor == pytest.approx(factor, rel=1e-15)
    if "[" not in text and "=" not in text:
        assert expression.value({key: 7.0}) == pytest.approx(7.0 * factor, rel=1e-15)


@pytest.mark.parametrize("text", ["1.0", "PI", "2.0*PI", "1.0/3.0"])
def test_no_name_carries_a_number(text: str) -> None:
    assert number_of(text).carrier is None


@pytest.mark.parametrize("text", ["x/0.0", "0.0*x", "-0.0*x", "0.0 x"])
def test_what_is_always_zero_is_not_solved(text: str) -> None:
    assert number_of(text).carrier == Refusal(f"'{text}' cannot be solved for one name")


@pytest.mark.parametrize(
    "text", ["x*x", "x*2.0", "2.0/x", "x/y", "x+1.0", "(x)", "x/(2.0)", "0x1 x"]
)
def test_what_no_generator_takes_is_carried_by_nothing(text: str) -> None:
    assert component(robot(text).model, J, "x") == Refusal(f"'{text}' is not a valid value")


@pytest.mark.parametrize(
    ("x", "symbol", "locked"),
    [
        ("0.25", "", ""),
        ("1.0/4.0", "", ""),
        ("x/4.0", "x", ""),
        ("<k=1.0>/4.0", "k", ""),
        ("x/0.0", "", "'x/0.0' cannot be solved for one name"),
        ("x+y", "", "'x+y' is not a valid value"),
        ("0.1.2", "", "'0.1.2' is not a valid value"),
        ("", "", "component x of joint 'j' is missing"),
    ],
)
def test_a_card_says_what_carries_a_number_and_what_locks_it(
    x: str, symbol: str, locked: str
) -> None:
    first = next(handles(robot(x), J, {"x": 1.0}))
    assert (first.component, first.symbol, first.locked) == ("x", symbol, locked)
    if not locked:
        assert (first.text, first.value) == (x, 0.25)


def test_a_card_shows_what_the_preview_shows() -> None:
    settings = Settings(bindings={"x": Binding(2.0)})
    analysis = analyse(ROBOT.format(x="x", rx="0.0", frames="", inertia=""), settings)
    assert next(handles(analysis, J)).value == 2.0
    assert next(handles(analysis, J, {"x": 3.0})).value == 3.0


def test_a_card_has_six_numbers_and_that_of_a_centre_of_mass_three() -> None:
    analysis = robot(inertia="inertia_params { mass = 1.0 CoM = (0.1, 0.2, 0.3) }")
    assert [h.component for h in handles(analysis, J)] == ["x", "y", "z", "rx", "ry", "rz"]
    found = [(h.component, h.value) for h in handles(analysis, Thing("com", "a"))]
    assert found == [("x", 0.1), ("y", 0.2), ("z", 0.3)]


@pytest.mark.parametrize(
    ("x", "frames", "along"),
    [
        ("x", FRAME.format("f", "x") + FRAME.format("g", "x/2.0"),
         ("frame 'f' translation x", "frame 'g' translation x")),
        ("x/2.0", FRAME.format("f", "x*x"), ("frame 'f' translation x",)),
        ("<k=1.0>", FRAME.format("f", "<k>") + FRAME.format("g", "<l=1.0>"),
         ("frame 'f' translation x",)),
        ("x", FRAME.format("f", "y"), ()),
        ("<k=1.0>", FRAME.format("f", "<l=1.0>") + FRAME.format("g", "<k>"),
         ("frame 'g' translation x",)),
    ],
)  # fmt: skip
def test_a_card_tells_each_other_place_of_the_name(
    x: str, frames: str, along: tuple[str, ...]
) -> None:
    assert next(handles(robot(x, frames=frames), J)).moves_along == along


def test_what_moves_along_may_stand_in_the_same_vector() -> None:
    analysis = analyse(ROBOT.format(x="x", rx="0.0", frames="", inertia="").replace("0.5", "-x"))
    assert next(handles(analysis, J)).moves_along == ("joint 'j' translation y",)


@pytest.mark.parametrize(
    ("thing", "name", "reason"),
    [
        (Thing("joint", "k"), "x", "there is no joint 'k'"),
        (Thing("frame", "k"), "x", "there is no frame 'k'"),
        (Thing("com", "k"), "x", "there is no com 'k'"),
        (Thing("wheel", "b"), "x", "there is no wheel 'b'"),
        (Thing("joint", "twice"), "x", "2 joints are named 'twice'"),
        (Thing("com", "a"), "x", "link 'a' has no inertia section"),
        (Thing("com", "b"), "rx", "com 'b' has no component 'rx'"),
        (Thing("joint", "half"), "rz", "joint 'half' has no component 'rz'"),
        (Thing("joint", "half"), "z", "component z of joint 'half' is missing"),
    ],
)
def test_what_has_no_number_says_why(thing: Thing, name: str, reason: str) -> None:
    extra = "r_joint twice {} r_joint twice {}"
    extra += " r_joint half { ref_frame { translation = (0.1, 0.2, ) } }"
    extra += " link b { inertia_params { CoM = (0.1, 0.2, 0.3) } }"
    assert component(
        analyse(ROBOT.format(x=0, rx=0, frames="", inertia="") + extra).model, thing, name
    ) == Refusal(reason)


def test_each_component_is_the_number_of_its_axis() -> None:
    text = "r_joint j { ref_frame { translation = (0.1, 0.2, 0.3) rotation = (0.4, 0.5, 0.6) } }"
    names = ("x", "y", "z", "rx", "ry", "rz")
    found = [component(analyse(text).model, J, name) for name in names]
    assert [each.expression.text for each in found] == ["0.1", "0.2", "0.3", "0.4", "0.5", "0.6"]


def test_a_frame_is_meant_by_the_name_that_it_is_drawn_with() -> None:
    """Of two frames with one name the second is drawn with its link's before it."""
    links = "".join(
        f"link {link} {{ id = {number} children {{}} frames {{ {FRAME.format('f', value)} }} }}\n"
        for number, (link, value) in enumerate((("a", 0.1), ("b", 0.2)), 1)
    )
    analysis = analyse(f"Robot r {{ RobotBase base {{ children {{ a via j b via k }} }}\n{links}}}")
    assert component(analysis.model, Thing("frame", "f"), "x").expression.text == "0.1"
    assert component(analysis.model, Thing("frame", "b.f"), "x").expression.text == "0.2"


@pytest.mark.parametrize(
    ("kind", "name", "inertia", "frame"),
    [
        ("com", "a", "inertia_params { CoM = (0.1, 0.2, 0.3) ref_frame = f }", "f"),
        ("com", "a", "inertia_params { CoM = (0.1, 0.2, 0.3) ref_frame = g }", "g"),
        ("com", "a", "inertia_params { CoM = (0.1, 0.2, 0.3) }", ""),
        ("com", "a", "inertia_params { CoM = (0.1, 0.2, 0.3) ref_frame = h }", ""),
        ("com", "a", "", ""),
        ("com", "q", "inertia_params { ref_frame = f }", ""),
        ("frame", "a", "inertia_params { ref_frame = f }", ""),
    ],
)
def test_a_centre_of_mass_moves_along_the_axes_that_it_is_written_in(
    kind: str, name: str, inertia: str, frame: str
) -> None:
    frames = FRAME.format("f", "0.0") + FRAME.format("g", "0.0")
    assert carrying_frame(robot(frames=frames, inertia=inertia).model, Thing(kind, name)) == frame
