"""Elements of URDF pasted into a document are one finding; its fix writes what an import would."""

import pytest
from tests.support.examples import link, robot

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.language.text.edits import apply_edits
from kindsl.robots.interchange.format import ReadRobot
from kindsl.robots.interchange.kindsl_writing import kindsl_text
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf

INERTIAL = """<inertial>
  <origin xyz="0.1 0.02 -0.3" rpy="0 0 {yaw}"/>
  <mass value="2.345"/>
  <inertia ixx="0.0173" ixy="0.0004" ixz="-0.001" iyy="0.0234" iyz="0" izz="0.0111"/>
</inertial>
"""
FOREARM = f'<link name="forearm">\n{INERTIAL}<visual/></link>\n'
HAND = '<link name="hand"><inertial><mass value="1"/></inertial></link>\n'
ELBOW = """<!-- bends -->
<joint name="elbow" type="revolute">
  <parent link="upper"/><child link="forearm"/>
  <origin xyz="0.01 0 0.425" rpy="0 1.5707963267948966 0"/>
  <axis xyz="{axis}"/>
</joint>
"""
WRIST = """<joint name="wrist" type="prismatic">
  <parent link="forearm"/><child link="hand"/>
  <origin xyz="0 0 0.25" rpy="0.3 0 0"/><axis xyz="0 0 1"/>
</joint>
"""
WHOLE = """<robot name="arm"><link name="ground"/><link name="upper"/>
<joint name="shoulder" type="continuous"><parent link="ground"/><child link="upper"/>
<axis xyz="0 0 1"/></joint>{}</robot>"""
ARM = robot(link("upper", 1), base="upper via shoulder", joints="shoulder")
PLACES = {
    "in a link": ("    children {  }\n", "    children {  }\n{}"),
    "between": ("r_joint", "{}r_joint"),
    "at the end": ("\n}\n}\n", "\n}\n{}}}\n"),
}


def pasted(elements: str, place: str = "between") -> Analysis:
    old, new = PLACES[place]
    head, _, tail = ARM.rpartition(old)
    return analyse(head + new.replace("{}", elements).replace("}}", "}") + tail)


def only(analysis: Analysis) -> Diagnostic:
    (finding,) = analysis.findings
    assert finding.code == "KD001" and analysis.text[finding.start] == "<"
    return finding


def taken_over(analysis: Analysis) -> Analysis:
    fix = only(analysis).fix
    assert fix is not None
    return analyse(apply_edits(analysis.text, fix.edits))


def imported(elements: str) -> Analysis:
    read: ReadRobot = robot_of_urdf(WHOLE.format(elements), "arm")
    return analyse(kindsl_text(read.robot))


def blocks(analysis: Analysis, *names: str) -> list[str]:
    """Return the blocks of links and joints, without blanks around."""
    found = {str(t.name): t for t in (*analysis.model.links, *analysis.model.joints)}
    return [found[name].island.text[found[name].start : found[name].end] for name in names]


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("axis", ["0 0 1", "0 1 0", "0 0 -1", "0.6 0 0.8"])
@pytest.mark.parametrize("yaw", ["0", "0.7"])
def test_links_and_joints_are_those_of_an_import(place: str, axis: str, yaw: str) -> None:
    elements = ELBOW.format(axis=axis) + FOREARM.format(yaw=yaw) + WRIST + HAND
    fixed, whole = taken_over(pasted(elements, place)), imported(elements)
    names = "forearm", "hand", "elbow", "wrist"
    assert blocks(fixed, *names) == blocks(whole, *names)
    assert [str(child.link) for child in fixed.model.links[0].children] == ["forearm"]
    assert [f for f in fixed.findings if f.severity == "error"] == []


def test_a_whole_robot_around_them_is_passed_over() -> None:
    inner = ELBOW.format(axis="0 0 1") + FOREARM.format(yaw="0")
    around = f'<?xml version="1.0"?>\n<robot name="x">\n{inner}</robot>\n'
    assert taken_over(pasted(around)).text.split() == taken_over(pasted(inner)).text.split()


def test_a_joint_brings_its_link() -> None:
    analysis = pasted(ELBOW.format(axis="0 0 1"))
    assert only(analysis).message == "joint 'elbow' of URDF: take it over"
    assert [str(body.name) for body in taken_over(analysis).model.links] == ["upper", "forearm"]


def test_an_inertia_becomes_that_of_the_link() -> None:
    fixed = taken_over(pasted(INERTIAL.format(yaw="0"), "in a link"))
    body = fixed.model.links[0].inertia
    assert body is not None and body.mass is not None and body.com is not None
    assert (body.mass.text, body.com.components[2].text) == ("2.345", "-0.3")
    assert body.moments["Ix"].text == "0.229288" and body.moments["Ixz"].text == "-0.06935"


def test_a_link_that_is_there_gets_its_inertia() -> None:
    fixed = taken_over(pasted(FOREARM.format(yaw="0").replace("forearm", "upper")))
    assert "mass = 2.345" in fixed.text and len(fixed.model.links) == 1


@pytest.mark.parametrize(
    ("elements", "said"),
    [
        (ELBOW.format(axis="0 0 1").replace("revolute", "fixed"), "a fixed joint adds to link"),
        (ELBOW.format(axis="0 0 1").replace("elbow", "shoulder"), "'shoulder' is already defined"),
        (ELBOW.format(axis="0 0 x"), "line 5: <axis> has 'x'"),
        (ELBOW.format(axis="0 0 1").replace("revolute", "planar"), "which the language does not"),
        (INERTIAL.format(yaw="0"), "belongs in a link"),
    ],
)
def test_what_cannot_be_taken_over_is_told(elements: str, said: str) -> None:
    finding = only(pasted(elements))
    assert finding.fix is None and said in finding.message


def test_limits_are_told() -> None:
    limited = ELBOW.format(axis="0 0 1").replace("</joint>", '<limit lower="-1"/></joint>')
    assert "limits belong in kindsl.toml" in only(pasted(limited)).message


@pytest.mark.parametrize("place", PLACES)
def test_comments_of_the_elements_stay_as_comments(place):
    joint = ELBOW.format(axis="0 0 1").replace("<parent", "<!--a\n b--><parent")
    after = taken_over(pasted(FOREARM.format(yaw="0") + joint, place))
    kept = [line for line in after.text.splitlines() if line.startswith("//")]
    assert kept == ["// bends", "// a", "// b"]
    assert not [finding for finding in after.findings if finding.code == "KD001"]


def test_comments_of_an_inertial_stay():
    text = INERTIAL.format(yaw="0").replace("<mass", "<!-- weighed --><mass")
    assert "// weighed\n" in taken_over(pasted(text, "in a link")).text


def test_a_link_within_its_own_inertia_is_not_taken_over() -> None:
    inside = f"mass = </inertial>\n</link>\n{HAND.replace('hand', 'upper')}"
    text = ARM.replace("mass =", inside, 1)
    assert ("link 'upper' of URDF cannot be taken over: it stands within what it would change") in [
        finding.message for finding in analyse(text).findings
    ]
