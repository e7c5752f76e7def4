"""What pictures say of bodies is what the linter says of them."""

import re

import pytest
from tests.preview.robots import ARM

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.body_doubts import body_doubts
from kindsl.judgement.analysis.settings import Settings

IMPOSSIBLE = ARM.replace("Iz = 0.12", "Iz = 0.34")
UNITS = re.sub(r"I([xyz]) = \S+", r"I\1 = 1.0", ARM)


def doubted(text, settings=None):
    found = body_doubts(analyse(text, settings or Settings()).findings)
    return {link: [(d.code, d.is_error) for d in doubts] for link, doubts in found.items()}


def test_an_error_is_proved_and_a_warning_is_not():
    assert doubted(IMPOSSIBLE) == {"upper": [("KD302", True)]}
    away = ARM.replace("CoM = (0.2, 0.0, 0.0)", "CoM = (-20.0, 0.0, 0.0)")
    assert doubted(away) == {"upper": [("KD502", False)]}


@pytest.mark.parametrize(
    "text",
    [
        ARM,
        # Beyond the triangle by less than half a unit of the last digits: a hint.
        ARM.replace("Iz = 0.12", "Iz = 0.131"),
        ARM.replace("id = 2", "id = 1"),
        UNITS,
        f"// kindsl: ignore-file[KD302] of another maker\n{IMPOSSIBLE}",
    ],
    ids=["honest", "hint", "identity", "unmeasured", "suppressed"],
)
def test_nothing_else_is_doubted(text):
    assert text == ARM or analyse(text, Settings(select=("KD",))).findings
    assert doubted(text) == {}


def test_what_the_configuration_leaves_out_is_not_doubted():
    assert doubted(IMPOSSIBLE, Settings(ignore=("KD302",))) == {}


def test_a_body_that_is_called_otherwise_in_a_picture_is_doubted_by_both_names():
    text = """<?xml version="1.0"?>
    <robot name="r"><link name="base"/><link name="upper-arm"><inertial><mass value="1"/>
    <inertia ixx="0.1" iyy="0.1" izz="0.9" ixy="0" ixz="0" iyz="0"/></inertial></link>
    <joint name="j" type="continuous"><parent link="base"/><child link="upper-arm"/></joint>
    </robot>"""
    found = body_doubts(analyse(text).findings)
    assert found.keys() == {"upper-arm", "upper_arm"}


def test_what_is_told_once_of_several_bodies_is_doubted_of_each():
    link = """<link name="l{0}"><inertial><mass value="1.{0}"/>
    <inertia ixx="0.0000001{0}" iyy="0.0000001{0}" izz="0.0000001{0}" ixy="0" ixz="0" iyz="0"/>
    </inertial></link>"""
    joint = """<joint name="j{0}" type="revolute"><parent link="base"/><child link="l{0}"/>
    <origin xyz="0 0.{0} 0"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="9" velocity="9"/></joint>"""
    numbers = range(1, 7)
    inside = "".join((link + joint).format(n) for n in numbers)
    text = f'<?xml version="1.0"?>\n<robot name="r"><link name="base"/>{inside}</robot>'
    found = [f for f in analyse(text).findings if f.code == "KD311"]
    assert len(found) == 1, [f.message for f in analyse(text).findings]
    assert set(body_doubts(found)) == {f"l{n}" for n in numbers}
