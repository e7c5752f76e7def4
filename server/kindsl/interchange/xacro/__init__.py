"""Knows xacro through its own package: macros that expand to a URDF. Read only.

Must not know what is in a URDF.
"""

from pathlib import Path

from kindsl.interchange.format import Format, ReadRobot


def _read(path: Path, floating: bool) -> ReadRobot:
    from kindsl.interchange.urdf.reading import robot_of_urdf
    from kindsl.interchange.xacro.expansion import expanded

    return robot_of_urdf(expanded(path), path.stem, floating=floating)


FORMAT = Format("xacro", "xacro", (".xacro",), "xacro", _read)
