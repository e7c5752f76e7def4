"""Any description of a robot that is not a document of ours, to compare: a file or a folder."""

from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from kindsl.comparison.written import Described
from kindsl.interchange.comparable import described_robot
from kindsl.interchange.format import Format, FormatError, ReadingChoices
from kindsl.interchange.generated_folder import MANIFEST, described_generated
from kindsl.interchange.registry import all_formats, format_of_suffix
from kindsl.interchange.robcogen_folder import described_robcogen, is_robcogen_folder
from kindsl.interchange.written_numbers import NO_NUMBERS
from kindsl.rigid.body import NO_BODY
from kindsl.text.phrases import alternatives
from kindsl.text.regular import require_regular

# MuJoCo's format says of a root whether it floats; the others leave it to who reads them.
_TELLS_BASE = "mjcf"


class ReadDescription(NamedTuple):
    """A robot to compare, and notes on how it was read."""

    robot: Described
    notes: tuple[str, ...] = ()


def read_description(path: Path, label: str, floating: bool | None) -> ReadDescription:
    """Return the robot that a file describes.

    Args:
        path: The file.
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
    assert format.read is not None, "only formats that can be read are found"
    require_regular(str(path))
    read = format.read(path, ReadingChoices(bool(floating)))
    find, content = format.find_numbers, path.read_bytes()
    robot = described_robot(label, read.robot, find(content) if find else NO_NUMBERS)
    robot = replace(robot, properties=read.joints)
    if floating is None or format.name == _TELLS_BASE:
        return ReadDescription(robot)
    kind = "floating" if floating else "fixed"
    note = f"{label} leaves open whether its base floats: compared as {kind}, like the other"
    return ReadDescription(with_base(robot, floating), (note,))


def _of_folder(folder: Path, label: str) -> Described:
    if (folder / MANIFEST).is_file():
        return described_generated(folder, label)
    if is_robcogen_folder(folder):
        return described_robcogen(folder, label)
    raise FormatError("no generated code in this folder")


def with_base(robot: Described, floating: bool) -> Described:
    """Return a robot whose base floats or does not."""
    skeleton = robot.skeleton
    masses = skeleton.masses if floating else (NO_BODY, *skeleton.masses[1:])
    return replace(robot, skeleton=replace(skeleton, masses=masses, is_floating=floating))


def _format(path: Path) -> Format:
    format = format_of_suffix(path.suffix)
    if format is None or format.read is None:
        known = [suffix for f in all_formats() if f.read for suffix in f.suffixes]
        told = f"the suffix '{path.suffix}'" if path.suffix else "a name without a suffix"
        raise FormatError(f"{told} does not determine the format: use {alternatives(known)}")
    return format
