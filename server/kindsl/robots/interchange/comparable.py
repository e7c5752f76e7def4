"""A robot of another format as one to compare: its bodies, and where its numbers stand."""

from collections.abc import Sequence
from dataclasses import replace

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import IDENTITY, pose_from_fixed_axes
from kindsl.robots.comparison.quantities import AXIS, INERTIA, POSE, TURNS
from kindsl.robots.comparison.side import ComparedSide, exactly_turned
from kindsl.robots.comparison.written import (
    Numbers,
    WrittenInertia,
    WrittenNumber,
    WrittenPose,
    written_frame,
)
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.written_numbers import FileNumbers
from kindsl.robots.mechanism.linkage import AttachedFrame, BodyPart, Linkage, RigidBody, checked

# A number is the one that was read only if it is equal: defaults and macros may have changed it.
_EQUAL = 1e-9


def described_robot(label: str, robot: Linkage, numbers: FileNumbers) -> ComparedSide:
    """Return a robot to compare.

    Args:
        label: Name of its file.
        robot: As read from another format.
        numbers: Where its numbers stand, as far as they are known.

    Raises:
        FormatError: Two links or joints have one name.
    """
    try:
        whole = checked(robot).without_mass_at_rest()
    except ValueError as error:
        raise FormatError(str(error)) from None
    heavy = (p.name for body in robot.bodies for p in body.parts if p.mass and p.mass.mass)
    described = ComparedSide(
        label,
        whole,
        tuple(
            tuple(_inertia(p, p.mass, numbers) for p in body.parts if p.mass is not None)
            for body in robot.bodies
        ),
        tuple(_pose(body, numbers) for body in robot.bodies[1:]),
        frozenset(heavy),
        {f.name: _frame(f, numbers) for f in whole.frames},
    )
    return exactly_turned(described)


def _inertia(part: BodyPart, mass: MassDistribution, numbers: FileNumbers) -> WrittenInertia:
    turns = [numbers.get(("link", part.name, name)) for name in TURNS]
    roll, pitch, yaw = (0.0 if turn is None else turn.value for turn in turns)
    turned = pose_from_fixed_axes(IDENTITY.translation, (roll, pitch, yaw)).rotation
    form = WrittenInertia(part.name, (), (), part.pose, turned, is_about_com=True)
    values = form.values_of(mass)
    found = _found(numbers, "link", part.name, INERTIA, values)
    exact = tuple(v if n is None else n.value for v, n in zip(values, found, strict=True))
    return replace(form, values=exact, numbers=found)


def _frame(frame: AttachedFrame, numbers: FileNumbers) -> WrittenPose:
    form = written_frame(frame.name, frame.pose)
    return replace(form, numbers=_found(numbers, "frame", frame.name, POSE, form.values))


def _pose(body: RigidBody, numbers: FileNumbers) -> WrittenPose:
    written = (numbers.get(("joint", body.joint, name)) for name in POSE)
    guess = tuple(0.0 if number is None else number.value for number in written)
    form = WrittenPose(body.joint, guess, (), body.origin, body.written_T_joint, False)
    values = form.values_of(body.placement)
    found = _found(numbers, "joint", body.joint, POSE, values)
    axis = numbers.get(("joint", body.joint, AXIS))
    return replace(form, values=values, numbers=found, axis=axis)


def _found(
    numbers: FileNumbers, kind: str, owner: str, names: Sequence[str], values: Sequence[float]
) -> Numbers:
    found = (numbers.get((kind, owner, name)) for name in names)
    slack = _EQUAL * max(map(abs, values))
    return tuple(
        _read_as(value, number, slack) for number, value in zip(found, values, strict=True)
    )


def _read_as(value: float, number: WrittenNumber | None, slack: float) -> WrittenNumber | None:
    if number is not None and number.is_implied:
        return number._replace(value=value)
    return number if number is not None and abs(number.value - value) <= slack else None
