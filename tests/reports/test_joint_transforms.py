"""The closed form of a joint's transform has the numbers of forward kinematics."""

from math import cos, sin

import numpy as np
import pytest
from tests.interchange.random_robots import random_robot

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.products.reports.joint_transforms import joint_transform
from kindsl.robots.interchange.kindsl_writing import kindsl_text

ARM = """Robot arm {{
RobotBase base {{ children {{ a via j }} }}
link a {{ id = 1 children {{}} }}
{word} j {{ ref_frame {{ translation = {translation} rotation = {rotation} }} }}
}}"""


def formulas(word: str, translation: str, rotation: str, **values: float):
    text = ARM.format(word=word, translation=translation, rotation=rotation)
    document = kindsl.parse(text, Settings())
    rows = joint_transform(document.model.joints[0], {**document.context.values, **values})
    return document, rows


def numbers(rows, names: dict[str, float]) -> np.ndarray:
    names = {**names, "cos": cos, "sin": sin}
    return np.array([[eval(e, {"__builtins__": {}}, names) for e in row] for row in rows])


@pytest.mark.parametrize("seed", range(12))
def test_closed_form_is_the_kinematics(seed: int) -> None:
    document = kindsl.parse(kindsl_text(random_robot(seed)), Settings())
    robot, q = document.mechanism(), 0.37
    poses = robot.forward_kinematics([q] * robot.n_joints)
    for edge in document.model.tree.edges:
        rows = joint_transform(edge.joint, document.context.values)
        parent = np.eye(4) if edge.predecessor.is_base else poses[str(edge.predecessor.name)]
        expected = np.linalg.inv(parent) @ poses[str(edge.child.link)]
        np.testing.assert_allclose(numbers(rows, {"q": q}), expected, atol=1e-9)


@pytest.mark.parametrize("word", ["r_joint", "p_joint"])
@pytest.mark.parametrize("rotation", ["(a, b, -2.0*c)", "(PI/2.0, b, PI)", "(0.0, -PI/2.0, c)"])
def test_parameters_stay_in_it(word: str, rotation: str) -> None:
    names = {"x": 0.2, "a": 0.3, "b": -0.7, "c": 1.1}
    document, rows = formulas(word, "(x/2.0, 0.5, -x)", rotation)
    robot = document.mechanism({n: v for n, v in names.items() if n in rotation or n == "x"})
    expected = robot.forward_kinematics([0.4])["a"]
    np.testing.assert_allclose(numbers(rows, {**names, "q": 0.4}), expected, atol=1e-12)


def test_quarter_turns_leave_no_function_of_a_constant() -> None:
    _, rows = formulas("r_joint", "(l_1, 0.0, 0.5)", "(PI/2.0, 0.0, PI)")
    assert rows[0] == ("-cos(q)", "sin(q)", "0", "l_1")
    assert rows[1] == ("0", "0", "-1", "0")
    assert rows[2] == ("-sin(q)", "-cos(q)", "0", "0.5")


def test_a_pose_that_is_not_whole_has_none() -> None:
    for translation, rotation in (
        ("(0.0, 0.0)", "(0.0, 0.0, 0.0)"),
        ("(0.0, 0.0, 0.0)", "(0.0, 0.0)"),
        ("(0.0, 0.0, 1.0/0.0)", "(0.0, 0.0, 0.0)"),
    ):
        assert formulas("r_joint", translation, rotation)[1] is None


@pytest.mark.parametrize(
    ("angle", "cosine", "sine"),
    [
        ("0.0", "cos(q)", "sin(q)"),
        ("PI/2.0", "-sin(q)", "cos(q)"),
        ("PI", "-cos(q)", "-sin(q)"),
        ("-PI/2.0", "sin(q)", "-cos(q)"),
        ("1.570796327", "-sin(q)", "cos(q)"),
        ("1.5708", "cos(q + 1.5708)", "sin(q + 1.5708)"),
        ("a", "cos(a + q)", "sin(a + q)"),
        ("-2.0*a", "cos(-2*a + q)", "sin(-2*a + q)"),
        ("a/4.0", "cos(0.25*a + q)", "sin(0.25*a + q)"),
    ],
)
def test_an_angle_is_what_is_left_without_quarter_turns(angle: str, cosine: str, sine: str) -> None:
    _, rows = formulas("r_joint", "(0.0, 0.0, 0.0)", f"(0.0, 0.0, {angle})")
    assert [row[0] for row in rows] == [cosine, sine, "0", "0"]


def test_the_last_row_is_that_of_any_transform() -> None:
    _, rows = formulas("r_joint", "(2.0*l_1, -a, 0.25)", "(0.3, 0.0, b)")
    assert rows[0][3] == "2*l_1" and rows[1][0] == "cos(0.3)*sin(b + q)"
    assert rows[3] == ("0", "0", "0", "1")


def test_a_coordinate_has_each_name_with_its_sign_and_no_zero() -> None:
    for written, plain in (
        ("-0.0", "0"), ("0.0*a", "0"), ("-1.5", "-1.5"), ("-a - 2.0*b", "-a - 2*b"),
        ("a - b - 0.5", "a - b - 0.5"), ("0.5 - a/4.0", "-0.25*a + 0.5"),
    ):  # fmt: skip
        _, rows = formulas("r_joint", f"({written}, 0.0, 0.0)", "(0.0, 0.0, 0.0)")
        assert rows is not None and rows[0][3] == plain, written


def test_a_slide_goes_along_the_turned_z() -> None:
    _, rows = formulas("p_joint", "(0.5, 0.0, 0.25)", "(-PI/2.0, 0.0, 0.0)")
    assert [row[3] for row in rows] == ["0.5", "q", "0.25", "1"]
    _, rows = formulas("p_joint", "(0.5, 0.0, 0.25)", "(0.0, -PI/2.0, 0.0)")
    assert [row[3] for row in rows] == ["0.5 - q", "0", "0.25", "1"]
    _, rows = formulas("p_joint", "(0.5, 0.0, 0.25)", "(a, 0.0, 0.0)")
    assert [row[3] for row in rows] == ["0.5", "-sin(a)*q", "0.25 + cos(a)*q", "1"]
