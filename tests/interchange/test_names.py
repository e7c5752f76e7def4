"""Names of other formats: whatever they are, the document has no finding about a name."""

from hypothesis import given, settings
from hypothesis import strategies as st

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.interchange.format import ReadRobot
from kindsl.robots.interchange.kindsl_writing import kindsl_text, written_kindsl
from kindsl.robots.interchange.robot_description import (
    DescribedFrame,
    DescribedLink,
    RobotDescription,
)

WORDS = ["arm", "Arm", "fr_arm", "arm_link", "arm_joint", "arm_frame", "arm_robot", "arm_2", "link"]
WORDS += ["union", "end", "floating", "2nd", "a b", "a-b", "é", "", "_", "world", "id", "PI"]
NAMES = st.sampled_from(WORDS) | st.text(max_size=3)
BESIDE = RigidPose(IDENTITY.rotation, (0.1, 0.0, 0.0))


@st.composite
def robots(draw: st.DrawFn) -> RobotDescription:
    links = []
    for index in range(draw(st.integers(2, 5))):
        frames = tuple(DescribedFrame(name, BESIDE) for name in draw(st.lists(NAMES, max_size=3)))
        parent = draw(st.integers(0, index - 1)) if index else None
        link = draw(NAMES), None, frames, parent, draw(NAMES), "revolute", IDENTITY
        links.append(DescribedLink(*link))
    return RobotDescription(draw(NAMES), draw(st.booleans()), tuple(links))


@settings(deadline=None)
@given(robots())
def test_no_name_is_found_fault_with(robot: RobotDescription) -> None:
    document = kindsl.parse(kindsl_text(robot), Settings())
    codes = ("KD0", "KD1", "KD2", "KD408")
    assert [f.message for f in document.findings if f.code.startswith(codes)] == []
    assert [len(link.frames) for link in robot.links] == [
        len(body.frames) for body in document.model.bodies
    ]


@settings(deadline=None)
@given(robots())
def test_each_new_name_is_told_and_no_other(robot: RobotDescription) -> None:
    document = kindsl.parse(kindsl_text(robot), Settings())
    model = document.model
    kept = [
        (link.name == str(body.name), f"the link '{link.name}' is now '{body.name}'")
        for link, body in zip(robot.links, model.bodies, strict=True)
    ]
    kept += [
        (link.joint == str(joint.name), f"the joint '{link.joint}' is now '{joint.name}'")
        for link, joint in zip(robot.links[1:], model.joints, strict=True)
    ]
    frames = [frame for link in robot.links for frame in link.frames]
    kept += [
        (frame.name == str(now.name), f"the frame '{frame.name}' is now '{now.name}'")
        for frame, now in zip(frames, model.frames, strict=True)
    ]
    kept.append((robot.name == model.name, f"the robot '{robot.name}' is now '{model.name}'"))
    told = written_kindsl(ReadRobot(robot, ())).remarks
    assert told == tuple(sentence for is_kept, sentence in kept if not is_kept)


def test_equal_names_are_numbered_from_two() -> None:
    frames = tuple(DescribedFrame("tip", BESIDE) for _ in range(4))
    base = DescribedLink("base", None, frames, None, "", "", IDENTITY)
    told = written_kindsl(ReadRobot(RobotDescription("arm", False, (base,)), ())).remarks
    names = ("tip_frame", "tip_2", "tip_3")
    assert told == tuple(f"the frame 'tip' is now '{name}'" for name in names)


def test_links_keep_their_names_before_joints_frames_and_the_robot() -> None:
    frames = (DescribedFrame("arm", BESIDE), DescribedFrame("fr_arm", BESIDE))
    base = DescribedLink("base", None, frames, None, "", "", IDENTITY)
    arm = DescribedLink("arm", None, (), 0, "arm", "revolute", IDENTITY)
    read = ReadRobot(RobotDescription("arm", False, (base, arm)), ("a note",))
    assert written_kindsl(read).remarks == (
        "a note",
        "the joint 'arm' is now 'arm_joint'",
        "the frame 'arm' is now 'arm_frame'",
        "the frame 'fr_arm' is now 'fr_arm_frame'",
        "the robot 'arm' is now 'arm_robot'",
    )
