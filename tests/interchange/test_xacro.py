"""xacro files: arguments, macros and includes become the robot they mean; what never ends does."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from tests.interchange.round_trips import gaps, mechanism_of

from kindsl.frontends.cli.main import main
from kindsl.robots.interchange.format import AS_WRITTEN, FormatError, ReadingChoices
from kindsl.robots.interchange.kindsl_writing import kindsl_text
from kindsl.robots.interchange.registry import format_named
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf
from kindsl.robots.interchange.xacro.expansion import expanded
from kindsl.robots.interchange.xacro.packages import package_folder

HEAD = '<?xml version="1.0"?>\n<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="leg">'
MACROS = f"""{HEAD}
<xacro:property name="length" value="0.4"/>
<xacro:macro name="rod" params="name mass:=2.0 *placement">
  <link name="${{name}}"><inertial><xacro:insert_block name="placement"/><mass value="${{mass}}"/>
  <inertia ixx="${{mass * length**2 / 12}}" iyy="${{mass * length**2 / 12}}"
  izz="${{mass * radians(1) / 2}}" ixy="0" ixz="0" iyz="0"/></inertial></link>
</xacro:macro></robot>"""
LEG = f"""{HEAD}
<xacro:arg name="side" default="left"/>
<xacro:arg name="with_foot" default="true"/>
<xacro:include filename="parts/rods.xacro"/>
<link name="base"/>
<xacro:macro name="segment" params="name parent z">
  <xacro:rod name="$(arg side)_${{name}}" mass="${{1 + 0.5 * 2}}">
    <origin xyz="0 0 ${{-length / 2}}"/></xacro:rod>
  <joint name="$(arg side)_${{name}}_joint" type="continuous"><parent link="${{parent}}"/>
    <child link="$(arg side)_${{name}}"/><origin xyz="0 0 ${{z}}" rpy="0 ${{pi / 4}} 0"/>
    <axis xyz="0 1 0"/></joint>
</xacro:macro>
<xacro:segment name="thigh" parent="base" z="0"/>
<xacro:segment name="shank" parent="$(arg side)_thigh" z="${{-length}}"/>
<xacro:if value="$(arg with_foot)"><link name="foot"/>
  <joint name="foot_joint" type="fixed"><parent link="$(arg side)_shank"/><child link="foot"/>
  <origin xyz="0 0 ${{-length}}"/></joint></xacro:if>
<xacro:unless value="$(arg with_foot)"><link name="wheel"/></xacro:unless>
</robot>"""
MOMENT = 2.0 * 0.4**2 / 12
LINK = """<link name="{0}"><inertial><origin xyz="0 0 -0.2"/><mass value="2.0"/><inertia ixx="{1!r}"
iyy="{1!r}" izz="{2!r}" ixy="0" ixz="0" iyz="0"/></inertial></link>"""
JOINT = """<joint name="{0}_joint" type="continuous"><parent link="{1}"/><child link="{0}"/>
<origin xyz="0 0 {2}" rpy="0 0.7853981633974483 0"/><axis xyz="0 1 0"/></joint>"""
MEANT = f"""<robot name="leg"><link name="base"/>
{LINK.format("left_thigh", MOMENT, np.radians(1.0).item())}
{LINK.format("left_shank", MOMENT, np.radians(1.0).item())}
{JOINT.format("left_thigh", "base", 0.0)}{JOINT.format("left_shank", "left_thigh", -0.4)}
<link name="foot"/><joint name="foot_joint" type="fixed"><parent link="left_shank"/>
<child link="foot"/><origin xyz="0 0 -0.4"/></joint></robot>"""


@pytest.fixture
def leg(tmp_path: Path) -> Path:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "rods.xacro").write_text(MACROS)
    path = tmp_path / "leg.urdf.xacro"
    path.write_text(LEG)
    return path


def test_arguments_macros_and_includes_are_the_robot_they_mean(leg: Path) -> None:
    found, meant = format_named("xacro").read(leg, AS_WRITTEN), robot_of_urdf(MEANT, "leg")
    ours, theirs = (mechanism_of(kindsl_text(read.robot)) for read in (found, meant))
    assert ours.joint_names == ("left_thigh_joint", "left_shank_joint")
    assert max(gaps(ours, theirs, np.random.default_rng(1))) < 1e-12
    trust = "its Python expressions were evaluated: convert only xacro files that you trust"
    assert found.remarks == (trust, *meant.remarks)


def test_floating_base_is_what_is_asked_for(leg: Path) -> None:
    assert format_named("xacro").read(leg, ReadingChoices(floating=True)).robot.is_floating


def test_command_converts_it_and_says_that_it_runs_expressions(leg: Path, capsys) -> None:
    target = leg.with_name("leg.kindsl")
    assert main(["convert", str(leg), str(target)]) == 0
    told = capsys.readouterr()
    assert "left_thigh via left_thigh_joint" in target.read_text()
    assert "note: its Python expressions were evaluated: convert only" in told.err
    assert "warning" not in told.err and told.out == ""
    with pytest.raises(SystemExit):
        main(["convert", "--help"])
    assert "convert only files that you trust" in " ".join(capsys.readouterr().out.split())


FOREVER = f'{HEAD}<link name="${{max(range(10**15))}}"/></robot>'
ENDLESS = f"""{HEAD}<xacro:macro name="again" params=""><xacro:again/></xacro:macro>
<xacro:again/></robot>"""


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (ENDLESS, "xacro cannot expand it: .*recursion.*"),
        (f'{HEAD}<link name="${{length}}"/></robot>', "xacro cannot expand it: .*'length'.*"),
        (f'{HEAD}<link name="$(arg side)"/></robot>', "xacro cannot expand it: .*side.*"),
        (f'{HEAD}<xacro:leg/></robot>', "xacro cannot expand it: .*xacro:leg.*"),
        (f"{HEAD}</robt>", "xacro cannot expand it: .*"),
        (f'{HEAD}<xacro:include filename="non.xacro"/></robot>', "xacro cannot expand it: .*non.*"),
        (f'{HEAD}<link name="${{[0] * 10**12}}"/></robot>', ".*: it needs more than 4 GB.*"),
        ("<robot/>", "the URDF has no link"),
    ],
    ids=["recursion", "name", "argument", "macro", "xml", "include", "memory", "urdf"],
)  # fmt: skip
def test_what_cannot_be_expanded_is_one_sentence(text: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / "robot.xacro"
    path.write_text(text)
    with pytest.raises(FormatError, match=f"^{message}$") as caught:
        format_named("xacro").read(path, AS_WRITTEN)
    assert "\n" not in str(caught.value)


PACKAGE = f'{HEAD}<xacro:include filename="$(find nopkg)/a.xacro"/></robot>'


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (PACKAGE, "the package 'nopkg' is in none of {folder}: add a folder to ROS_PACKAGE_PATH, "
         "or give --package-path DIR to kindsl convert"),
        (f'{HEAD}<link name="$(env NO_VALUE)"/></robot>',
         "environment variable 'NO_VALUE' is not set"),
        (f'{HEAD}<xacro:include filename="non.xacro"/></robot>',
         "No such file or directory: {folder}/non.xacro"),
        (f"""{HEAD}<link name="${{dict(a=1)['b']}}"/></robot>""",
         "there is no 'b' when evaluating expression 'dict(a=1)['b']'"),
        (f"""{HEAD}<xacro:property name="b" value="${{c*2}}"/><link name="${{b+1}}"/></robot>""",
         "name 'c' is not defined when evaluating expression 'c*2' in 'b+1'"),
    ],
    ids=["package", "environment", "include", "key", "nested"],
)  # fmt: skip
def test_xacro_says_its_sentence_once(text: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / "robot.xacro"
    path.write_text(text)
    with pytest.raises(FormatError) as caught:
        format_named("xacro").read(path, AS_WRITTEN)
    assert str(caught.value) == f"xacro cannot expand it: {message.format(folder=tmp_path)}"


def test_an_error_in_another_file_or_a_macro_has_its_place(tmp_path: Path) -> None:
    path, leg = tmp_path / "robot.xacro", tmp_path / "leg.xacro"
    path.write_text(f'{HEAD}<xacro:include filename="leg.xacro"/><xacro:leg x="1"/></robot>')
    said = "name 'y' is not defined when evaluating expression 'y'"
    macro = f'{HEAD}<xacro:macro name="leg" params="x"><link name="${{y}}"/></xacro:macro></robot>'
    for text, place in (
        (macro, "in the macro 'leg' of leg.xacro"),
        (f'{HEAD}<xacro:if value="${{y}}"/></robot>', "in leg.xacro"),
    ):
        leg.write_text(text)
        with pytest.raises(FormatError) as caught:
            format_named("xacro").read(path, AS_WRITTEN)
        assert str(caught.value) == f"xacro cannot expand it: {said}, {place}"
    path.write_text(macro.replace("</robot>", '<xacro:leg x="1"/></robot>'))
    with pytest.raises(FormatError) as caught:
        format_named("xacro").read(path, AS_WRITTEN)
    assert str(caught.value) == f"xacro cannot expand it: {said}, in the macro 'leg'"


def test_what_never_ends_is_given_up(tmp_path: Path) -> None:
    path = tmp_path / "robot.xacro"
    path.write_text(FOREVER)
    with pytest.raises(FormatError, match=r"^xacro does not expand it within 0\.5 s$"):
        expanded(path, seconds=0.5)


def test_it_is_given_thirty_seconds(leg: Path, monkeypatch) -> None:
    def run(command: list[str], *, timeout: float, **_: object) -> None:
        raise subprocess.TimeoutExpired(command, timeout)

    monkeypatch.setattr(subprocess, "run", run)
    with pytest.raises(FormatError, match=r"^xacro does not expand it within 30 s$"):
        expanded(leg)


def test_expressions_reach_nothing_of_the_process_that_asks(leg: Path, monkeypatch) -> None:
    """It is another process: no module of xacro is loaded here, none of the folder there."""
    (leg.parent / "xacro.py").write_text("raise SystemExit(7)")
    monkeypatch.chdir(leg.parent)
    monkeypatch.delitem(sys.modules, "xacro", raising=False)
    assert b"left_thigh" in expanded(Path(leg.name))
    assert "xacro" not in sys.modules


def test_without_xacro_its_extra_is_named(leg: Path, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "xacro", None)
    with pytest.raises(FormatError) as caught:
        expanded(leg)
    assert str(caught.value) == (
        "xacro is not installed: pip install 'kindsl[xacro]', or run xacro first: "
        "xacro leg.urdf.xacro > leg.urdf"
    )


def test_file_that_is_not_there_is_said_so(tmp_path: Path, capsys) -> None:
    assert main(["convert", str(tmp_path / "none.xacro"), "-"]) == 2
    assert "none.xacro: error: no such file or folder" in capsys.readouterr().err


PARTS = f"""{HEAD}<xacro:macro name="body" params="mass"><link name="body"><inertial>
<mass value="${{mass}}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
</link></xacro:macro></robot>"""
ROBOT = f"""{HEAD}<xacro:arg name="file" default="$(find parts)/config/masses.yaml"/>
<xacro:arg name="name" default="leg"/>
<xacro:include filename="$(find parts)/urdf/parts.xacro"/>
<xacro:property name="masses" value="${{xacro.load_yaml('$(arg file)')}}"/>
<link name="base"/><xacro:body mass="${{masses['body']}}"/>
<joint name="$(arg name)_joint" type="continuous"><parent link="base"/><child link="body"/></joint>
</robot>"""


@pytest.fixture
def packages(tmp_path: Path) -> Path:
    for name, files in {
        "workspace/src/leg_description": {"urdf/leg.urdf.xacro": ROBOT},
        "workspace/src/stack/parts_of_a_robot": {
            "urdf/parts.xacro": PARTS,
            "config/masses.yaml": "body: 2.5\n",
        },
    }.items():
        manifest = "parts" if "stack" in name else "leg_description"
        files = {**files, "package.xml": f"<package><name>{manifest}</name></package>"}
        for file, text in files.items():
            path = tmp_path / name / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
    return tmp_path / "workspace" / "src"


def test_packages_are_found_beside_the_one_of_the_file(packages: Path) -> None:
    path = packages / "leg_description" / "urdf" / "leg.urdf.xacro"
    found = format_named("xacro").read(path, AS_WRITTEN).robot
    assert found.bodies[1].joint == "leg_joint"
    assert found.bodies[1].mass.mass == 2.5


def test_arguments_and_folders_of_packages_are_taken_from_the_command(
    packages: Path, tmp_path: Path, capsys
) -> None:
    path, masses = tmp_path / "alone" / "leg.xacro", tmp_path / "masses.yaml"
    path.parent.mkdir()
    path.write_text(ROBOT)
    masses.write_text("body: 4.5\n")
    target = tmp_path / "leg.kindsl"
    assert main(["convert", str(path), str(target)]) == 1
    told = capsys.readouterr().err
    assert "the package 'parts' is in none of" in told and str(tmp_path) in told
    assert "--package-path DIR" in told and told.count("\n") == 1
    command = ["convert", str(path), str(target), "--package-path", str(packages)]
    assert main([*command, f"file:={masses}", "name:=hip"]) == 0
    assert "mass = 4.5" in target.read_text() and "r_joint hip_joint" in target.read_text()


def test_an_argument_that_the_file_does_not_have_is_refused(leg: Path) -> None:
    choices = ReadingChoices(arguments={"side": "right", "with_feet": "false"})
    with pytest.raises(FormatError, match="no argument 'with_feet'; did you mean 'with_foot'"):
        expanded(leg, choices)


def test_arguments_are_for_xacro_files(tmp_path: Path, capsys) -> None:
    path = tmp_path / "leg.urdf"
    path.write_text(MEANT)
    assert main(["convert", str(path), str(tmp_path / "leg.kindsl"), "name:=hip"]) == 2
    assert "arguments are for xacro files" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["convert", str(path), str(tmp_path / "leg.kindsl"), "hip"])
    assert "'hip' is not NAME:=VALUE" in capsys.readouterr().err


def test_a_folder_of_the_name_will_do_and_a_manifest_goes_before(tmp_path: Path) -> None:
    assert package_folder("leg", [tmp_path]) is None
    (tmp_path / "leg").mkdir()
    assert package_folder("leg", [tmp_path / "none", tmp_path]) == tmp_path / "leg"
    other = tmp_path / "src" / "other"
    other.mkdir(parents=True)
    (other / "package.xml").write_text("<package><name>leg</name></package>")
    assert package_folder("leg", [tmp_path]) == other
