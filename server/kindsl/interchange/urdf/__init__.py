"""Knows URDF, and xacro through its own package.

Must not know the other formats.
"""

from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.interchange.format import Format, ReadRobot, WritingChoices, WrittenRobot

if TYPE_CHECKING:
    from kindsl.dynamics.bodies import Bodies


def _read(path: Path, floating: bool) -> ReadRobot:
    from kindsl.interchange.urdf.reading import read_urdf

    return read_urdf(path, floating=floating)


def _write(name: str, bodies: "Bodies", choices: WritingChoices) -> WrittenRobot:
    from kindsl.interchange.urdf.writing import urdf_remarks, urdf_text

    text = urdf_text(name, bodies, choices)
    return WrittenRobot(text, tuple(urdf_remarks(bodies, choices)))


FORMAT = Format("urdf", "URDF", (".urdf",), "convert", _read, _write)
