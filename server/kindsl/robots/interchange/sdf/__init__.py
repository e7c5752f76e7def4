"""Knows SDFormat, of Gazebo and Drake.

Must not know the other formats.
"""

from kindsl.robots.interchange.format import Format, lazily

_read, _parse = lazily("sdf.sdf_reading:read_sdf"), lazily("sdf.sdf_reading:robot_of_sdf")
FORMAT = Format("sdf", "SDF", (".sdf",), _read, _parse, lazily("sdf.writing:written_sdf"))
