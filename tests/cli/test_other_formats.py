"""Commands on a robot of another format: computed as if converted, told at its own lines."""

import json
from pathlib import Path

import pytest
from tests.cli.conftest import Runner

URDF = """<?xml version="1.0"?>
<robot name="arm">
  <link name="base"/>
  <link name="upper">
    <inertial>
      <origin xyz="0.1 0 0"/>
      <mass value="2"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/>
    </inertial>
  </link>
  <link name="tool"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="9" velocity="9"/>
  </joint>
  <joint name="flange" type="fixed">
    <origin xyz="0.3 0 0"/><parent link="upper"/><child link="tool"/>
  </joint>
</robot>
"""
SDF = """<sdf version="1.9"><model name="arm">
  <link name="base"/>
  <link name="upper"><inertial><mass>2</mass><inertia>
    <ixx>0.01</ixx><iyy>0.02</iyy><izz>0.02</izz></inertia></inertial></link>
  <joint name="fix" type="fixed"><parent>world</parent><child>base</child></joint>
  <joint name="shoulder" type="revolute">
    <parent>base</parent><child>upper</child><axis><xyz>0 1 0</xyz></axis>
  </joint>
</model></sdf>
"""


@pytest.mark.parametrize(("name", "text"), [("arm.urdf", URDF), ("arm.sdf", SDF)])
def test_info_of_another_format(kindsl: Runner, folder: Path, name: str, text: str) -> None:
    (folder / name).write_text(text)
    told = kindsl("info", name, "--output-format", "json")
    facts = json.loads(told.out)
    assert (told.status, told.err) == (0, "")
    assert (facts["robot"], facts["dof"], facts["mass"]) == ("arm", 1, 2.0)


CRATE = """<robot name="crate">
  <link name="box"><inertial><mass value="2.4"/>
    <inertia ixx="0.016" iyy="0.016" izz="0.018" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="lid"><inertial><mass value="0.3"/>
    <inertia ixx="0.001" iyy="0.001" izz="0.002" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="glue" type="fixed"><parent link="box"/><child link="lid"/></joint>
</robot>
"""


def test_what_does_not_move_is_shown_and_compared(kindsl: Runner, folder: Path) -> None:
    (folder / "crate.urdf").write_text(CRATE)
    (folder / "heavy.urdf").write_text(CRATE.replace("2.4", "2.6"))
    facts = json.loads(kindsl("info", "crate.urdf", "--output-format", "json").out)
    assert (facts["robot"], facts["dof"], facts["mass"]) == ("crate", 0, pytest.approx(2.7))
    assert facts["verdicts"] == {}
    assert "\n\n\n" not in kindsl("info", "crate.urdf").out
    assert kindsl("card", "crate.urdf", "-o", "crate.md").status == 0
    card = Path("crate.md").read_text()
    assert "## Joints" not in card
    assert "| box | 2.7 |" in card
    assert kindsl("diff", "crate.urdf", "crate.urdf").status == 0
    told = kindsl("diff", "crate.urdf", "heavy.urdf")
    assert told.status == 1
    assert "mass of link 'box' is 2.4 kg in crate.urdf (line 2)" in told.out


@pytest.mark.parametrize(
    ("command", "status"),
    [
        (("convert", "crate.urdf", "crate.kindsl"), 1),
        (("convert", "crate.urdf", "crate.sdf"), 1),
        (("compute", "crate.urdf"), 1),
        (("generate", "crate.urdf", "--language", "c", "-o", "c"), 1),
    ],
)
def test_what_needs_a_joint_says_so(
    kindsl: Runner, folder: Path, command: tuple[str, ...], status: int
) -> None:
    (folder / "crate.urdf").write_text(CRATE)
    told = kindsl(*command)
    assert (told.status, told.out) == (status, "")
    assert told.err.startswith("crate.urdf:")
    assert "moves" in told.err
    assert told.err.count("\n") == 1


def test_compute_as_if_converted(kindsl: Runner, folder: Path) -> None:
    (folder / "arm.urdf").write_text(URDF)
    kindsl("convert", "arm.urdf", "arm.kindsl", "--no-config")
    ours, theirs = (
        json.loads(kindsl("compute", name, "--q", "0.3").out) for name in ("arm.kindsl", "arm.urdf")
    )
    assert ours == theirs
    assert theirs["configurations"][0]["joint_space_inertia"] == [[pytest.approx(0.04)]]


def test_a_root_that_floats_if_asked(kindsl: Runner, folder: Path) -> None:
    (folder / "arm.urdf").write_text(URDF)
    told = kindsl("info", "arm.urdf", "--floating-base", "--output-format", "json")
    assert json.loads(told.out)["dof"] == 7


def test_a_document_says_itself_whether_it_floats(kindsl: Runner, folder: Path) -> None:
    (folder / "arm.urdf").write_text(URDF)
    kindsl("convert", "arm.urdf", "arm.kindsl")
    told = kindsl("info", "arm.kindsl", "--floating-base")
    assert told.status == 2
    assert told.err == "arm.kindsl: error: a document says itself whether its base floats\n"


@pytest.mark.parametrize("command", ["info", "compute", "card"])
def test_a_broken_file_is_told_with_all_lines(kindsl: Runner, folder: Path, command: str) -> None:
    broken = URDF.replace('mass value="2"', 'mass value="2,"').replace(
        '"tool"/>\n  </j', '"tol"/>\n  </j'
    )
    (folder / "arm.urdf").write_text(broken)
    told = kindsl(command, "arm.urdf")
    assert told.status == 1
    assert told.err == (
        "arm.urdf:7:20: error: [KD005] <mass> has '2,' in 'value', which is not a finite number\n"
        "arm.urdf:17:63: error: [KD105] <child> of joint 'flange' names a link 'tol' that does not"
        " exist; did you mean 'tool'?\n"
    )


def test_a_second_inertia_keeps_nothing_from_being_computed(kindsl: Runner, folder: Path) -> None:
    end = "</inertial>"
    second = f'{end}<inertial><mass value="1"/>{end}'
    (folder / "arm.urdf").write_text(URDF.replace(end, second, 1))
    assert "KD009" in kindsl("lint", "arm.urdf").out
    told = kindsl("compute", "arm.urdf")
    assert (told.status, told.err) == (0, "arm.urdf: note: has an error, see kindsl lint\n")


def test_a_xacro_without_errors_is_computed_without_a_note(kindsl: Runner, folder: Path) -> None:
    macro = '<xacro:macro name="none" params=""/></robot>'
    head = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" '
    text = URDF.replace("</robot>", macro).replace("<robot ", head)
    (folder / "arm.xacro").write_text(text)
    told = kindsl("compute", "arm.xacro")
    assert (told.status, told.err) == (0, "")


PLANAR = "line 12: <joint name='shoulder'> is a planar joint, which the language does not support"
ROOM = """<sdf version="1.9"><world name="room">
<model name="box"><link name="body"><inertial><mass>2</mass></inertial></link>
<link name="lid"><inertial><mass>1</mass></inertial></link>
<joint name="hinge" type="{}"><pose>0 0 1 0 0 0</pose><parent>body</parent><child>lid</child>
<axis/></joint></model>
<model name="ball"><pose>3 0 0 0 0 0</pose>
<link name="body"><inertial><mass>4</mass></inertial></link></model></world></sdf>
"""


def test_what_is_beyond_the_language_is_shown_with_a_note(kindsl: Runner, folder: Path) -> None:
    (folder / "arm.urdf").write_text(URDF.replace('"revolute"', '"planar"'))
    told = kindsl("info", "arm.urdf")
    assert (told.status, told.err) == (0, f"arm.urdf: note: {PLANAR}\n")
    assert "0 degrees of freedom" in told.out and "2 kg" in told.out
    assert kindsl("preview", "arm.urdf", "--export", "page.html").status == 0
    for command in (
        ("compute", "arm.urdf"),
        ("convert", "arm.urdf", "-"),
        ("generate", "arm.urdf", "--language", "python", "-o", "d"),
    ):
        told = kindsl(*command)
        assert (told.status, told.err.splitlines()[-1]) == (1, f"arm.urdf: error: {PLANAR}")


def test_an_inertia_that_cannot_be_read_is_a_gap(kindsl: Runner, folder: Path) -> None:
    for old, new, error in (
        ('<mass value="2"/>', "", "line 5: <inertial> of link 'upper' has no <mass>"),
        ('value="2"', 'value="2,0"', "line 7: <mass> has '2,0' in 'value', which is not a finite"),
    ):
        (folder / "arm.urdf").write_text(URDF.replace(old, new))
        told = kindsl("info", "arm.urdf")
        assert told.status == 0 and "mass unknown (link 'upper' has no mass)" in told.out
        told = kindsl("compute", "arm.urdf")
        assert told.status == 1 and f"arm.urdf: error: {error}" in told.err
    (folder / "b.urdf").write_text(URDF)
    told = kindsl("diff", "arm.urdf", "b.urdf")
    assert told.status == 1 and "line 7: <mass> has" in told.err


def test_models_of_a_world_are_shown_together(kindsl: Runner, folder: Path) -> None:
    (folder / "room.sdf").write_text(ROOM.format("revolute"))
    told = kindsl("info", "room.sdf", "--output-format", "json")
    facts = json.loads(told.out)
    two = "line 6: the SDF has 2 models, exactly one is required: 'box' and 'ball'"
    assert told.err == f"room.sdf: note: {two}; 1 more\n"
    assert (facts["dof"], facts["base"]["name"]) == (1, "world")
    (folder / "room.sdf").write_text(ROOM.format("ball"))
    assert "7 kg" in kindsl("info", "room.sdf").out
    told = kindsl("convert", "room.sdf", "-")
    assert told.status == 1 and "error: line 6: the SDF has 2 models" in told.err


def test_findings_are_the_files_own(kindsl: Runner, folder: Path) -> None:
    (folder / "arm.urdf").write_text(URDF.replace('iyy="0.02"', 'iyy="0.07"'))
    told = kindsl("info", "arm.urdf")
    assert told.err == "arm.urdf: note: has an error, see kindsl lint\n"
    kindsl("card", "arm.urdf", "-o", "card.md")
    assert "KD302" in (folder / "card.md").read_text()


def test_a_page_of_a_urdf(kindsl: Runner, folder: Path) -> None:
    (folder / "arm.urdf").write_text(URDF)
    assert kindsl("preview", "arm.urdf", "--export", "arm.html").status == 0
    assert len((folder / "arm.html").read_text()) > 100_000


def test_no_page_writes_into_a_urdf(kindsl: Runner, folder: Path) -> None:
    (folder / "arm.urdf").write_text(URDF)
    told = kindsl("preview", "arm.urdf", "--edit", "--no-open")
    assert told.status == 2
    assert "only a .kindsl document is edited in the page" in told.err


def test_folders_are_walked_for_what_the_configuration_includes(
    kdsl_lint: Runner, folder: Path
) -> None:
    bad = URDF.replace('iyy="0.02"', 'iyy="0.07"')
    for name in ("arm.urdf", "sub/leg.urdf", "sub/old/leg.urdf", "sub/LEG.URDF"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(bad)

    def linted(*paths: str) -> list[str]:
        told = json.loads(kdsl_lint("--output-format", "json", *paths).out)
        return sorted({found["path"] for found in told})

    assert linted() == []
    assert linted("arm.urdf") == ["arm.urdf"]
    (folder / "kindsl.toml").write_text('include = ["sub/*.urdf", "*.URDF"]\n')
    assert linted() == ["sub/LEG.URDF", "sub/leg.urdf"]
    assert linted("arm.urdf", "sub/old/leg.urdf") == ["arm.urdf", "sub/old/leg.urdf"]
    (folder / "kindsl.toml").write_text('include = "*.urdf"\n')
    assert "'include' must be a list of patterns, not a string" in kdsl_lint().err
