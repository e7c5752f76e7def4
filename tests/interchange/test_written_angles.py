"""Numbers of an imported robot as a person would write them: `PI/2.0` where it is one."""

import re
from math import pi

import pytest

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import pose_from
from kindsl.robots.interchange.kindsl_writing import inertia_texts, joint_text, kindsl_text
from kindsl.robots.interchange.sdf.sdf_reading import robot_of_sdf
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf
from kindsl.robots.mechanism.linkage import BodyPart, RigidBody

URDF = """<robot name="arm"><link name="base"/><link name="upper"/><link name="camera"/>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
<origin rpy="{rpy}"/><axis xyz="0 0 1"/><limit effort="1" velocity="1"/></joint>
<joint name="mount" type="fixed"><parent link="upper"/><child link="camera"/>
<origin rpy="{mount}"/></joint></robot>"""
SDF = """<sdf version="1.9"><model name="arm"><link name="base"/><link name="upper">
<pose>0 0 0 {rpy}</pose></link><joint name="fix" type="fixed"><parent>world</parent>
<child>base</child></joint><joint name="shoulder" type="revolute"><parent>base</parent>
<child>upper</child><axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"""


def rotations(text: str) -> list[str]:
    return re.findall(r"rotation = \((.*)\)", text)


@pytest.mark.parametrize(
    ("rpy", "written"),
    [
        ("1.57079632679 0 0", "PI/2.0, 0.0, 0.0"),
        ("-1.5707963267949 0 0", "-PI/2.0, 0.0, 0.0"),
        ("0 0 3.14159265359", "0.0, 0.0, PI"),
        ("0 0.785398163397 0", "0.0, PI/4.0, 0.0"),
        ("0.523598775598 0 0", "PI/6.0, 0.0, 0.0"),
        ("1.0471975512 0 0", "PI/3.0, 0.0, 0.0"),
        ("1.57079632679 0 1.57079632679", "PI/2.0, PI/2.0, 0.0"),
        ("1.5708 0 0", "1.5708, 0.0, 0.0"),
        ("0 0 1.570796327", "0.0, 0.0, 1.570796327"),
        ("0 0 2.617993877991", "0.0, 0.0, 2.617993877991494"),
    ],
)
def test_a_fraction_of_a_turn_is_one(rpy: str, written: str) -> None:
    urdf = kindsl_text(robot_of_urdf(URDF.format(rpy=rpy, mount="0 0 0"), "arm").robot)
    assert rotations(urdf)[-1] == written
    assert rotations(kindsl_text(robot_of_sdf(SDF.format(rpy=rpy), "arm").robot))[-1] == written


def test_an_inertia_has_fifteen_digits_as_numbers_that_were_computed_are_good_for() -> None:
    dust = 0.1 + 0.2  # 0.30000000000000004
    body = MassDistribution(
        10.0 * dust, (dust, 0.0, -1e-16), (dust, 1e-3 / 3.0, 0.25, 0.0, 0.0, 0.0)
    )
    mass, com, *moments = inertia_texts(body)
    assert (mass, com) == ("3.0", "(0.3, 0.0, 0.0)")
    assert moments == ["0.3", "0.000333333333333", "0.25", "0.0", "0.0", "0.0"]


def test_at_a_quarter_turn_about_y_rounding_makes_no_two_angles() -> None:
    zero = (0.0, 0.0, 0.0)
    pose = pose_from(zero, (0.3, pi / 2.0, 0.0)).then(pose_from(zero, (0.0, 0.0, 0.4)))
    body = RigidBody((BodyPart("upper"),), 0, "shoulder", "revolute", pose)
    x, y, z = rotations(joint_text(body, "shoulder"))[0].split(", ")
    assert (float(x), y, z) == (pytest.approx(0.7, abs=1e-14), "PI/2.0", "0.0")
