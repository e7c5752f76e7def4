"""The model: what is there, of whole and of broken documents."""

from math import pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.language.semantics.declarations import ValueKind
from kindsl.language.semantics.expressions import half_unit
from kindsl.language.semantics.kinematic_tree import KinematicTree
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import values_of
from kindsl.language.semantics.transforms import frame_names
from kindsl.language.syntax.document import parse

POSE = "ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }"


def model_of(text: str) -> Model:
    return Model(parse(text))


def robot(children: dict[str, str], base: str = "b") -> Model:
    """A robot from `{"a": "b c"}`: a carries b and c, each through the joint `j_NAME`."""
    blocks = []
    for number, (name, carried) in enumerate(children.items()):
        edges = " ".join(f"{child} via j_{child}" for child in carried.split())
        head = f"RobotBase {name}" if name == base else f"link {name}"
        ident = "" if name == base else f"id = {number}"
        blocks.append(f"{head} {{ {ident} children {{ {edges} }} }}")
    blocks += [f"r_joint j_{name} {{ {POSE} }}" for name in children if name != base]
    return model_of("Robot R {\n" + "\n".join(blocks) + "\n}")


def loops(tree: KinematicTree) -> list[list[str]]:
    return [[str(edge.predecessor.name) for edge in loop] for loop in tree.loops]


def names(links: object) -> list[str]:
    return [str(link.name) for link in links]  # type: ignore[attr-defined]


def test_tree() -> None:
    tree = (model := robot({"b": "x y", "x": "z", "y": "", "z": ""})).tree
    assert names(tree.in_topological_order(model.bases[0])) == ["x", "y", "z"]
    z = model.body_named["z"]
    edge = tree.supporting_edge(z)
    assert edge is not None and edge.predecessor.name == "x" and edge.joint is not None
    assert edge.joint.name == "j_z" and not tree.loops


def test_edges_to_what_is_not_declared_lead_nowhere() -> None:
    model = model_of("Robot R { RobotBase b { children { x via i  y via j } } link x { id = 1 } }")
    tree = model.tree
    assert [(edge.link, edge.joint) for edge in tree.edges] == [
        (model.links[0], None),
        (None, None),
    ]
    assert [*tree.above] == model.links
    assert not tree.joint_uses
    assert tree.reachable == {*model.bases, *model.links}


def test_without_a_base_nothing_is_reached() -> None:
    model = model_of("Robot R { link x { id = 1 children { y via j } } link y { id = 2 } }")
    assert model.tree.reachable == set()
    assert frame_names(model) == {"fr_x": "x", "fr_y": "y"}


@pytest.mark.parametrize(
    ("children", "expected"),
    [
        ({"b": "x", "x": "x"}, [["x"]]),
        ({"b": "x", "x": "y", "y": "x"}, [["x", "y"]]),
        ({"b": "x", "x": "", "y": "z", "z": "y"}, [["y", "z"]]),
        ({"b": "x y", "x": "z", "y": "z", "z": ""}, []),
        ({"b": "x", "x": "y z", "y": "x", "z": "x"}, [["x", "y"], ["x", "z"]]),
    ],
)
def test_each_loop_once(children: dict[str, str], expected: list[list[str]]) -> None:
    assert loops(robot(children).tree) == expected


@settings(max_examples=60, deadline=None)
@given(st.lists(st.integers(0, 7), min_size=1, max_size=8))
def test_a_random_forest_has_no_loop_and_a_back_edge_makes_one(parents: list[int]) -> None:
    bodies = {"b": "", **{f"l{i}": "" for i in range(len(parents))}}
    order = list(bodies)
    for i, parent in enumerate(parents):
        above = order[min(parent, i)]
        bodies[above] = f"{bodies[above]} l{i}"
    tree = (model := robot(bodies)).tree
    assert not tree.loops and len(tree.reachable) == len(bodies)
    deepest = names(tree.in_topological_order(model.bases[0]))[-1]
    bodies[deepest] = f"{bodies[deepest]} {deepest}"
    assert loops(robot(bodies).tree) == [[deepest]]


VALUES = {
    "1.5": 1.5,
    "-.5": -0.5,
    "PI": pi,
    "-PI/2.0": -pi / 2,
    "2.0 PI": 2 * pi,
    "2.0*x": 6.0,
    "2.0 x": 6.0,
    "x/2": 1.5,
    "-x": -3.0,
    "x[7.0]": 3.0,
    "y[7.0]": 7.0,
    "y": None,
    "<k=2.5>": 2.5,
    "<k>/2.0": 1.25,
    "- 1.0": -1.0,
    "1.0/0.0": None,
    "3.0*PI/4.0": 3 * pi / 4,
    "(1.0 + x) - 0.5": 3.5,
}


def length_of(value: str) -> tuple[Model, float | None, float]:
    model = model_of(
        "Robot R { RobotBase b { children { l via j } } link l { id = 1 children {} }\n"
        f"r_joint j {{ ref_frame {{ translation = ({value}, <k=2.5>, 0.0) "
        "rotation = (0.0, 0.0, 0.0) } } }"
    )
    values = values_of(model.parameters, model.constants, {"x": 3.0})
    translation = model.joints[0].pose.translation
    assert translation is not None
    expression = translation.components[0]
    return model, expression.value(values), expression.rounding(values)


@pytest.mark.parametrize("value", VALUES)
def test_values(value: str) -> None:
    expected = VALUES[value]
    found = length_of(value)[1]
    assert found == (None if expected is None else pytest.approx(expected))


@pytest.mark.parametrize(
    ("value", "half"),
    [("1.50", 0.005), ("2.0*1.5", 0.175), ("PI", 0.0), ("12.", 0.5), ("1.5e-3", 5e-5)],
)
def test_rounding_follows_the_digits_written(value: str, half: float) -> None:
    assert length_of(value)[2] == pytest.approx(half)


@given(st.decimals(allow_nan=False, allow_infinity=False, places=4))
def test_half_unit(number: object) -> None:
    assert half_unit(f"{number:f}") == pytest.approx(0.5e-4)


def test_parameters_have_a_class_from_their_places() -> None:
    model = model_of(
        "Robot R { RobotBase b { children { l via j } } link l { id = 1\n"
        "inertia_params { mass = m CoM = (x, 0.0, 0.0) Ix = m Iy = 1.0 Iz = 1.0 Ixy = 0.0\n"
        "Ixz = 0.0 Iyz = 0.0 } children {} }\n"
        "r_joint j { ref_frame { translation = (x[0.5], 0.0, 0.0) rotation = (a, 0.0, 0.0) } } }"
    )
    kinds = {str(p.name): [use.kind for use in p.uses] for p in model.parameters}
    assert kinds == {
        "m": [ValueKind.DYNAMICS, ValueKind.DYNAMICS],
        "x": [ValueKind.DYNAMICS, ValueKind.LENGTH],
        "a": [ValueKind.ANGLE],
    }
    assert {str(p.name): p.value for p in model.parameters} == {"m": None, "x": 0.5, "a": None}
    for parameter in model.parameters:
        for use in parameter.uses:
            place = use.name
            assert place.island.text[place.start : place.end] == parameter.name


@pytest.mark.parametrize(
    ("value", "number", "parameters"),
    [
        ("PI[0.5]", 0.5, []),
        ("[0.5]", 0.5, []),
        ("<=0.5>", 0.5, []),
        ("<>", None, []),
        ("PI[y]", None, ["y"]),
        ("PI[x]/2.0", 1.5, ["x"]),
    ],
)
def test_what_has_no_name_is_no_parameter(
    value: str, number: float | None, parameters: list[str]
) -> None:
    """Else hovers, sliders and `info` list a parameter without a name."""
    model, found, _ = length_of(value)
    assert found == number
    assert [str(parameter.name) for parameter in model.parameters] == parameters
    assert [str(constant.name) for constant in model.constants] == ["k"]


def test_the_first_default_that_is_a_number_counts() -> None:
    model = length_of("x[1.0/0.0] + x + x[2.0] + x[3.0]")[0]
    (parameter,) = model.parameters
    assert parameter.value == 2.0


def test_what_an_island_uses_is_collected_once() -> None:
    syntax = parse("Robot R {\nr_joint j { ref_frame { translation = (x, 0.0, 0.0) } }")
    assert all(a is b for a, b in zip(Model(syntax).symbols, Model(syntax).symbols, strict=True))


def test_a_broken_document_keeps_what_is_there() -> None:
    model = model_of(
        "Robot R { RobotBase b floating { children { l via j } } link l { id = 1 frames {"
    )
    assert (model.name, model.floating, [str(n) for n in names(model.links)]) == ("R", True, ["l"])
    assert model.links[0].id == 1 and model.links[0].inertia is None
    assert [(str(c.link), str(c.joint)) for c in model.bases[0].children] == [("l", "j")]


@settings(max_examples=100, deadline=None)
@given(st.text(alphabet="Robt linkvia{}=()1.0,xy/*\n<>[]-PIj_", max_size=200))
def test_no_text_stops_the_model(text: str) -> None:
    model = model_of("Robot R { RobotBase b { children { x via j } }\nlink x { id = 1 " + text)
    assert model.base is not None
    for body in model.bodies:
        for expression in body.values():
            assert expression.start <= expression.end
    assert model.tree.reachable and model.parameters is not None


@pytest.mark.parametrize("piece", ["2.0*", "2.0/", "- ", "1.0 + ", "(", "-", "x["])
@pytest.mark.parametrize("tail", ["x, 1.0", "x, 1.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }"])
def test_endless_expressions_exhaust_nothing(piece: str, tail: str) -> None:
    text = "Robot R {\nr_joint j { ref_frame { translation = (0.0, " + piece * 3000 + tail
    model = model_of(text)
    assert model.broken_islands
    for joint in model.joints:
        for expression in joint.values():
            assert expression.value({}) is None or expression.rounding({}) >= 0.0
    assert len(model.parameters) <= 1
