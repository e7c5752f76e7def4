"""A xacro file judged where it stands: what it expands to, at the places that this comes from."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.analysis.test_urdf_in_place import PLATE, TENSOR
from tests.cli.conftest import Runner

Linted = Callable[..., list[tuple[str, ...]]]
HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="arm">'
LIMIT = '<limit lower="{lower}" upper="1" effort="9" velocity="9"/>'
PARTS = f"""{HEAD}
<xacro:macro name="rod" params="name parent tensor:='' lower:=-1 *placement">
  <link name="${{name}}"><inertial><xacro:insert_block name="placement"/><mass value="2"/>
    <inertia {TENSOR}/></inertial></link>
  <joint name="to_${{name}}" type="revolute"><parent link="${{parent}}"/><child link="${{name}}"/>
    {LIMIT.format(lower="${lower}")}</joint>
</xacro:macro></robot>
"""
ARM = f"""{HEAD}
<xacro:include filename="parts.xacro"/>
<link name="base"/>
<xacro:rod name="upper" parent="base"><origin xyz="0 0 0"/></xacro:rod>
<xacro:rod name="lower" parent="upper"><origin xyz="0 0 0"/></xacro:rod>
</robot>
"""


@pytest.fixture
def told(kdsl_lint: Runner, folder: Path) -> Linted:
    def linted(arm: str = ARM, parts: str = PARTS, *names: str) -> list[tuple[str, ...]]:
        (folder / "arm.urdf.xacro").write_text(arm)
        (folder / "parts.xacro").write_text(parts)
        done = kdsl_lint("--output-format", "json", *(names or ("arm.urdf.xacro",)))
        texts = {name: (folder / name).read_text() for name in ("arm.urdf.xacro", "parts.xacro")}
        found = []
        for each in json.loads(done.out):
            line = texts[each["path"]].splitlines()[each["start"]["line"] - 1]
            at = line[each["start"]["column"] - 1 : each["end"]["column"] - 1]
            found.append((each["path"], each["code"], at))
        return found

    return linted


def test_a_sound_robot_has_no_finding(told: Linted) -> None:
    assert told() == []


def test_a_literal_number_is_told_in_the_file_that_holds_it(told: Linted) -> None:
    at = '<limit lower="5" upper="1" effort="9" velocity="9"/>'
    parts = PARTS.replace('lower="${lower}"', 'lower="5"')
    assert at in parts
    assert told(ARM, parts) == [("parts.xacro", "KD521", "5")] * 2


def test_what_is_computed_is_told_at_its_attribute(told: Linted) -> None:
    arm = ARM.replace('name="lower" parent', 'name="lower" lower="5" parent')
    assert told(arm) == [("parts.xacro", "KD521", "${lower}")]


def test_what_is_given_to_a_macro_is_told_where_that_is(told: Linted) -> None:
    arm = ARM.replace('xyz="0 0 0"', 'xyz="0 0 0,5"', 1)
    assert ("arm.urdf.xacro", "KD005", "0 0 0,5") in told(arm)


def test_an_element_is_told_once_for_each_link(told: Linted) -> None:
    parts = PARTS.replace(TENSOR, PLATE)
    assert told(ARM, parts) == [("parts.xacro", "KD302", "<inertial>")] * 2


def test_macros_alone_and_folders_say_nothing(told: Linted, folder: Path) -> None:
    bad = PARTS.replace(TENSOR, PLATE)
    assert told(ARM, bad, "parts.xacro") == []
    assert told(ARM, bad, ".") == []
    (folder / "kindsl.toml").write_text('include = ["*.urdf.xacro"]\n')
    assert len(told(ARM, bad, ".")) == 2


def test_packages_are_where_the_failure_says(
    told: Linted, kdsl_lint: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    arm = ARM.replace("parts.xacro", "$(find parts_of_arm)/parts.xacro")
    (folder / "arm.urdf.xacro").write_text(arm)
    failure = kdsl_lint("arm.urdf.xacro").err
    assert "'parts_of_arm'" in failure and "add a folder to ROS_PACKAGE_PATH" in failure
    (folder / "ws" / "parts_of_arm").mkdir(parents=True)
    (folder / "ws" / "parts_of_arm" / "package.xml").write_text("<package/>")
    (folder / "ws" / "parts_of_arm" / "parts.xacro").write_text(PARTS)
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(folder / "ws"))
    assert told(arm) == []


def test_what_cannot_be_expanded_is_a_failure(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "arm.xacro").write_text(ARM)
    done = kdsl_lint("arm.xacro")
    assert done.status == 2
    assert "arm.xacro: error: xacro cannot expand it" in done.out + done.err
