"""Knows SDFormat, of Gazebo and Drake.

Must not know the other formats.
"""

from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.interchange.format import Format, ReadRobot, WritingChoices, WrittenRobot

if TYPE_CHECKING:
    from kindsl.mechanism.skeleton import Skeleton


def _read(path: Path, floating: bool) -> ReadRobot:
    from kindsl.interchange.sdf.reading import read_sdf

    return read_sdf(path, floating=floating)


def _write(name: str, skeleton: "Skeleton", choices: WritingChoices) -> WrittenRobot:
    from kindsl.interchange.sdf.writing import written_sdf

    return written_sdf(name, skeleton, choices)


FORMAT = Format("sdf", "SDF", (".sdf",), "", _read, _write)
