"""Documents with one of everything: all that is read of them and written, number by number.

Of a document of another format that is the one of ours that it becomes, its notes, what is told of
joints, and for comparing where each number stands and in which form.
"""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.support.recorded import assert_as_recorded

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import JointProperties
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.comparison.written import TextPlace, WrittenNumber
from kindsl.robots.interchange.descriptions import ReadDescription, read_description
from kindsl.robots.interchange.format import AS_WRITTEN, ORDINARY, ReadRobot, WritingChoices
from kindsl.robots.interchange.kindsl_writing import written_kindsl
from kindsl.robots.interchange.registry import format_named, format_of_suffix

DOCUMENTS = Path(__file__).parent / "documents"
FORMATS = (".sdf", ".urdf", ".xml")
READ = sorted(path for path in DOCUMENTS.iterdir() if path.suffix in FORMATS)
RECORDED = Path(__file__).parent / "recorded"
ENDLESS = WritingChoices(
    endless_joints=True,
    joints={
        "shoulder": JointProperties(-1.5, 2.0, 80.0, 3.0, 0.1, 0.5, 0.25),
        "upper": JointProperties(maximum=0.5, damping=0.125),
        "wrist": JointProperties(effort=7.0, velocity=9.0, friction=0.75),
        "spin": JointProperties(minimum=-3.0, effort=5.0),
        "lift": JointProperties(),
    },
)
_NUMBER = re.compile(r"-?\d+\.\d+(?:e[+-]?\d+)?")


@pytest.mark.parametrize("path", READ, ids=lambda path: path.name)
def test_all_that_is_read_is_as_recorded(path: Path) -> None:
    format = format_of_suffix(path.suffix)
    told = [*_imported(format.read(path, AS_WRITTEN))]
    described = read_description(path, path.name, floating=None)
    told += _compared(described, path.read_text("utf-8"))
    assert_as_recorded(RECORDED / f"{path.name}.txt", map(rounded, told))


def test_all_that_is_read_of_generated_code_is_as_recorded() -> None:
    described = read_description(DOCUMENTS / "robcogen", "robcogen", floating=None)
    text = (DOCUMENTS / "robcogen" / "inertia_properties.cpp").read_text("utf-8")
    told = _compared(described, text, is_about_com=False)
    assert_as_recorded(RECORDED / "robcogen.txt", map(rounded, told))


@pytest.mark.parametrize("format", ["mjcf", "sdf", "urdf"])
def test_all_that_is_written_is_as_recorded(format: str) -> None:
    text = (DOCUMENTS / "written.kindsl").read_text("utf-8")
    told = []
    for base, choices in (("torso", ENDLESS), ("torso floating", ORDINARY)):
        skeleton = kindsl.parse(text.replace("Base torso", f"Base {base}"), Settings()).skeleton()
        made = format_named(format).write("written", skeleton, choices)
        told += [*made.remarks, *made.text.splitlines()]
    assert_as_recorded(RECORDED / f"written.{format}.txt", map(rounded, told))


def rounded(line: str) -> str:
    """Return a line whose numbers have the digits that are the same on every machine."""
    return _NUMBER.sub(lambda number: f"{round(float(number[0]), 12) + 0.0:.12g}", line)


def _imported(read: ReadRobot) -> Iterator[str]:
    made = written_kindsl(read)
    yield f"tells its base: {read.tells_base}"
    yield from made.remarks
    for name, own in made.joints.items():
        given = ((what, value) for what, value in own._asdict().items() if value is not None)
        yield f"{name}: {', '.join(f'{what} {value}' for what, value in given)}"
    yield from made.text.splitlines()


def _compared(read: ReadDescription, text: str, *, is_about_com: bool = True) -> Iterator[str]:
    robot = read.robot
    skeleton = robot.skeleton
    yield f"compared as floating: {skeleton.is_floating}, {read.tells_base}"
    yield f"base of {skeleton.masses[0].mass} kg, joints {skeleton.joint_kinds}"
    yield f"on {skeleton.parents}, frames on {[frame.body for frame in skeleton.frames]}"
    yield from read.notes
    yield f"with a mass of their own: {sorted(robot.heavy_frames)}"
    yield f"told of joints: {sorted(robot.properties)}"
    for name, parts in zip(skeleton.body_names, robot.inertias, strict=True):
        for part in parts:
            turn = [value for row in part.turn for value in row]
            assert part.is_about_com == is_about_com
            assert part.sign == (-1.0 if is_about_com else 1.0)
            pairs = zip(part.values, part.numbers, strict=True)
            slack = 1e-9 * max(map(abs, part.values))
            assert all(n is None or abs(n.value - value) <= slack for value, n in pairs)
            yield f"in {name}: {part.owner} at {_pose(part.body_T_frame)}, moments along {turn}"
            yield from _numbers(part.values, part.numbers, text)
    for pose in (*robot.joints, *robot.frames.values()):
        way = "own axes" if pose.is_intrinsic else "fixed axes"
        yield f"pose of {pose.owner} in {_pose(pose.before)}, then {_pose(pose.after)}, {way}"
        yield from _numbers(pose.values, pose.numbers, text)
        if pose.axis is not None:
            yield f"    axis {_place(pose.axis, text)}"


def _pose(pose: RigidPose) -> str:
    return f"{list(pose.numbers)}"


def _numbers(values: tuple, numbers: tuple, text: str) -> Iterator[str]:
    for value, number in zip(values, numbers, strict=True):
        yield f"    {float(value)} {'' if number is None else _place(number, text)}".rstrip()


def _place(number: WrittenNumber, text: str) -> str:
    assert isinstance(number.at, TextPlace)
    line = text.count("\n", 0, number.at.start) + 1
    shown = text[number.at.start : number.at.end]
    shown = f"{number.at.file}: {shown}" if number.at.file else shown
    implied = " implied" if number.is_implied else f" half {number.half}"
    return f"line {number.at.line} of {line} {shown!r} {number.text!r}{implied}"
