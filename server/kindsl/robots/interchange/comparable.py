"""A robot of another format as one to compare: its bodies, and where its numbers stand."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from kindsl.mechanics.rigid.body import NO_BODY
from kindsl.mechanics.rigid.joint_kind import JointKind
from kindsl.mechanics.rigid.pose import IDENTITY
from kindsl.robots.comparison.quantities import AXIS, INERTIA, POSE
from kindsl.robots.comparison.written import (
    Described,
    Numbers,
    WrittenInertia,
    WrittenNumber,
    WrittenPose,
    exactly_turned,
    written_frame,
)
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.robot_description import (
    DescribedLink,
    DescribedPart,
    RobotDescription,
)
from kindsl.robots.interchange.written_numbers import NO_NUMBERS, FileNumbers
from kindsl.robots.mechanism.skeleton import AttachedFrame, Skeleton

# A number is the one that was read only if it is equal: defaults and macros may have changed it.
_EQUAL = 1e-9


def described_robot(
    label: str, robot: RobotDescription, numbers: FileNumbers = NO_NUMBERS
) -> Described:
    """Return a robot to compare.

    Args:
        label: Name of its file.
        robot: As read from another format.
        numbers: Where its numbers stand, as far as they are known.

    Raises:
        FormatError: Two things have one name.
    """
    described = exactly_turned(
        label,
        skeleton_of_robot(robot),
        tuple(tuple(_inertias(link, numbers)) for link in robot.links),
        tuple(_pose(link, numbers) for link in robot.links[1:]),
        frozenset(_heavy_parts(robot)),
    )
    frames = {f.name: _frame(f, numbers) for f in described.skeleton.frames}
    return replace(described, frames=frames)


def _heavy_parts(robot: RobotDescription) -> Iterator[str]:
    for link in robot.links:
        for part in link.parts:
            if part.body is not None and part.body.mass:
                yield part.name


def skeleton_of_robot(robot: RobotDescription) -> Skeleton:
    """Return the bodies of a robot; a frame whose name is taken is left out.

    Raises:
        FormatError: Two links or joints have one name.
    """
    base, *links = robot.links
    kinds: list[JointKind] = [_kind(link) for link in links]
    bodies = [link.body or NO_BODY for link in robot.links]
    try:
        return Skeleton(
            base.name,
            tuple(link.name for link in links),
            tuple(link.joint for link in links),
            tuple(kinds),
            tuple(link.parent or 0 for link in links),
            tuple(link.parent_T_joint for link in links),
            (bodies[0] if robot.is_floating else NO_BODY, *bodies[1:]),
            robot.is_floating,
            tuple(_frames(robot)),
        )
    except ValueError as error:
        raise FormatError(str(error)) from None


def _kind(link: DescribedLink) -> JointKind:
    return "revolute" if link.joint_kind == "revolute" else "prismatic"


def _frames(robot: RobotDescription) -> Iterator[AttachedFrame]:
    taken = {link.name for link in robot.links}
    for body, link in enumerate(robot.links):
        for frame in link.frames:
            if frame.name not in taken:
                taken.add(frame.name)
                yield AttachedFrame(frame.name, body, frame.link_T_frame)


def _inertias(link: DescribedLink, numbers: FileNumbers) -> Iterator[WrittenInertia]:
    for part in link.parts:
        if part.body is not None:
            yield _inertia(part, numbers)


def _inertia(part: DescribedPart, numbers: FileNumbers) -> WrittenInertia:
    turn = numbers.turns.get(part.name, IDENTITY.rotation)
    form = WrittenInertia(part.name, part.body_T_link, turn, True, -1.0, (), ())
    values = form.values_of(part.body or NO_BODY)
    found = _found(numbers, "link", part.name, INERTIA, values)
    exact = tuple(v if n is None else n.value for v, n in zip(values, found, strict=True))
    return replace(form, values=exact, numbers=found)


def _frame(frame: AttachedFrame, numbers: FileNumbers) -> WrittenPose:
    form = written_frame(frame.name, frame.pose)
    return replace(form, numbers=_found(numbers, "frame", frame.name, POSE, form.values))


def _pose(link: DescribedLink, numbers: FileNumbers) -> WrittenPose:
    before, after = link.parent_T_origin, link.written_T_joint
    written = (numbers.found.get(("joint", link.joint, name)) for name in POSE)
    guess = tuple(0.0 if number is None else number.value for number in written)
    form = WrittenPose(link.joint, before, after, False, guess, ())
    values = form.values_of(link.parent_T_joint)
    found = _found(numbers, "joint", link.joint, POSE, values)
    axis = numbers.found.get(("joint", link.joint, AXIS))
    return replace(form, values=values, numbers=found, axis=axis)


def _found(
    numbers: FileNumbers, kind: str, owner: str, names: Sequence[str], values: Sequence[float]
) -> Numbers:
    found = (numbers.found.get((kind, owner, name)) for name in names)
    slack = _EQUAL * max(map(abs, values))
    return tuple(
        _read_as(value, number, slack) for number, value in zip(found, values, strict=True)
    )


def _read_as(value: float, number: WrittenNumber | None, slack: float) -> WrittenNumber | None:
    if number is not None and number.is_implied:
        return number._replace(value=value)
    return number if number is not None and abs(number.value - value) <= slack else None
