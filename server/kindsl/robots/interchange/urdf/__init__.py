"""Knows URDF.

Must not know the other formats.
"""

from kindsl.robots.interchange.format import Format, file_reader, lazily

_parse, _write = lazily("urdf.urdf_reading:robot_of_urdf"), lazily("urdf.writing:written_urdf")
FORMAT = Format("urdf", "URDF", (".urdf",), file_reader(_parse), _parse, _write)
