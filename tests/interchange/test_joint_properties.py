"""Limits, effort, speed and friction of joints: into kindsl.toml and back, in every format."""

from pathlib import Path

import pytest
from tests.interchange.round_trips import read

import kindsl
from kindsl.frontends.cli.main import main
from kindsl.language.semantics.parameters import JointProperties
from kindsl.robots.interchange.format import AS_WRITTEN, WritingChoices
from kindsl.robots.interchange.registry import format_named

URDF = """<robot name="arm"><link name="base"/><link name="upper"/><link name="lower"/>
<link name="wheel"/>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
<axis xyz="0 -1 0"/><limit lower="-2.8973" upper="1.75" effort="87" velocity="2.175"/>
<dynamics damping="0.5" friction="0.25"/></joint>
<joint name="1-slide" type="prismatic"><parent link="upper"/><child link="lower"/>
<limit lower="0" upper="0.3" effort="12" velocity="0.5"/></joint>
<joint name="roll" type="continuous"><parent link="lower"/><child link="wheel"/></joint></robot>"""
SHOULDER = JointProperties(-2.8973, 1.75, 87.0, 2.175, damping=0.5, friction=0.25)
SLIDE = JointProperties(0.0, 0.3, 12.0, 0.5)


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    path = tmp_path / "arm.urdf"
    path.write_text(URDF)
    return path


def test_a_new_configuration_tells_of_joints(arm: Path, capsys) -> None:
    target = arm.with_suffix(".kindsl")
    assert main(["convert", str(arm), str(target)]) == 0
    told = kindsl.load(target)
    assert {n: told.settings.joints[n] for n in ("shoulder", "_1_slide")} == {
        "shoulder": SHOULDER, "_1_slide": SLIDE,
    }  # fmt: skip
    assert f"{arm.parent / 'kindsl.toml'} now tells limits, friction and armature of 2 joints" in (
        capsys.readouterr().err
    )
    again = arm.with_name("again.urdf")
    assert main(["convert", "--continuous", str(target), str(again)]) == 0
    found = format_named("urdf").read(again, AS_WRITTEN)
    assert dict(found.joints) == {"shoulder": SHOULDER, "_1_slide": SLIDE}


@pytest.mark.parametrize("name", ["kindsl.toml", "pyproject.toml"])
def test_the_configuration_that_applies_keeps_what_it_tells(name: str, arm: Path, capsys) -> None:
    head = "[tool.kindsl]" if name == "pyproject.toml" else ""
    prefix = "tool.kindsl." if head else ""
    before = f"{head}\n# ours\ntarget = 'robcogen'\n[{prefix}joints.shoulder]\nmin = -1\n"
    (arm.parent / name).write_text(before)
    folder = arm.parent / "robots"
    folder.mkdir()
    target = folder / "arm [1].kindsl"
    assert main(["convert", str(arm), str(target)]) == 0
    after = (arm.parent / name).read_text()
    assert after.startswith(before) and not (folder / "kindsl.toml").exists()
    found = kindsl.load(target).settings
    assert found.targets == {"robcogen"}
    assert found.joints["shoulder"] == JointProperties(-1.0)
    assert found.joints["_1_slide"] == SLIDE
    assert main(["convert", str(arm), str(target)]) == 0
    assert (arm.parent / name).read_text() == after
    assert main(["lint", str(target)]) in (0, 1)
    assert "kindsl.toml" not in capsys.readouterr().out


@pytest.mark.parametrize("options", [["--no-config"], ["--isolated"]])
def test_nothing_is_written_beside_where_that_is_asked(
    options: list[str], arm: Path, capsys
) -> None:
    assert main(["convert", *options, str(arm), str(arm.with_suffix(".kindsl"))]) == 0
    assert not (arm.parent / "kindsl.toml").exists()
    assert "of 2 joints dropped: kindsl.toml takes them" in capsys.readouterr().err


def test_a_configuration_that_cannot_be_extended_stays(arm: Path, capsys) -> None:
    file = arm.parent / "kindsl.toml"
    file.write_text('document = [{path = "other.kindsl"}]\n')
    before = file.read_text()
    assert main(["convert", str(arm), str(arm.with_suffix(".kindsl"))]) == 0
    assert file.read_text() == before
    assert "of 2 joints dropped: kindsl.toml takes them" in capsys.readouterr().err
    file.write_text("nonsense = 1\n")
    arm.with_suffix(".kindsl").unlink()
    assert main(["convert", str(arm), str(arm.with_suffix(".kindsl"))]) == 2
    assert not arm.with_suffix(".kindsl").exists()


@pytest.mark.parametrize("name", ["urdf", "mjcf", "sdf"])
def test_every_format_gives_back_what_is_told(name: str, tmp_path: Path) -> None:
    document = kindsl.load(Path(__file__).parents[2] / "examples" / "industrial_arm.kindsl")
    told = dict(zip(document.mechanism().joint_names, (SHOULDER, SLIDE), strict=False))
    if name == "mjcf":
        told = {joint: own._replace(velocity=None, armature=0.1) for joint, own in told.items()}
    format = format_named(name)
    text = format.write("arm", document.skeleton(), WritingChoices(True, told)).text
    found = read(text, format, tmp_path).joints
    assert {joint: found[joint] for joint in told} == told
