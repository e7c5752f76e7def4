"""An SDF judged where it stands; its bodies are those that are converted, as a URDF's are."""

from math import dist
from pathlib import Path

import pytest
from tests.interchange import documents
from tests.support.examples import sdf_arm

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.rules.xml_bodies import xml_bodies
from kindsl.language.text.edits import TextEdit
from kindsl.mechanics.rigid.body import seen_from
from kindsl.robots.interchange.format import AS_WRITTEN
from kindsl.robots.interchange.registry import format_of_suffix
from kindsl.robots.interchange.sdf.document import sdf_document
from kindsl.robots.interchange.syntaxes import syntax_of

FOLDER = Path(documents.__path__[0])
FILES = sorted(each for each in FOLDER.iterdir() if each.suffix in (".sdf", ".urdf"))
ARM = """<?xml version="1.0"?>
<sdf version="1.9">
  <model name="arm">
    <!-- the lower one -->
    <link name="upper">
      <inertial>
        <pose degrees="true">0 0 0.15 0 90 0</pose>
        <mass>1.2</mass>
        <inertia><ixx>0.0003</ixx><iyy>0.009</iyy><izz>0.009</izz></inertia>
      </inertial>
    </link>
    <model name="hand">
      <pose relative_to="upper">0 0 0.3 0 0 0</pose>
      <link name="palm">
        <inertial>
          <mass>0.5</mass>
          <inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz><ixy>0.0</ixy></inertia>
        </inertial>
      </link>
    </model>
    <joint name="shoulder" type="revolute">
      <parent>world</parent><child>upper</child><axis><xyz>0 1 0</xyz></axis>
    </joint>
    <joint name="wrist" type="revolute">
      <parent>upper</parent><child>hand::palm</child><axis><xyz>0 1 0</xyz></axis>
    </joint>
  </model>
</sdf>
"""


def told(text: str) -> list[tuple[str, int]]:
    found = analyse(text)
    assert found.faults == ()
    return [(f.code, text.count("\n", 0, f.start) + 1) for f in found.findings]


def test_a_sound_robot_has_no_finding() -> None:
    assert told(ARM) == []


@pytest.mark.parametrize(
    ("old", "new", "code", "line"),
    [
        ("<iyy>0.009", "<iyy>0.09", "KD302", 6),
        ("<mass>1.2", "<mass>-1.2", "KD303", 8),
        ("0 0 0.15 0 90 0", "0 0 -0.15 0 90 0", "KD511", 6),
        ('relative_to="upper"', 'relative_to="uper"', "KD107", 12),
        ("0 0 0.15 0 90 0", "0 0 0.15 0 9", "KD005", 7),
        (
            "0 1 0</xyz></axis>\n    </joint>\n  <",
            "0 0 0</xyz></axis>\n    </joint>\n  <",
            "KD005",
            25,
        ),
        ("<child>hand::palm</child>", "", "KD008", 24),
        (
            "0 1 0</xyz></axis>\n    </joint>\n  <",
            "0 1 0</xyz><limit><upper>0,4</upper></limit></axis>\n    </joint>\n  <",
            "KD005",
            25,
        ),
        ("<mass>0.5", "<mass>0,5", "KD005", 16),
        ('name="wrist"', 'name="shoulder"', "KD103", 24),
        ("hand::palm", "palm", "KD105", 24),
        ("</model>\n</sdf>", "</sdf>", "KD001", 27),
    ],
)
def test_findings_have_their_lines(old: str, new: str, code: str, line: int) -> None:
    assert (code, line) in told(ARM.replace(old, new))


def test_a_circle_of_poses_is_told_once_and_what_else_is_wrong_too() -> None:
    circle = ARM.replace("<pose degrees", "<p degrees").replace(
        "</pose>\n        <mass>1.2", "</p>\n        <mass>1.2"
    )
    circle = circle.replace('<link name="upper">', '<link name="upper"><pose relative_to="wrist"/>')
    circle = circle.replace(
        '"revolute">\n      <parent>upper',
        '"revolute"><pose relative_to="upper"/>\n      <parent>upper',
    )
    circle = circle.replace("<parent>world</parent>", "<parent>ground</parent>")
    found = [each for each in analyse(circle).findings if each.code in ("KD527", "KD105")]
    assert sorted((each.code, each.message) for each in found) == [
        ("KD105", "<joint name='shoulder'> names 'ground', which does not exist"),
        (
            "KD527",
            "<link name='upper'> has a pose that is relative to itself: upper -> wrist -> upper",
        ),
    ]


def test_comments_silence_findings() -> None:
    bad = ARM.replace("<iyy>0.009", "<iyy>0.09")
    assert told(bad.replace("the lower one", "kindsl: ignore[KD302, KD308] a dummy")) == []


def test_links_of_inner_models_have_their_names() -> None:
    text = ARM.replace("<izz>0.001", "<izz>0.01")
    (finding,) = analyse(text).findings
    assert finding.message.startswith("inertia of 'hand::palm' violates")


def test_default_moments_are_a_placeholder() -> None:
    start = ARM.index("<inertia><ixx>0.001<")
    end = ARM.index("</inertia>", start)
    text = (ARM[:start] + "<inertia>" + ARM[end:]).replace("<mass>0.5", "<mass>1")
    assert told(text) == [("KD310", 15)]


def test_an_edit_keeps_the_elements_that_it_does_not_touch() -> None:
    first = sdf_document(ARM)
    at = ARM.index("0.009")
    second = first.edited([TextEdit(at, at + 5, "0.008")])
    assert second.text == ARM[:at] + "0.008" + ARM[at + 5 :]
    kept = set(map(id, first.islands)) & set(map(id, second.islands))
    assert len(kept) == len(first.islands) - 1


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.name)
def test_bodies_are_those_that_are_converted(file: Path) -> None:
    format = format_of_suffix(file.suffix)
    assert format is not None and format.read is not None
    robot = format.read(file, AS_WRITTEN).robot
    model = Analysis(syntax_of(file.name, file.read_text())).model
    bodies = {str(body.link.name): body for body in xml_bodies(model)}
    assert {body.name for body in robot.bodies[1:]} <= bodies.keys()
    for body in robot.bodies[1:]:
        ours = bodies[body.name]
        weighed = ours.mass and seen_from(ours.mass, ours.axis_pose.inverse())
        if any(part.mass is None for part in ours.parts) or body.mass is None or not weighed:
            continue  # In place nothing is known of it; SDFormat has a default.
        numbers = [(m.mass, *m.com, *m.moments) for m in (body.mass, weighed)]
        assert dist(*numbers) < 1e-9
        if ours.parent is not None and body.parent:
            above = xml_bodies(model)[ours.parent].axis_pose
            pose = above.inverse().then(ours.placement).then(ours.axis_pose)
            assert dist(pose.numbers, body.placement.numbers) < 1e-9


@pytest.mark.parametrize(
    ("axis", "code"),
    [
        ("<limit><lower>1</lower><upper>-1</upper></limit>", "KD521"),
        ("<limit><lower>-90</lower><upper>45</upper></limit>", "KD522"),
        ('<mimic joint="elbow"><multiplier>1</multiplier></mimic>', "KD525"),
        ("<limit><lower>-1</lower><upper>1</upper><effort>0</effort></limit>", "KD526"),
    ],
)
def test_limits_are_judged_as_in_a_urdf(axis: str, code: str) -> None:
    (found,) = analyse(sdf_arm(axis=axis)).findings
    assert found.code == code and "'shoulder'" in found.message
    at = {"KD521": "<lower>", "KD522": "<lower>", "KD525": "elbow", "KD526": "<effort>"}[code]
    assert sdf_arm(axis=axis)[found.start : found.end] == at


@pytest.mark.parametrize(
    "axis",
    [
        "<limit><lower>-1e16</lower><upper>1e16</upper><effort>-1</effort></limit>",
        "<limit><lower>0</lower><upper>0</upper></limit>",
        "<limit><lower>-inf</lower><upper>inf</upper></limit>",
    ],
)
def test_limits_that_sdf_means_otherwise_are_left_in_peace(axis: str) -> None:
    """Without limits a joint turns freely; equal ones fix it, as Gazebo's models do."""
    assert analyse(sdf_arm(axis=axis)).findings == ()


def test_copied_moments_are_told_of_inner_models() -> None:
    six = "<ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz><ixy>0.0</ixy>"
    copied = six.replace("0.001", "0.00111").replace("0.0<", "0.00111<")
    (found,) = analyse(ARM.replace(six, copied)).findings
    assert found.code == "KD315" and "'hand::palm'" in found.message
    assert ARM.replace(six, copied)[found.start : found.end] == "<ixy>"


def test_a_knee_that_is_placed_in_the_model_differs_from_the_other_side() -> None:
    """A joint whose link is placed in the model has no numbers of its own to be written."""
    tensor = "<ixx>0.00021</ixx><iyy>0.00004</iyy><izz>0.00023</izz>"
    blocks = []
    for side, sign in (("left", ""), ("right", "-")):
        above = "trunk"
        for part, y in (("hip", "0.1"), ("thigh", "0.15"), ("shin", "0.25")):
            name = f"{side}_{part}"
            blocks.append(
                f"<link name='{name}'><pose>0.02 {sign}{y} 0 0 0 0</pose><inertial>"
                f"<mass>0.2</mass><inertia>{tensor}</inertia></inertial></link>"
                f"<joint name='{name}_joint' type='revolute'><parent>{above}</parent>"
                f"<child>{name}</child><axis><xyz>1 0 0</xyz></axis></joint>"
            )
            above = name
    text = f"<sdf version='1.9'><model name='m'><link name='trunk'/>{''.join(blocks)}</model></sdf>"
    assert told(text) == []
    (found,) = analyse(text.replace("0.02 -0.25 0", "0.02 -0.52 0")).findings
    assert found.code == "KD510" and not found.choices
    assert found.message == (
        "translation of 'right_shin_joint' and translation of 'left_shin_joint' differ: "
        "one slip keeps the two sides from being alike"
    )


def test_all_wrong_poses_names_and_types_are_told_at_once() -> None:
    text = sdf_arm().replace(
        "</model>",
        """  <link name="a"><pose>0 0 0 0 0</pose></link>
    <link name="b"><pose relative_to="bse">0 0 0 0 0 0</pose></link>
    <frame name="f"><pose rotation_format="quat_xyzw">0 0 0 0 0 0 0</pose></frame>
    <link name="a"/>
    <joint name="j" type="revolut"><parent>a</parent><child>b</child></joint>
  </model>""",
    )
    found = [f.code for f in analyse(text).findings]
    assert sorted(found) == ["KD001", "KD005", "KD005", "KD102", "KD107"]


@pytest.mark.parametrize(
    ("inclusion", "codes"),
    [
        ("<include><uri>model://arm</uri></include>", ["KD107"]),
        ('<include merge="true"><uri>model://arm</uri></include>', []),
        ("", ["KD107", "KD107"]),
    ],
)
def test_what_another_file_holds_is_not_missed(inclusion: str, codes: list[str]) -> None:
    text = sdf_arm().replace(
        "</model>",
        f"""{inclusion}<frame name="f" attached_to="base"><pose relative_to="arm::tip"/></frame>
    <frame name="g"><pose relative_to="lost">0 0 0 0 0 0</pose></frame>
    <joint name="bolt" type="fixed"><parent>base</parent><child>arm::tip</child></joint>
  </model>""",
    )
    assert sorted(f.code for f in analyse(text).findings) == codes


def test_a_name_that_another_element_has_is_told_there() -> None:
    text = ARM.replace('name="wrist"', 'name="shoulder"')
    text = text.replace("</model>\n</sdf>", '<frame name="f" attached_to="wrist"/></model></sdf>')
    (found,) = analyse(text).findings
    assert found.code == "KD103" and found.message.endswith("; did you mean 'wrist'?")


@pytest.mark.parametrize(
    ("pose", "code", "at"),
    [
        ("0 0 0.3 0 0 90", "KD501", "90"),
        ("0 0 300 0 0 0", "KD502", "300"),
        ("0 0 0.3 0 0 1.57", "", ""),
    ],
)
def test_a_pose_of_a_joint_in_other_units(pose: str, code: str, at: str) -> None:
    text = ARM.replace(
        "<child>hand::palm", f"<pose relative_to='upper'>{pose}</pose><child>hand::palm"
    )
    found = [f for f in analyse(text).findings if f.code in ("KD501", "KD502")]
    assert [(f.code, text[f.start : f.end]) for f in found] == ([(code, at)] if code else [])
