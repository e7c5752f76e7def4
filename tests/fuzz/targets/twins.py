"""Another file of the robot: whatever it is, what it says otherwise is told at a place.

Input: a document, a byte 0xff, a URDF.
"""

import tempfile
from pathlib import Path

from tests.support.finding_checks import EVERYTHING, assert_sound

from kindsl.judgement.analysis.analysis import analyse
from kindsl.robots.comparison.twins import TwinFile


def one_input(data: bytes) -> None:
    """Compare a document with its twin."""
    text, _, other = data.partition(b"\xff")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "twin.urdf")
        file.write_bytes(other)
        twins = (TwinFile(str(file), "twin.urdf"),)
        document = text.decode("utf-8", "surrogateescape")
        assert_sound(analyse(document, EVERYTHING._replace(twins=twins)))
