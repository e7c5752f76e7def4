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
    from kindsl.robots.mechanism.linkage import Linkage


def _parse(text: bytes | str, name: str, choices: ReadingChoices) -> ReadRobot:
    from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf

    return robot_of_urdf(text, name, floating=choices.floating)


def _write(name: str, skeleton: "Linkage", choices: WritingChoices) -> WrittenRobot:
    from kindsl.robots.interchange.urdf.writing import written_urdf

    return written_urdf(name, skeleton, choices)


FORMAT = Format("urdf", "URDF", (".urdf",), "", file_reader(_parse), _parse, _write)
