"""An MJCF: a document that reads without an error of syntax, or one clear sentence.

Input: the file's bytes. MuJoCo compiles it, unless it names other files.
"""

import tempfile
from pathlib import Path

from tests.fuzz.conversions import check_reading

from kindsl.robots.interchange.format import ReadingChoices
from kindsl.robots.interchange.mjcf.mjcf_reading import read_mjcf


def one_input(data: bytes) -> None:
    """Convert an MJCF, with a fixed and a floating base."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "robot.xml")
        file.write_bytes(data)
        check_reading(lambda is_floating: read_mjcf(file, ReadingChoices(is_floating)))
