"""Knows SDFormat, of Gazebo and Drake.

Must not know the other formats.
"""

from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.robots.interchange.format import (
    Format,
    ReadingChoices,
    ReadRobot,
    WritingChoices,
    WrittenRobot,
)

if TYPE_CHECKING:
    from kindsl.robots.mechanism.linkage import Linkage


def _parse(text: bytes | str, name: str, choices: ReadingChoices) -> ReadRobot:
    from kindsl.robots.interchange.sdf.sdf_reading import robot_of_sdf

    return robot_of_sdf(text, name, floating=choices.floating)


def _read(path: Path, choices: ReadingChoices) -> ReadRobot:
    from kindsl.robots.interchange.sdf.including import searched_folders
    from kindsl.robots.interchange.sdf.sdf_reading import robot_of_sdf

    searched = searched_folders(path, choices.model_paths)
    content = path.read_bytes()
    return robot_of_sdf(content, path.stem, floating=choices.floating, searched=searched)


def _write(name: str, skeleton: "Linkage", choices: WritingChoices) -> WrittenRobot:
    from kindsl.robots.interchange.sdf.writing import written_sdf

    return written_sdf(name, skeleton, choices)


FORMAT = Format("sdf", "SDF", (".sdf",), "", _read, _parse, _write)
