"""Knows SDFormat, of Gazebo and Drake.

Must not know the other formats.
"""

from typing import TYPE_CHECKING

from kindsl.interchange.format import (
    Format,
    ReadingChoices,
    ReadRobot,
    WritingChoices,
    WrittenRobot,
    file_reader,
)

if TYPE_CHECKING:
    from kindsl.mechanism.skeleton import Skeleton


def _parse(text: bytes | str, name: str, choices: ReadingChoices) -> ReadRobot:
    from kindsl.interchange.sdf.sdf_reading import robot_of_sdf

    return robot_of_sdf(text, name, floating=choices.floating)


def _write(name: str, skeleton: "Skeleton", choices: WritingChoices) -> WrittenRobot:
    from kindsl.interchange.sdf.writing import written_sdf

    return written_sdf(name, skeleton, choices)


FORMAT = Format("sdf", "SDF", (".sdf",), "", file_reader(_parse), _parse, _write)
