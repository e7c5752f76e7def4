"""Knows URDF.

Must not know the other formats.
"""

from typing import TYPE_CHECKING

from kindsl.robots.interchange.format import (
    Format,
    ReadingChoices,
    ReadRobot,
    WritingChoices,
    WrittenRobot,
    file_reader,
)

if TYPE_CHECKING:
    from kindsl.robots.interchange.written_numbers import FileNumbers
    from kindsl.robots.mechanism.linkage import Linkage


def _parse(text: bytes | str, name: str, choices: ReadingChoices) -> ReadRobot:
    from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf

    return robot_of_urdf(text, name, floating=choices.floating)


def _write(name: str, skeleton: "Linkage", choices: WritingChoices) -> WrittenRobot:
    from kindsl.robots.interchange.urdf.writing import written_urdf

    return written_urdf(name, skeleton, choices)


def _find_numbers(content: bytes | str) -> "FileNumbers":
    from kindsl.robots.interchange.urdf.numbers import numbers_of_urdf

    return numbers_of_urdf(content)


FORMAT = Format("urdf", "URDF", (".urdf",), "", file_reader(_parse), _parse, _write, _find_numbers)
