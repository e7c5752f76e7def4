"""What is offered for sections, children, joints and values, with what is told beside it."""

import re

import pytest
from tests.support.cursor import at_cursor

from kindsl.frontends.features.completion import snippets
from kindsl.frontends.features.completion.completion import completions
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding

BASE = "Robot R {\nRobotBase b { children { l via j } }\n"
LINK = BASE + "link l { "
INERTIA = LINK + "inertia_params { "
FRAME = BASE + "r_joint j { ref_frame { "
SECTIONS = ["id", "inertia_params", "children", "children {}", "frames"]
ALL_MOMENTS = ["Ix … Iyz", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz", "ref_frame"]
M, X = (("m", "dynamics parameter, unbound"), ("x", "dynamics parameter, unbound"))
FRACTIONS = [("2.0", "90°"), ("4.0", "45°"), ("3.0", "60°"), ("6.0", "30°")]
DIVISORS = [(number, "") for number, _ in FRACTIONS]


def offered(marked, settings=None):
    return [(i.label, i.detail) for i in completions(*at_cursor(marked, settings)).items]


def labels(marked):
    return [label for label, _ in offered(marked)]


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        (INERTIA + "mass = 1.0 $0 Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.0 Ixz=0.0 Iyz=0.0 }", ["CoM"]),
        (INERTIA + "CoM = (0.0, 0.0, 0.0) $0 }", ALL_MOMENTS),
        (INERTIA + "Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.0 $0", ["Ixz … Iyz", "Ixz", "Iyz", "ref_frame"]),
        (INERTIA + "Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.0 $0 Iyz=0.0 }", ["Ixz"]),
        (INERTIA + "Ix=1.0 $0 Iy=1.0 Iz=1.0 Ixy=0.0 Ixz=0.0 Iyz=0.0 }", []),
        (INERTIA + "$0 mass = 1.0 }", []),
        (INERTIA + "ref_frame = f $0", []),
        (LINK + "$0 frames { } }", ["id", "inertia_params", "children", "children {}"]),
        (LINK + "$0 id = 1 }", []),
        (LINK + "children { } $0 }", ["frames"]),
        (LINK + "frames { } $0 }", []),
        (BASE + "r_joint j { id = 1 $0 }", ["ref_frame"]),
        (BASE + "r_joint j { $0 ref_frame { } }", ["id"]),
        (BASE + "r_joint j { ref_frame { $0 rotation = (0.0, 0.0, 0.0) } }", ["translation"]),
        (BASE + "link l { } link k { $0 } link m { }", SECTIONS),
        ("Robot R {\nRobotBase $0", []),
        ("Robot R {\nRobotBase b $0 {", ["floating"]),
        ("RobotBase b { }\n$0", ["Robot", "link"]),
        ("Robot R {\nlink l { }\n$0", ["r_joint", "p_joint"]),
        ("Robot R {\nr_joint j { }\n$0", []),
        ("Robot R {\n$0link l { } }", ["RobotBase", "RobotBase floating"]),
        (BASE + "$0link l { } }", ["link"]),
        (BASE + "link k { }\n$0\nlink l { } }", ["link"]),
        (BASE + "link k { } }\n$0", []),
        (BASE + "link k { }\n$0r_joint j { } }", ["link", "r_joint", "p_joint"]),
    ],
)  # fmt: skip
def test_sections_and_blocks_that_fit_between_their_neighbours(marked, expected):
    assert labels(marked) == expected


@pytest.mark.parametrize(
    ("marked", "label", "text"),
    [
        (BASE + "$0", "link", "link l { id = 1 "),
        (BASE + "link l { id = 1 }\n$0", "link", "link link1 { id = 2 "),
        (BASE + "link l { id = 1 }\n$0", "r_joint", "r_joint j { "),
        (BASE + "link l { id = 1 }\n$0", "p_joint", "p_joint j { "),
        (BASE + "link l { id = 1 }\n$0\nr_joint j { }", "r_joint", "r_joint joint1 { "),
        (BASE + "link l { children { c via k } }\nr_joint j { }\n$0", "r_joint", "r_joint k { "),
        (BASE + "link l { $0 }", "id", "id = 1"),
        (BASE + "link a { id = 1 } link l { $0 }", "id", "id = 2"),
        (BASE + "link l { id = 4 }\nr_joint j { $0 }", "id", "id = 4"),
        (BASE + "link l { id = 4 }\nr_joint k { $0 }", "id", "id = 1"),
        (BASE + "link l { id = x }\nr_joint k { id = 1 }\nr_joint j { $0 }", "id", "id = 2"),
        (BASE + "link l { $0 }", "children", "children { link1 via joint1 }"),
        (BASE + "link l { $0 }\nlink k { }", "children", "children { k via k_joint }"),
        (BASE + "link l { $0 }\nlink k { }\nr_joint x { }", "children", "children { k via x }"),
        (BASE + "link l { $0 }\nr_joint j { }", "children", "children { link1 via joint1 }"),
        (BASE + "link l { $0 }", "children {}", "children {}"),
        (BASE + "link l { inertia_params { ref_frame = eye } frames { $0", "eye", "eye { "),
    ],
)
def test_what_is_written_knows_what_is_there(marked, label, text):
    found = completions(*at_cursor(marked)).items
    assert [i.plain_text[: len(text)] for i in found if i.label == label] == [text]
    assert all(item.is_snippet for item in found if "$" in item.text)


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        (
            BASE + "link l { children { $0 } } link a { } link c { } p_joint k { }",
            [
                ("a via …", "not yet attached"),
                ("c via …", "not yet attached"),
                ("a", "not yet attached"),
                ("c", "not yet attached"),
                ("link1 via k", "new child"),
            ],
        ),
        (
            BASE + "link a { children { $0 } } link l { }",
            [("link1 via joint1", "new child"), ("l", "child of b already")],
        ),
        # The child that is typed does not count as one.
        (
            BASE + "link a { children { $0c via k } } link c { }",
            [
                ("c via …", "not yet attached"),
                ("c", "not yet attached"),
                ("link1 via joint1", "new child"),
            ],
        ),
        # Neither itself, also while it is not closed, nor what carries it, however far above.
        (
            BASE + "link l { children { m via k } } link m { children { n via o } }\n"
            "link n { children { $0 } }",
            [("link1 via joint1", "new child")],
        ),
        (
            BASE + "link a { children { $0\n\nlink l { }",
            [("link1 via joint1", "new child"), ("l", "child of b already")],
        ),
        (
            BASE + "link m { children { n via o } } link n { children { m via k $0 } } link l { }",
            [("link1 via joint1", "new child"), ("l", "child of b already")],
        ),
        (
            BASE + "link a { children { x via j2 y via $0 } } r_joint j2 { } p_joint k { }",
            [("k", "prismatic, free"), ("j2", "revolute, moves x already")],
        ),
        (
            BASE + "link a { children { x via $0k } } p_joint k { } r_joint j { }",
            [("k", "prismatic, free"), ("j", "revolute, moves l already")],
        ),
        (
            BASE + "link a { children { y via $0 } } p_joint j { }",
            [("y_joint", "new joint"), ("j", "prismatic, moves l already")],
        ),
        (
            BASE + "link a { children { y via $0z } } p_joint j { } r_joint { }",
            [("y_joint", "new joint"), ("j", "prismatic, moves l already")],
        ),
        (BASE + "link a { children { y $0", [("via", "joint between the two links")]),
        (
            BASE + "link l { inertia_params { ref_frame = eye } frames { $0",
            [("eye", "used, not declared"), ("frame", "a frame of this link")],
        ),
        (
            BASE + "link l { inertia_params { ref_frame = eye } frames { eye { } $0",
            [("frame", "a frame of this link")],
        ),
        (
            BASE + "link l { children { k via o } } link $0",
            [("k", "named as a child, not declared")],
        ),
        (BASE + "link l { children { k via j } } r_joint $0", [("j", "used, not declared")]),
        (BASE + "link l { id = $0 }", [("1", "next free id")]),
        (BASE + "r_joint j { id = $0 }", [("1", "id of its link")]),
        (BASE + "r_joint j { id = $01 }", [("1", "id of its link")]),
        (BASE + "link l { id = $01 } link k { id = 2 }", [("1", "next free id")]),
        (
            BASE + "link l { inertia_params { ref_frame = $0 } frames { eye { } { } } }",
            [("eye", "frame of this link")],
        ),
    ],
)
def test_names_tell_what_they_are(marked, expected):
    assert offered(marked) == expected


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        (INERTIA + "mass = $0", []),
        (INERTIA + "Ix = $0", []),
        (INERTIA + "Iy = $0", []),
        (INERTIA + "Iz = $0", []),
        (INERTIA + "Ixy = $0", [("0.0", "kg·m²")]),
        (INERTIA + "mass = m CoM = (x, $0", [M, X, ("0.0", "m")]),
        (INERTIA + "mass = m[2.0] Ix = 2.0*$0", [("m", "dynamics parameter, 2")]),
        (INERTIA + "mass = m*$0m", [M]),
        (INERTIA + "mass = m CoM = (n$0", []),
        (INERTIA + "mass = nn CoM = (n$0", [("nn", "dynamics parameter, unbound")]),
        (INERTIA + "mass = n CoM = ($0n", [("n", "dynamics parameter, unbound"), ("0.0", "m")]),
        (INERTIA + "mass = 2.0/$0", DIVISORS),
        (INERTIA + "mass = <c=1.0> CoM = (<d>, <$0", [("c", "constant, 1"), ("d", "constant")]),
        (INERTIA + "mass = 3.0*$0 CoM = (<c=1.0>", [("<c>", "constant, 1")]),
        (FRAME + "rotation = (a, 2.0*$0", [("a", "angle parameter, unbound"), ("PI", "180°")]),
        (FRAME + "translation = (2.0*$0", []),
        (FRAME + "translation = ($0", [("0.0", "m")]),
        (FRAME + "rotation = (PI/$0", FRACTIONS),
        (FRAME + "rotation = (PI + 1.0/$0", DIVISORS),
    ],
)  # fmt: skip
def test_values_that_fit_the_place(marked, expected):
    assert offered(marked) == expected


def test_a_bound_parameter_tells_its_value():
    settings = Settings(bindings={"m": Binding(0.5)})
    found = offered(INERTIA + "mass = m Ix = $0", settings)
    assert found == [("m", "dynamics parameter, 0.5")]


@pytest.mark.parametrize(
    "block",
    [
        snippets.robot(),
        snippets.base(""),
        snippets.base("floating"),
        snippets.link("l", 1),
        snippets.joint("r_joint", "j"),
        snippets.section("inertia"),
        snippets.section("frames"),
        snippets.section("joint_frame"),
        snippets.children("link", "joint"),
    ],
)
def test_each_placeholder_of_a_block_is_visited_once_in_its_order(block):
    numbers = [int(number) for number in re.findall(r"\$\{(\d+):", block)]
    names = 2 if block == snippets.robot() else 0
    assert len(set(numbers)) == len(numbers) - names
    assert list(dict.fromkeys(numbers)) == list(range(1, len(numbers) - names + 1))


def test_placeholders_are_counted_from_one():
    texts = {i.label: i.text for i in completions(*at_cursor(INERTIA + "$0")).items}
    assert texts["CoM"] == "CoM = (${1:0.0}, ${2:0.0}, ${3:0.0})"
    assert texts["Ix … Iyz"].split("\n")[::5] == ["Ix = ${1:0.01}", "Iyz = ${6:0.0}"]
    assert texts["Iz"] == "Iz = ${1:0.01}"
