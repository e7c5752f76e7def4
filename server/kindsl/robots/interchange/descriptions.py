"""Any description of a robot that is not a document of ours, to compare: a file or a folder."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import NamedTuple

from kindsl.language.text.phrases import counted
from kindsl.language.text.regular import require_regular
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
from kindsl.robots.interchange.format import (
    AS_WRITTEN,
    Format,
    FormatError,
    ReadingChoices,
    ReadRobot,
    n_mimics,
    suffix_unknown,
)
from kindsl.robots.interchange.generated_folder import MANIFEST, described_generated
from kindsl.robots.interchange.registry import all_formats, format_of_suffix
from kindsl.robots.interchange.robcogen_folder import described_robcogen, is_robcogen_folder
from kindsl.robots.interchange.written_numbers import FileNumbers
from kindsl.robots.mechanism.linkage import AttachedFrame, BodyPart, Linkage, RigidBody, checked

# A number is the one that was read only if it is equal: defaults and macros may have changed it.
_EQUAL = 1e-9


class ReadDescription(NamedTuple):
    """A robot to compare.

    Attributes:
        notes: On how it was read.
        tells_base: Whether the file says that the root floats, or that it is fixed.
    """

    robot: ComparedSide
    notes: tuple[str, ...] = ()
    tells_base: bool = True


def read_description(path: Path, label: str, floating: bool | None) -> ReadDescription:
    """Return the robot that a file describes.

    Args:
        label: Its name in messages.
        floating: Whether the root floats where the file leaves that open; None if nobody says.

    Raises:
        FormatError: It is not in its format, or no format is known.
        OSError: It cannot be read.
        ModuleNotFoundError: What the format needs is not installed.
    """
    if path.is_dir():
        return ReadDescription(_of_folder(path, label))
    path.stat()
    format = _format(path)
    assert format.read is not None, "every format is read"
    require_regular(str(path))
    return read_robot(partial(format.read, path), label, floating)


def read_foreign(
    paths: Iterable[str],
    documents: Iterable[ComparedSide],
    read: Callable[[str, bool | None], ReadDescription],
) -> dict[str, ReadDescription]:
    """Return descriptions to compare with documents, or with each other, by their paths.

    Where one leaves open whether its base floats, that is as with a document, or else as with
    one that tells.

    Args:
        paths: Those of other formats.
        documents: The documents, if any.
        read: Takes a path, and whether its base floats where the file leaves that open, None if
            nobody says.
    """
    bases = [document.skeleton.is_floating for document in documents]
    found = {} if bases else {path: read(path, None) for path in paths}
    bases += [each.robot.skeleton.is_floating for each in found.values() if each.tells_base]
    if not bases:
        return found
    return {
        path: found[path] if path in found and found[path].tells_base else read(path, bases[0])
        for path in paths
    }


def read_robot(
    read: Callable[[ReadingChoices], ReadRobot], label: str, floating: bool | None
) -> ReadDescription:
    """Return the robot of a file's content, its base as the file says, else as others do.

    Args:
        read: Reads it.
        label: Its name in messages.
        floating: Whether the root floats where the file leaves that open; None if nobody says.

    Raises:
        FormatError: It is not in its format.
    """
    found = read(AS_WRITTEN)
    asked = None if found.tells_base else floating
    if asked:
        found = read(ReadingChoices(floating=True))
    robot = described_robot(label, found.robot, found.find_numbers())
    gaps = (b.name for b in found.robot.bodies if found.unknown & {part.name for part in b.parts})
    robot = replace(robot, properties=found.joints, unknown=frozenset(gaps))
    notes = [f"{label}: {reason}" for reason in found.refused[:1]]
    mimics = n_mimics(found.remarks)
    if mimics:
        told = f"{counted(mimics, 'mimicking joint')} of {label}"
        notes.append(f"{told} compared as if independent")
    if asked is False:
        fixed = replace(robot.skeleton, is_floating=False).without_mass_at_rest()
        robot = replace(robot, skeleton=fixed)
    if asked is not None:
        told = f"{label} leaves open whether its base floats"
        kind = "floating" if asked else "fixed"
        notes.append(f"{told}: compared as {kind}, like the other")
    return ReadDescription(robot, tuple(notes), found.tells_base)


def _of_folder(folder: Path, label: str) -> ComparedSide:
    if (folder / MANIFEST).is_file():
        return described_generated(folder, label)
    if is_robcogen_folder(folder):
        return described_robcogen(folder, label)
    raise FormatError("no generated code in this folder")


def _format(path: Path) -> Format:
    format = format_of_suffix(path.suffix)
    if format is None:
        known = [suffix for format in all_formats() for suffix in format.suffixes]
        raise FormatError(suffix_unknown(path.suffix, known))
    return format


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
    return replace(form, values=values, numbers=found)


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
