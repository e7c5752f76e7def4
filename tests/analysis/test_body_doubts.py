"""What pictures say of bodies is what the linter says of them."""

import re

import pytest
from tests.preview.robots import ARM

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.body_doubts import body_doubts
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.analysis.translated_robot import analysed_robot

IMPOSSIBLE = ARM.replace("Iz = 0.12", "Iz = 0.34")
UNITS = re.sub(r"I([xyz]) = \S+", r"I\1 = 1.0", ARM)


def doubted(text, settings=None):
    analysis = analyse(text, settings or Settings())
    found = body_doubts(analysis, analysis.findings)
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


INERTIA = """<inertial><mass value="1"/>
<inertia ixx="0.001" iyy="0.001" izz="0.00{0}" ixy="0" ixz="0" iyz="0"/></inertial>"""
ALIKE = f"""<?xml version="1.0"?>
<robot name="r"><link name="base"/>
<link name="a_b">{INERTIA.format(1)}</link><link name="a-b">{INERTIA.format(9)}</link>
<link name="holder">{INERTIA.format(1)}</link><link name="tool">{INERTIA.format(9)}</link>
<joint name="j" type="continuous"><parent link="base"/><child link="a_b"/></joint>
<joint name="k" type="continuous"><parent link="a_b"/><child link="a-b"/></joint>
<joint name="l" type="continuous"><parent link="a-b"/><child link="holder"/></joint>
<joint name="m" type="fixed"><parent link="holder"/><child link="tool"/></joint>
</robot>"""


def test_a_body_is_doubted_by_its_name_in_the_picture():
    robot = analysed_robot("r.urdf", ALIKE, Settings())
    assert [str(body.name) for body in robot.model.bodies] == ["base", "a_b", "a_b_link", "holder"]
    assert {f.subject.name for f in robot.findings if f.code == "KD302"} == {"a-b", "tool"}
    assert body_doubts(robot, robot.findings).keys() == {"a_b_link", "holder"}


def test_a_body_of_the_picture_is_found_in_the_file():
    robot = analysed_robot("r.urdf", ALIKE, Settings())
    spans = [robot.resolver.span(link) for link in robot.model.links]
    assert [ALIKE[start:end] for start, end in spans] == ["a_b", "a-b", "holder"]


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
    assert set(body_doubts(analyse(text), found)) == {f"l{n}" for n in numbers}
