"""Knows MuJoCo's format, through MuJoCo.

Must not know the other formats.
"""

from kindsl.robots.interchange.format import Format, lazily

_read, _write = lazily("mjcf.mjcf_reading:read_mjcf"), lazily("mjcf.writing:written_mjcf")
FORMAT = Format("mjcf", "MJCF", (".xml", ".mjcf"), _read, write=_write)
