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
    from kindsl.robots.interchange.written_numbers import FileNumbers
    from kindsl.robots.mechanism.linkage import Linkage


def _read(path: Path, choices: ReadingChoices) -> ReadRobot:
    from kindsl.robots.interchange.mjcf.mjcf_reading import read_mjcf

    return read_mjcf(path, floating=choices.floating)


def _write(name: str, skeleton: "Linkage", choices: WritingChoices) -> WrittenRobot:
    from kindsl.robots.interchange.mjcf.writing import written_mjcf

    return written_mjcf(name, skeleton, choices)


def _find_numbers(content: bytes | str) -> "FileNumbers":
    from kindsl.robots.interchange.mjcf.numbers import numbers_of_mjcf

    return numbers_of_mjcf(content)


FORMAT = Format(
    "mjcf", "MJCF", (".xml", ".mjcf"), "mjcf", _read, write=_write, find_numbers=_find_numbers
)
