"""`kindsl diff` of any two descriptions of a robot: mechanics count, conventions do not."""

import json
import re
from math import pi
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.comparison.trials import ARM, described_text, random_document
from tests.comparison.variants import urdf_of, variant

from kindsl.robots.interchange.urdf.urdf_reading import numbers_of_urdf


@pytest.fixture
def arm(folder: Path) -> Path:
    path = folder / "arm.kindsl"
    path.write_text(ARM)
    return path


@pytest.mark.parametrize("suffix", [".urdf", ".sdf", ".xml"])
def test_what_was_converted_is_equal_until_a_number_is_another(
    kindsl: Runner, arm: Path, suffix: str
) -> None:
    if suffix == ".xml":
        pytest.importorskip("mujoco")
    other = arm.with_suffix(suffix)
    assert kindsl("convert", "-q", arm, other).status == 0
    run = kindsl("diff", "arm.kindsl", other.name)
    assert run.status == 0, run.out
    assert run.out.startswith("the mechanics are equal: inertia matrix and bias forces agree")
    text = other.read_text()
    other.write_text(text.replace("1.3", "1.4", 1))
    line = text[: text.index("1.3")].count("\n") + 1
    run = kindsl("diff", "arm.kindsl", other.name)
    assert run.status == 1
    assert f"is 1.3 kg in arm.kindsl (line 8) and 1.4 kg in {other.name} (line {line})" in run.out


def test_moments_about_turned_axes_are_named_as_the_file_has_them(
    kindsl: Runner, arm: Path
) -> None:
    kindsl("convert", "-q", arm, "arm.urdf")
    text = Path("arm.urdf").read_text()
    tag = re.search("<inertia [^>]*>", text)
    assert tag is not None
    turned = '<inertia ixx="0.02648" ixy="0" ixz="0" iyy="0.00948" iyz="-0.0006" izz="0.027"/>'
    text = text.replace(tag[0], turned, 1).replace('rpy="0.0 0.0 0.0"', f'rpy="0 0 {pi / 2}"', 1)
    Path("arm.urdf").write_text(text)
    assert kindsl("diff", "arm.urdf", "arm.kindsl").status == 0
    Path("arm.urdf").write_text(text.replace("0.02648", "0.02748"))
    (line,) = kindsl("diff", "arm.urdf", "arm.kindsl").out.splitlines()[1:]
    assert line.startswith(
        "  Ix of link 'upper' is 0.02748 kg m² in arm.urdf (line 8) and would be"
    )


TURNED = """<sdf version="1.9"><model name="m">
<link name="base"/><link name="arm"><inertial>
<pose>0.010360123 0.0017266872 0 {} 0 -2.9944141</pose>
<mass>0.78184398</mass><inertia><ixx>0.00045849346</ixx><ixy>0</ixy><ixz>0</ixz>
<iyy>0.00056925641</iyy><iyz>0</iyz><izz>0.00064126887</izz></inertia></inertial></link>
<joint name="base_fixed" type="fixed"><parent>world</parent><child>base</child></joint>
<joint name="yaw" type="revolute"><parent>base</parent><child>arm</child>
<axis><xyz>1 0 0</xyz></axis></joint>
</model></sdf>"""


@pytest.mark.parametrize(("angle", "status"), [("1.5707963", 0), ("1.58", 1)])
def test_axes_turned_by_a_rounded_angle_leave_no_products(
    kindsl: Runner, folder: Path, angle: str, status: int
) -> None:
    (folder / "rounded.sdf").write_text(TURNED.format("1.5707963"))
    assert kindsl("convert", "-q", "--no-config", "rounded.sdf", "arm.kindsl").status == 0
    (folder / "rounded.sdf").write_text(TURNED.format(angle))
    run = kindsl("diff", "rounded.sdf", "arm.kindsl")
    assert run.status == status, run.out


def test_a_link_that_is_fixed_is_a_frame_with_its_line(kindsl: Runner, arm: Path) -> None:
    place = "translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0)"
    arm.write_text(ARM.replace("children {}", f"children {{}} frames {{ camera {{ {place} }} }}"))
    kindsl("convert", "-q", arm, "arm.sdf")
    text = re.sub("<frame.*?</frame>", "", Path("arm.sdf").read_text(), flags=re.DOTALL)
    camera = """<link name="camera"><pose relative_to="lower">0.2 0 0 0 0 0</pose>
<inertial><mass>0</mass><inertia><ixx>0</ixx><iyy>0</iyy><izz>0</izz></inertia></inertial></link>
<joint name="mount" type="fixed"><parent>lower</parent><child>camera</child></joint></model>"""
    text = text.replace("</model>", camera)
    Path("arm.sdf").write_text(text)
    line = text[: text.index('"camera"')].count("\n") + 1
    (told,) = kindsl("diff", arm.name, "arm.sdf").out.splitlines()[1:]
    lines = f"0.1 m in arm.kindsl (line 21) and 0.2 m in arm.sdf (line {line})"
    assert told == f"  x of frame 'camera' is {lines} [no joint torque]"


# A point mass between axes that meet, whose angles are written with few digits.
WRIST = """Robot wrist {
RobotBase base { children { forearm via roll } }
link forearm {
    id = 1
    inertia_params {
        mass = 0.5  CoM = (0.0, 0.005, -0.06)
        Ix = 0.003  Iy = 0.003  Iz = 0.0002  Ixy = 0.0  Ixz = 0.0  Iyz = -0.0002
    }
    children { wrist via pitch }
}
link wrist {
    id = 2
    inertia_params {
        mass = 0.1  CoM = (0.0, 0.0, 0.0)
        Ix = 0.0  Iy = 0.0  Iz = 0.0  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0
    }
    children { hand via yaw }
}
link hand {
    id = 3
    inertia_params {
        mass = 0.2  CoM = (0.07, -0.008, 0.007)
        Ix = 0.0002  Iy = 0.0013  Iz = 0.0014  Ixy = -0.0001  Ixz = 0.0001  Iyz = 0.0
    }
    children {}
}
r_joint roll { ref_frame {
    translation = (0.015, 0.0, 0.0)  rotation = (1.570796326781404, -0.000003673205103, -1.5708)
} }
r_joint pitch { ref_frame {
    translation = (0.0, 0.0, -0.1373)  rotation = (1.570796326781404, 0.000003673205103, 1.5708)
} }
r_joint yaw { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (PI/2.0, 0.0, 3.14159) } }
}
"""


@pytest.mark.parametrize("suffix", [".urdf", ".sdf", ".xml"])
def test_a_point_mass_between_axes_that_meet_is_equal(
    kindsl: Runner, folder: Path, suffix: str
) -> None:
    if suffix == ".xml":
        pytest.importorskip("mujoco")
    Path("wrist.kindsl").write_text(WRIST)
    assert kindsl("convert", "-q", "wrist.kindsl", f"wrist{suffix}").status == 0
    run = kindsl("diff", "wrist.kindsl", f"wrist{suffix}")
    assert run.status == 0, run.out
    assert "is zero in" not in run.out


def test_both_lines_are_named(kindsl: Runner, arm: Path) -> None:
    kindsl("convert", "-q", arm, "arm.urdf")
    text = Path("arm.urdf").read_text().replace('value="0.8"', 'value="0.9"')
    Path("arm.urdf").write_text(text)
    line = text[: text.index('value="0.9"')].count("\n") + 1
    run = kindsl("diff", "arm.kindsl", "arm.urdf", "--output-format", "json")
    facts = json.loads(run.out)
    (found,) = facts["differences"]
    assert (found["name"], found["quantity"]) == ("lower", "mass")
    assert (found["old"], found["new"]) == (0.8, 0.9)
    assert (found["old_line"], found["new_line"]) == (17, line)
    assert facts["verdict"] == "the mechanics differ"
    assert found["torque"] > 0.1


@pytest.mark.parametrize(
    "name, other", [("arm.urdf", "hand.urdf"), ("old/arm.urdf", "new/arm.urdf")]
)
def test_sentences_name_files_by_the_ends_of_their_paths(
    kindsl: Runner, arm: Path, folder: Path, name: str, other: str
) -> None:
    paths = [folder / "a long way to" / each for each in (name, other)]
    for path, mass in zip(paths, ("1.3", "1.4"), strict=True):
        path.parent.mkdir(parents=True, exist_ok=True)
        arm.write_text(ARM.replace("1.3", mass))
        kindsl("convert", "-q", arm, path)
    run = kindsl("diff", *paths)
    assert f"is 1.3 kg in {name} (line 7) and 1.4 kg in {other} (line 7)" in run.out
    assert str(folder) not in run.out


def test_the_largest_effect_comes_first(kindsl: Runner, arm: Path) -> None:
    text = ARM.replace("1.3", "1.4").replace("Ix = 0.005", "Ix = 0.006").replace("0.35", "0.45")
    Path("other.kindsl").write_text(text)
    run = kindsl("diff", "--mechanics", arm, "other.kindsl", "--output-format", "json")
    found = json.loads(run.out)["differences"]
    assert [each["torque"] for each in found] == sorted(
        (each["torque"] for each in found), reverse=True
    )
    assert {each["quantity"] for each in found} == {"mass", "Ix", "x"}


def test_a_variant_is_equal_and_its_conventions_are_told(kindsl: Runner, folder: Path) -> None:
    text = random_document(3)
    Path("robot.kindsl").write_text(text)
    skeleton = described_text(text)[0].skeleton
    Path("variant.urdf").write_text(urdf_of(variant(skeleton, 5)))
    run = kindsl("diff", "robot.kindsl", "variant.urdf", "--output-format", "markdown")
    assert run.status == 0, run.out
    assert "Conventions:" in run.out


HAND = """<robot name="arm">
<link name="base"/>
<joint name="hinge" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<link name="arm"><inertial><mass value="1"/><origin xyz="0.2 0 0"/>
  <inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="bend" type="revolute"><parent link="arm"/><child link="palm"/><axis xyz="0 0 1"/>
  <origin xyz="0.3 0 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<link name="palm"><inertial><mass value="1"/><origin xyz="0.1 0 0"/>
  <inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="mount" type="fixed"><parent link="palm"/><child link="tip.0"/>
  <origin xyz="0.4 0 0"/></joint>
<link name="tip.0"><inertial><mass value="0.1"/>
  <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
</robot>
"""


def test_a_frame_that_is_a_link_with_a_mass_there_is_compared_too(
    kindsl: Runner, folder: Path
) -> None:
    Path("hand.urdf").write_text(HAND)
    assert kindsl("convert", "--quiet", "hand.urdf", "hand.kindsl").status == 0
    run = kindsl("diff", "hand.kindsl", "hand.urdf")
    assert run.status == 0, run.out
    assert "tip" not in run.out  # its name in the document counts as the same
    text = Path("hand.kindsl").read_text()
    assert text.count("(0.4, 0.0, 0.0)") == 1
    Path("moved.kindsl").write_text(text.replace("(0.4, 0.0, 0.0)", "(0.5, 0.0, 0.0)"))
    run = kindsl("diff", "moved.kindsl", "hand.urdf")
    assert run.status == 1
    assert "x of frame 'tip_0' is 0.5 m in moved.kindsl" in run.out


def test_names_tell_which_joint_is_which_as_a_document_can_write_them(
    kindsl: Runner, folder: Path
) -> None:
    """Two like fingers, mounts exchanged: by their places each would be the other."""
    finger = HAND[HAND.index('<joint name="hinge"') : HAND.index('<joint name="bend"')]
    fingers = "".join(
        finger.replace('"hinge"', f'"hinge.{n}"')
        .replace('"arm"', f'"arm.{n}"')
        .replace("<axis", f'<origin xyz="0 {place} 0"/><axis')
        for n, place in ((1, "0.2"), (2, "-0.1"))
    )
    Path("hand.urdf").write_text(f'<robot name="hand"><link name="base"/>{fingers}</robot>')
    assert kindsl("convert", "--quiet", "hand.urdf", "hand.kindsl").status == 0
    for one, other in (("hand.kindsl", "hand.urdf"), ("hand.urdf", "hand.kindsl")):
        run = kindsl("diff", one, other)
        assert run.status == 0
        assert "name" not in run.out
    text = Path("hand.kindsl").read_text()
    one, other = "r_joint hinge_1 {", "r_joint hinge_2 {"
    Path("other.kindsl").write_text(text.replace(one, "@").replace(other, one).replace("@", other))
    run = kindsl("diff", "other.kindsl", "hand.urdf")
    assert run.status == 1
    assert "y of joint 'hinge_2' (there 'hinge.2') is 0.2 m in other.kindsl" in run.out


# As exports write a neck: point masses on axes that meet, 1.5708 for a right angle.
NECK = """<robot name="neck">
<link name="chest"/>
<joint name="pitch" type="revolute"><parent link="chest"/><child link="neck"/>
  <origin xyz="0.00231 0.1933 0" rpy="1.5708 0 1.5708"/><axis xyz="0 1 6e-17"/>
  <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<link name="neck"><inertial><mass value="0.1"/>
  <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="roll" type="revolute"><parent link="neck"/><child link="gimbal"/>
  <origin xyz="0.0095 0 0" rpy="-1.5708 0 -1.5708"/><axis xyz="0 -1 6e-17"/>
  <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<link name="gimbal"><inertial><mass value="0.1"/>
  <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="yaw" type="revolute"><parent link="gimbal"/><child link="head"/>
  <origin xyz="0 0 0" rpy="-1.5708 0 1.5708"/><axis xyz="0 -1 6e-17"/>
  <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<link name="head"><inertial><mass value="1.3"/><origin xyz="0.0185 -0.1108 0"/>
  <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
</robot>
"""


def test_angles_of_few_digits_do_not_shift_what_hangs_on_them(kindsl: Runner, folder: Path) -> None:
    Path("neck.urdf").write_text(NECK)
    assert kindsl("convert", "--quiet", "neck.urdf", "neck.kindsl").status == 0
    assert "0.0000036732" in Path("neck.kindsl").read_text()
    run = kindsl("diff", "neck.kindsl", "neck.urdf")
    assert run.status == 0, run.out


def test_a_link_without_mass_is_at_one_place_in_two_files(kindsl: Runner, folder: Path) -> None:
    light = HAND.replace('<mass value="0.1"/>', '<mass value="0"/>')
    tip = light.rindex("<inertia ")
    light = light[:tip] + light[tip:].replace('="0.01"', '="0"')
    Path("one.urdf").write_text(light)
    Path("other.urdf").write_text(light.replace('xyz="0.4 0 0"', 'xyz="0.5 0 0"'))
    run = kindsl("diff", "one.urdf", "other.urdf")
    assert run.status == 1
    assert "x of frame 'tip.0' is 0.4 m in one.urdf" in run.out


def test_a_frame_on_another_link_is_told(kindsl: Runner, folder: Path) -> None:
    Path("hand.urdf").write_text(HAND)
    assert kindsl("convert", "--quiet", "hand.urdf", "hand.kindsl").status == 0
    text = Path("hand.kindsl").read_text()
    start = text.index("    frames {")
    frames = text[start : text.index("\n    }\n", start) + len("\n    }\n")]
    joint = "palm via bend\n    }\n"
    other = text.replace(frames, "").replace(joint, joint + frames)
    assert other.count(frames) == 1
    Path("other.kindsl").write_text(other)
    run = kindsl("diff", "other.kindsl", "hand.urdf")
    assert run.status == 1
    assert "frame 'tip_0' is on 'arm' here, on 'palm' in hand.urdf" in run.out


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        (
            "",
            "",
            "The mechanics are equal: inertia matrix and bias forces agree in 20 random states.\n",
        ),
        (
            "1.3",
            "1.4",
            "The mechanics differ.\n\n"
            "| what | name | number | `arm.kindsl` | `other.kindsl` | torque |\n"
            "|---|---|---|---|---|---|\n"
            "| link | `upper` | mass | 1.3 kg (line 8) | 1.4 kg (line 8) | 0.0981 |\n",
        ),
        (
            "r_joint",
            "p_joint",
            "The mechanics differ.\n\n"
            "- joint 'shoulder' is revolute here and prismatic in other.kindsl\n",
        ),
    ],
)
def test_markdown_has_a_list_and_a_table_where_there_is_something_to_say(
    kindsl: Runner, arm: Path, old: str, new: str, told: str
) -> None:
    Path("other.kindsl").write_text(ARM.replace(old, new, 1))
    run = kindsl("diff", "--mechanics", "arm.kindsl", "other.kindsl", "--output-format", "markdown")
    assert run.out == f"### Mechanics of `arm.kindsl` and `other.kindsl`\n\n{told}"


def test_torques_are_asked_of_robots_whose_joints_match(kindsl: Runner, arm: Path) -> None:
    lower, shoulder, elbow = map(ARM.index, ("link lower", "r_joint shoulder", "r_joint elbow"))
    short = f"{ARM[:lower]}{ARM[shoulder:elbow]}}}\n".replace("lower via elbow", "")
    Path("short.kindsl").write_text(short)
    for files in (("arm.kindsl", "short.kindsl"), ("short.kindsl", "arm.kindsl")):
        run = kindsl("diff", "--mechanics", *files, "--output-format", "json")
        facts = json.loads(run.out)
        assert facts["structure"]
        assert facts["base_parameters"] is None


@pytest.mark.parametrize(
    ("old", "new", "effect"),
    [("mass = 1.3", "mass = 1.4", "[0.0981 N m or N]"), ("Iz = 0.04 ", "Iz = 0.05 ", "N m or N]"),
     ("Ix = 0.01 ", "Ix = 0.02 ", "[no joint torque]")],
)  # fmt: skip
def test_a_number_is_told_with_the_torque_that_it_makes(
    kindsl: Runner, arm: Path, old: str, new: str, effect: str
) -> None:
    Path("other.kindsl").write_text(ARM.replace(old, new, 1))
    run = kindsl("diff", "--mechanics", "arm.kindsl", "other.kindsl")
    assert run.out.splitlines()[1].endswith(effect)


def test_the_base_is_taken_as_ours_is(kindsl: Runner, folder: Path) -> None:
    Path("a.kindsl").write_text(ARM.replace("RobotBase base {", "RobotBase base floating {"))
    kindsl("convert", "-q", "a.kindsl", "a.urdf")
    run = kindsl("diff", "a.kindsl", "a.urdf")
    assert run.status == 0
    assert run.err == (
        "note: a.urdf leaves open whether its base floats: compared as floating, like the other\n"
    )


WORLD = '<link name="world"/><joint name="w" type="{}"><parent link="world"/>'
WORLD += '<child link="base"/></joint></robot>'


@pytest.mark.parametrize("other", ["a.sdf", "a.xml", "world.urdf"])
def test_a_base_that_the_other_file_tells_is_compared(
    kindsl: Runner, arm: Path, other: str
) -> None:
    if other.endswith(".xml"):
        pytest.importorskip("mujoco")
    target = other if other.startswith("a.") else "a.urdf"
    assert kindsl("convert", "-q", arm, target).status == 0
    urdf = Path(target).read_text().replace("</robot>", WORLD.format("fixed"))
    Path("world.urdf").write_text(urdf)
    assert kindsl("diff", arm, other).status == 0
    arm.write_text(ARM.replace("RobotBase base {", "RobotBase base floating {"))
    run = kindsl("diff", arm, other)
    assert run.status == 1
    assert run.out.splitlines()[1] == f"  the base is floating here and fixed in {other}"
    assert run.err == ""


def test_a_floating_joint_to_the_world_is_told(kindsl: Runner, arm: Path) -> None:
    kindsl("convert", "-q", arm, "a.urdf")
    urdf = Path("a.urdf").read_text().replace("</robot>", WORLD.format("floating"))
    Path("world.urdf").write_text(urdf)
    assert "fixed here and floating in" in kindsl("diff", arm, "world.urdf").out
    arm.write_text(ARM.replace("RobotBase base {", "RobotBase base floating {"))
    run = kindsl("diff", arm, "world.urdf")
    assert (run.status, run.err) == (0, "")


def test_a_joint_that_mimics_another_is_noted(kindsl: Runner, arm: Path) -> None:
    kindsl("convert", "-q", arm, "a.urdf")
    mimic = '<mimic joint="shoulder"/><child link="lower"/>'
    urdf = Path("a.urdf").read_text().replace('<child link="lower"/>', mimic)
    Path("a.urdf").write_text(urdf)
    run = kindsl("diff", arm, "a.urdf")
    assert run.status == 0
    assert "note: 1 mimicking joint of a.urdf compared as if independent\n" in run.err


def test_a_missing_inertia_is_no_zero_in_a_table(kindsl: Runner, arm: Path) -> None:
    kindsl("convert", "-q", arm, "a.urdf")
    urdf = Path("a.urdf").read_text()
    start = urdf.index("<inertial>", urdf.index('<link name="lower"'))
    end = urdf.index("</inertial>", start) + len("</inertial>")
    Path("a.urdf").write_text(urdf[:start] + urdf[end:])
    run = kindsl("diff", arm, "a.urdf", "--output-format", "markdown")
    assert "| link | `lower` | mass | 0.8 kg (line 17) | no inertia |" in run.out


def test_a_joint_that_does_not_exist_is_not_passed_over(kindsl: Runner, arm: Path) -> None:
    kindsl("convert", "-q", arm, "a.urdf")
    for pair, where in (("elbow=elbo", "'elbo' in a.urdf"), ("elbo=elbow", "'elbo' here")):
        run = kindsl("diff", arm, "a.urdf", "--joint", pair)
        assert (run.status, run.out) == (2, "")
        told = f"--joint: error: there is no joint {where}, did you mean 'elbow'?"
        assert told in run.err


def test_of_two_other_formats_one_may_tell_the_base(kindsl: Runner, arm: Path) -> None:
    pytest.importorskip("mujoco")
    arm.write_text(ARM.replace("RobotBase base {", "RobotBase base floating {"))
    for suffix in ("urdf", "xml"):
        kindsl("convert", "-q", arm, f"a.{suffix}")
    run = kindsl("diff", "a.urdf", "a.xml")
    assert run.status == 0, run.out
    assert run.err.startswith("note: a.urdf leaves open whether its base floats: compared as float")


def test_conventions_count_for_two_documents_without_the_option(kindsl: Runner, arm: Path) -> None:
    Path("b.kindsl").write_text(ARM.replace("shoulder", "hip"))
    assert kindsl("diff", arm, "b.kindsl").status == 1
    run = kindsl("diff", "--mechanics", arm, "b.kindsl")
    assert run.status == 0
    assert "note: 1 joint of another name in b.kindsl: 'shoulder' is 'hip'" in run.out


def test_a_parameter_without_value_is_named_and_can_be_bound(kindsl: Runner, arm: Path) -> None:
    Path("b.kindsl").write_text(ARM.replace("0.35", "reach"))
    run = kindsl("diff", "--mechanics", arm, "b.kindsl")
    assert run.status == 2
    assert "no value for the parameter 'reach'" in run.err
    assert kindsl("diff", "--mechanics", arm, "b.kindsl", "--param", "reach=0.35").status == 0
    assert kindsl("diff", "--mechanics", arm, "b.kindsl", "--param", "reach=0.4").status == 1


def test_the_rest_of_a_broken_document_is_compared(kindsl: Runner, arm: Path) -> None:
    Path("b.kindsl").write_text(ARM.replace("mass = 1.3", "mass = ").replace("0.8", "0.9"))
    run = kindsl("diff", "--mechanics", arm, "b.kindsl")
    assert run.status == 2
    assert "b.kindsl:8:" in run.err
    assert "mass of link 'lower' is 0.8 kg" in run.out
    assert "upper" not in run.out


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("gone.urdf", None, "no such file or folder"),
        ("a.urdf", "<robot name='a'><link name='b'/>", "not a readable URDF"),
        (
            "a.urdf",
            "<robot name='a'><link name='b'/><joint name='j' type='fixed'><parent link='b'/>"
            "<child link='c'/></joint></robot>",
            "names a link 'c' that does not exist",
        ),
        ("a.sdf", "<sdf/>", "no model"),
        ("folder", "", "no generated code in this folder"),
    ],
)
def test_what_cannot_be_read_is_said_in_a_sentence(
    kindsl: Runner, arm: Path, name: str, content: str | None, message: str
) -> None:
    if name == "folder":
        Path(name).mkdir()
    elif content is not None:
        Path(name).write_text(content)
    for pair in ((arm, name), (name, arm)):
        run = kindsl("diff", *pair)
        assert run.status == 2
        assert message in run.err
        assert "Traceback" not in run.err


def test_a_format_that_finds_numbers_has_places_for_them() -> None:
    found = numbers_of_urdf("<robot name='ä'><link name='b'><inertial><mass value='1.50'/>"
                              "</inertial></link></robot>")  # fmt: skip
    number = found["link", "b", "mass"]
    assert (number.text, number.value, number.half) == ("1.50", 1.5, 0.005)


def test_what_mujoco_loses_of_a_small_inertia_is_no_difference(
    kindsl: Runner, folder: Path
) -> None:
    pytest.importorskip("mujoco")
    body = (
        '<body name="{0}" pos="-0.025 0 0.2" quat="1.32679e-06 -1 0 0"><inertial'
        ' pos="9.66662e-05 -0.000233736 -0.000463806"'
        ' quat="0.000426355 0.703652 0.00178423 0.710542" mass="0.0189001"'
        ' diaginertia="1.89727e-06 1.24254e-06 1.0322e-06"/><joint name="{0}"/>'
    )
    bodies = "".join(map(body.format, ("a_roll", "a_pitch", "a_yaw")))
    text = f"<mujoco><worldbody>{bodies}{3 * '</body>'}</worldbody></mujoco>"
    (folder / "a.xml").write_text(text)
    assert kindsl("convert", "a.xml", "a.kindsl").status == 0
    run = kindsl("diff", "--mechanics", "a.xml", "a.kindsl")
    assert run.status == 0, run.out


def test_a_site_with_the_name_of_a_body_at_its_parent_is_no_difference(
    kindsl: Runner, folder: Path
) -> None:
    pytest.importorskip("mujoco")
    inertial = '<inertial pos="0 0 0.1" mass="1" diaginertia="0.01 0.01 0.01"/>'
    site = '<body name="tip"><site name="tip" pos="0.065 0 0"/></body>'
    text = f'<body name="arm">{inertial}<joint name="j"/>{site}</body>'
    (folder / "a.xml").write_text(f"<mujoco><worldbody>{text}</worldbody></mujoco>")
    assert kindsl("convert", "a.xml", "a.kindsl").status == 0
    run = kindsl("diff", "--mechanics", "a.xml", "a.kindsl")
    assert run.status == 0, run.out


def test_an_angle_of_few_digits_leaves_open_where_the_mass_behind_it_is(
    kindsl: Runner, folder: Path
) -> None:
    inertial = """<inertial><origin xyz="-5e-06 0.0187 -0.00119"/><mass value="0.189"/>
    <inertia ixx="5.4e-05" ixy="9e-09" ixz="0" iyy="9.3e-06" iyz="-1.7e-08" izz="5.5e-05"/>
    </inertial>"""
    ends = '<parent link="{}"/><child link="{}"/><axis xyz="0 -1 0"/>'
    text = f"""<robot name="a"><link name="base"/><link name="chest"/>
    <link name="arm">{inertial}</link><link name="upper"/>
    <joint name="yaw" type="continuous"><origin xyz="0 -0.0055 0" rpy="-1.5708 0 -1.5708"/>
    {ends.format("base", "chest")}</joint>
    <joint name="pitch" type="continuous"><origin xyz="0 0.1 -0.1" rpy="1.309 0 1.5708"/>
    {ends.format("chest", "arm")}</joint>
    <joint name="roll" type="continuous"><origin rpy="1.5708 0 -1.5708"/>
    {ends.format("arm", "upper").replace("-1", "1")}</joint></robot>"""
    (folder / "a.urdf").write_text(text)
    assert kindsl("convert", "a.urdf", "a.kindsl").status == 0
    run = kindsl("diff", "--mechanics", "a.urdf", "a.kindsl")
    assert run.status == 0, run.out
    document = (folder / "a.kindsl").read_text()
    number = re.search(r"CoM = \(.*?(\d+\.\d\d\d)", document)
    assert number is not None
    (folder / "a.kindsl").write_text(document.replace(number[1], f"{number[1]}1", 1))
    assert kindsl("diff", "--mechanics", "a.urdf", "a.kindsl").status == 1
