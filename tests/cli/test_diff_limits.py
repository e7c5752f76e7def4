"""Limits of joints that are others are noted by `kindsl diff`, and no difference of mechanics."""

from pathlib import Path

from tests.cli.conftest import Runner

URDF = """<robot name="arm">
<link name="base"/>
<link name="upper"><inertial><origin xyz="0.1 0 0"/><mass value="1.3"/>
<inertia ixx="0.01" iyy="0.04" izz="0.04" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="slide"><inertial><mass value="0.3"/>
<inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="elbow" type="revolute"><parent link="base"/><child link="upper"/>
<axis xyz="{axis}"/><limit lower="{low}" upper="{high}" effort="{effort}" velocity="2.0"/></joint>
<joint name="rail" type="prismatic"><parent link="upper"/><child link="slide"/>
<axis xyz="1 0 0"/><limit lower="0" upper="{rail}" effort="30.0" velocity="0.5"/></joint>
</robot>
"""


def written(
    *, axis: str = "0 1 0", low: str = "-0.5", high: str = "1.5708", effort: str = "40.0",
    rail: str = "0.25",
) -> str:  # fmt: skip
    return URDF.format(axis=axis, low=low, high=high, effort=effort, rail=rail)


def notes(kindsl: Runner, text: str) -> list[str]:
    """Return what is noted of limits in a URDF beside the document of the usual one."""
    Path("arm.urdf").write_text(written())
    assert kindsl("convert", "-q", "arm.urdf", "arm.kindsl").status == 0
    Path("other.urdf").write_text(text)
    run = kindsl("diff", "arm.kindsl", "other.urdf")
    assert run.status == 0, run.out
    return [line for line in run.out.splitlines() if "imum of" in line or "greatest" in line]


def test_equal_limits_are_not_spoken_of(kindsl: Runner, folder: Path) -> None:
    assert notes(kindsl, written()) == []
    assert notes(kindsl, written(high="1.570796")) == []


def test_the_limit_that_is_another_is_noted(kindsl: Runner, folder: Path) -> None:
    assert notes(kindsl, written(low="-0.6", effort="45.0", rail="0.2")) == [
        "note: minimum of joint 'elbow' is -0.5 rad here and -0.6 rad in other.urdf",
        "note: greatest effort of joint 'elbow' is 40 N m here and 45 N m in other.urdf",
        "note: maximum of joint 'rail' is 0.25 m here and 0.2 m in other.urdf",
    ]


def test_limits_of_a_joint_that_turns_the_other_way_change_places(
    kindsl: Runner, folder: Path
) -> None:
    turned = written(axis="0 -1 0", low="-1.5708", high="0.5")
    assert notes(kindsl, turned) == []
    assert notes(kindsl, turned.replace("0.5", "0.7", 1)) == [
        "note: minimum of joint 'elbow' is -0.5 rad here and -0.7 rad in other.urdf"
    ]
