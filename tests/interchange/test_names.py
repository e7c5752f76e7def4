"""Names of other formats: whatever they are, the document has no finding about a name."""

from hypothesis import given, settings
from hypothesis import strategies as st

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.interchange.format import ReadRobot
from kindsl.robots.interchange.kindsl_writing import described_kindsl, kindsl_text, written_kindsl
from kindsl.robots.mechanism.linkage import BodyPart, Linkage, RigidBody

WORDS = ["arm", "Arm", "fr_arm", "arm_link", "arm_joint", "arm_frame", "arm_robot", "arm_2", "link"]
WORDS += ["union", "end", "floating", "2nd", "a b", "a-b", "é", "", "_", "world", "id", "PI"]
NAMES = st.sampled_from(WORDS) | st.text(max_size=3)
BESIDE = RigidPose(IDENTITY.rotation, (0.1, 0.0, 0.0))


@st.composite
def robots(draw: st.DrawFn) -> Linkage:
    bodies = []
    for index in range(draw(st.integers(2, 5))):
        frames = [_frame(name) for name in draw(st.lists(NAMES, max_size=3))]
        parent = draw(st.integers(0, index - 1)) if index else None
        bodies.append(RigidBody((BodyPart(draw(NAMES)), *frames), parent, draw(NAMES)))
    return Linkage(tuple(bodies), draw(st.booleans()), draw(NAMES))


def _frame(name: str) -> BodyPart:
    return BodyPart(name, BESIDE, is_link=False)


@settings(deadline=None)
@given(robots())
def test_no_name_is_found_fault_with(robot: Linkage) -> None:
    document = kindsl.parse(kindsl_text(robot), Settings())
    codes = ("KD0", "KD1", *(f"KD20{number}" for number in range(1, 8)), "KD408")
    assert [f.message for f in document.findings if f.code.startswith(codes)] == []
    assert [len(body.frames) for body in robot.bodies] == [
        len(body.frames) for body in document.model.bodies
    ]


@settings(deadline=None)
@given(robots())
def test_each_new_name_is_told_and_no_other(robot: Linkage) -> None:
    document = kindsl.parse(kindsl_text(robot), Settings())
    model = document.model
    kept = [
        (link.name == str(body.name), f"the link '{link.name}' is now '{body.name}'")
        for link, body in zip(robot.bodies, model.bodies, strict=True)
    ]
    kept += [
        (link.joint == str(joint.name), f"the joint '{link.joint}' is now '{joint.name}'")
        for link, joint in zip(robot.bodies[1:], model.joints, strict=True)
    ]
    frames = [frame for link in robot.bodies for frame in link.frames]
    kept += [
        (frame.name == str(now.name), f"the frame '{frame.name}' is now '{now.name}'")
        for frame, now in zip(frames, model.frames, strict=True)
    ]
    kept.append((robot.name == model.name, f"the robot '{robot.name}' is now '{model.name}'"))
    told = described_kindsl(ReadRobot(robot, ())).remarks
    assert told == tuple(sentence for is_kept, sentence in kept if not is_kept)


def test_equal_names_are_numbered_from_two() -> None:
    base = RigidBody((BodyPart("base"), *(_frame("tip") for _ in range(4))))
    told = described_kindsl(ReadRobot(Linkage((base,), name="arm"), ())).remarks
    names = ("tip_frame", "tip_2", "tip_3")
    assert told == tuple(f"the frame 'tip' is now '{name}'" for name in names)


def test_links_keep_their_names_before_joints_frames_and_the_robot() -> None:
    base = RigidBody((BodyPart("base"), _frame("arm"), _frame("fr_arm")))
    arm = RigidBody((BodyPart("arm"),), 0, "arm")
    read = ReadRobot(Linkage((base, arm), name="arm"), ("a note",))
    assert written_kindsl(read).remarks == (
        "a note",
        "the joint 'arm' is now 'arm_joint'",
        "the frame 'arm' is now 'arm_frame'",
        "the frame 'fr_arm' is now 'fr_arm_frame'",
        "the robot 'arm' is now 'arm_robot'",
    )
