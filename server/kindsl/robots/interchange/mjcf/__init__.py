"""Knows MuJoCo's format, through MuJoCo.

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


def _read(path: Path, choices: ReadingChoices) -> ReadRobot:
    from kindsl.robots.interchange.mjcf.mjcf_reading import read_mjcf

    return read_mjcf(path, floating=choices.floating)


def _write(name: str, skeleton: "Linkage", choices: WritingChoices) -> WrittenRobot:
    from kindsl.robots.interchange.mjcf.writing import written_mjcf

    return written_mjcf(name, skeleton, choices)


FORMAT = Format("mjcf", "MJCF", (".xml", ".mjcf"), "mjcf", _read, write=_write)
