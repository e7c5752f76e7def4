"""Knows xacro through its own package: macros that expand to a URDF. Read only.

It evaluates Python expressions of the file, so it runs in a process of its own, bounded in time.

Must not know what is in a URDF.
"""

from pathlib import Path

from kindsl.robots.interchange.format import Format, ReadingChoices, ReadRobot

_EVALUATED = "its Python expressions were evaluated: convert only xacro files that you trust"


def _read(path: Path, choices: ReadingChoices) -> ReadRobot:
    from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf
    from kindsl.robots.interchange.xacro.expansion import expanded

    read = robot_of_urdf(expanded(path, choices), path.stem, choices)
    return read._replace(remarks=(_EVALUATED, *read.remarks), find_numbers=dict)


FORMAT = Format("xacro", "xacro", (".xacro",), _read)
