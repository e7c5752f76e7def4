"""The many ways in which an MJCF says where and how heavy things are: ours is what MuJoCo makes."""

import warnings
from pathlib import Path

import mujoco
import numpy as np
import pytest
from tests.interchange.mujoco_agreement import gap_of_imported
from tests.interchange.round_trips import mechanism_of, read

from kindsl.robots.interchange.kindsl_writing import kindsl_text
from kindsl.robots.interchange.registry import format_named

ARM = """<mujoco model="arm"><compiler/><default/><asset/>
<worldbody><geom type="box" size="1 1 1" mass="50"/><site name="mark" pos="1 2 3" euler="9 8 7"/>
<body name="base" pos="0.1 0.2 1.5" euler="20 30 40">{free}<geom type="box" size=".1 .2 .3"/>
<body name="upper" pos="0 0 1" axisangle="1 2 3 50"><joint name="shoulder" axis="1 2 2"/>
<joint name="twist" axis="0 1 0.2" pos="0.1 0.2 0.3" ref="20"/>
<geom name="rod" type="capsule" size="0.1" fromto="0 0 0 0.5 0.1 0.2" group="1"/>
<geom type="sphere" size="0.2" pos="0 0.3 0" density="300" group="3"/>
<site name="elbow" pos="0 1 0" zaxis="1 1 1"/>
<!--a--><body name="lower" pos="0 1 0" xyaxes="0 1 0 -1 0 0.3"><joint name="slider" type="slide"
ref="0.2" axis="0.3 1 0"/><geom type="cylinder" size="0.1 0.4" pos="0.3 0 0" euler="10 20 30"/>
<inertial pos="0.1 0 0" quat="1 2 3 4" mass="2" diaginertia="0.2 0.25 0.3"/>
<body name="tool" pos="0 0 0.5" quat="1 1 0 0"><geom type="ellipsoid" size="0.1 0.2 0.3"/>
<site name="tip" pos="0 0 0.1"/></body></body><!--b--></body></body></worldbody></mujoco>"""
MESH = '<asset><mesh name="m" vertex="0 0 0 1 0 0 0 1 0 0 0 1 1 1 .2" scale="-1 0.5 2"/></asset>'
COMPILERS = {
    "as it is": "",
    "radians": 'angle="radian"',
    "order of angles": 'eulerseq="ZYx"',
    "masses of shapes": 'inertiafromgeom="true"',
    "masses of some shapes": 'inertiagrouprange="0 1"',
    "total mass": 'settotalmass="12"',
    "least mass": 'boundmass="40" boundinertia="3"',
    "balanced": 'balanceinertia="true"',
    "static bodies fused": 'fusestatic="true"',
    "pictures discarded": 'discardvisual="true"',
}
DEFAULTS = '<default><joint axis="0 1 0" ref="30"/><geom density="77"/></default>'
CLASS = '<default><default class="c"><geom mass="3"/><joint pos="1 0 0"/></default></default>'
OTHERS = {
    "defaults": {"<default/>": DEFAULTS},
    "a class": {"<default/>": CLASS, '"upper"': '"upper" childclass="c"'},
    "full inertia": {
        'quat="1 2 3 4"': "",
        'diaginertia="0.2 0.25 0.3"': 'fullinertia="0.2 0.25 0.3 0.02 0.01 -0.02"',
    },
    "frames": {
        "<!--a-->": '<frame pos="1 0 0" euler="5 6 7"><site name="s"/>',
        "<!--b-->": "</frame>",
    },
    "mirrored mesh": {
        "<asset/>": MESH,
        'type="ellipsoid" size="0.1 0.2 0.3"': 'type="mesh" mesh="m"',
    },
    "shell": {'type="ellipsoid"': 'type="sphere" shellinertia="true"'},
    "unbalanced": {'0.25 0.3"': '0.25 0.9"', "<compiler/>": '<compiler balanceinertia="true"/>'},
    "many of one": {
        "<!--a-->": '<replicate count="3" offset="0.1 0 0" euler="0 0 20" sep="_">',
        "<!--b-->": "</replicate>",
    },
}
WAYS = {way: {"<compiler/>": f"<compiler {words}/>"} for way, words in COMPILERS.items()} | OTHERS


@pytest.mark.parametrize("free", ["", "<freejoint/>"], ids=["fixed", "free"])
@pytest.mark.parametrize("way", WAYS)
def test_what_mujoco_makes_of_it(way: str, free: str, tmp_path: Path) -> None:
    text = ARM.replace("{free}", free)
    for old, new in WAYS[way].items():
        assert old in text
        text = text.replace(old, new)
    _agrees(text, tmp_path)


def test_included_and_attached_files_have_their_own_ways(tmp_path: Path) -> None:
    """The attached one takes masses from shapes, and angles in radians; the other does not."""
    hand = """<mujoco model="hand"><compiler inertiafromgeom="true" angle="radian"/><worldbody>
    <body name="palm" euler="0.1 0.2 0.3"><joint name="grip" axis="0 1 0"/><geom size="0.2"/>
    <inertial pos="1 0 0" mass="9" diaginertia="1 1 1"/></body></worldbody></mujoco>"""
    (tmp_path / "hand.xml").write_text(hand)
    (tmp_path / "defaults.xml").write_text("<mujoco><compiler eulerseq='zyx'/></mujoco>")
    text = ARM.replace("{free}", "").replace("<compiler/>", '<include file="defaults.xml"/>')
    text = text.replace("<asset/>", '<asset><model name="hand" file="hand.xml"/></asset>')
    attach = '<attach model="hand" body="palm" prefix="left_"/><site name="tip"'
    _agrees(text.replace('<site name="tip"', attach), tmp_path)


def test_armature_is_the_one_difference_and_is_told(tmp_path: Path) -> None:
    text = ARM.replace("{free}", "")
    _agrees(text, tmp_path)
    text = text.replace('name="shoulder"', 'name="shoulder" armature="2.5"')
    ours, model, found = _both(text, tmp_path)
    apart = gap_of_imported(ours, model, np.random.default_rng(1))
    assert apart.inertia > 1e-2 and apart.bias < 1e-9
    assert found.joints["shoulder"].armature == 2.5


def _agrees(text: str, folder: Path) -> None:
    ours, model, _ = _both(text, folder)
    assert max(gap_of_imported(ours, model, np.random.default_rng(1))) < 1e-9


def _both(text: str, folder: Path) -> tuple:
    found = read(text, format_named("mjcf"), folder)
    with warnings.catch_warnings(action="ignore"):
        model = mujoco.MjModel.from_xml_path(str(folder / "robot.xml"))
    return mechanism_of(kindsl_text(found.robot)), model, found
