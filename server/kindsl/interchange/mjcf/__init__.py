"""Knows MuJoCo's format, through MuJoCo.

Must not know the other formats.
"""

from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.interchange.format import (
    Format,
    ReadingChoices,
    ReadRobot,
    WritingChoices,
    WrittenRobot,
)

if TYPE_CHECKING:
    from kindsl.mechanism.skeleton import Skeleton


def _read(path: Path, choices: ReadingChoices) -> ReadRobot:
    from kindsl.interchange.mjcf.mjcf_reading import read_mjcf

    return read_mjcf(path, floating=choices.floating)


def _write(name: str, skeleton: "Skeleton", choices: WritingChoices) -> WrittenRobot:
    from kindsl.interchange.mjcf.writing import written_mjcf

    return written_mjcf(name, skeleton, choices)


FORMAT = Format("mjcf", "MJCF", (".xml", ".mjcf"), "mjcf", _read, write=_write)
