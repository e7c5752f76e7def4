"""Knows URDF.

Must not know the other formats.
"""

from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.interchange.format import Format, ReadRobot, WritingChoices, WrittenRobot

if TYPE_CHECKING:
    from kindsl.mechanism.skeleton import Skeleton


def _read(path: Path, floating: bool) -> ReadRobot:
    from kindsl.interchange.urdf.reading import read_urdf

    return read_urdf(path, floating=floating)


def _write(name: str, skeleton: "Skeleton", choices: WritingChoices) -> WrittenRobot:
    from kindsl.interchange.urdf.writing import written_urdf

    return written_urdf(name, skeleton, choices)


FORMAT = Format("urdf", "URDF", (".urdf",), "", _read, _write)
