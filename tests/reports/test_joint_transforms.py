"""The closed form of a joint's transform has the numbers of forward kinematics."""

from math import cos, sin

import numpy as np
import pytest
from tests.interchange.random_robots import random_robot

import kindsl
from kindsl.analysis.settings import Settings
from kindsl.interchange.kindsl_writing import kindsl_text
from kindsl.reports.joint_transforms import joint_transform

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
    return np.array([[eval(e.plain, {"__builtins__": {}}, names) for e in row] for row in rows])


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
    plain = [[entry.plain for entry in row] for row in rows]
    assert plain[0] == ["-cos(q)", "sin(q)", "0", "l_1"]
    assert plain[1] == ["0", "0", "-1", "0"]
    assert plain[2] == ["-sin(q)", "-cos(q)", "0", "0.5"]
    assert rows[0][3].latex == r"\mathrm{l\_1}"


def test_a_pose_that_is_not_whole_has_none() -> None:
    assert formulas("r_joint", "(0.0, 0.0)", "(0.0, 0.0, 0.0)")[1] is None
