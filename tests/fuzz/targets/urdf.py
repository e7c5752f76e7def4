"""A URDF: a document that reads without an error of syntax, or one clear sentence.

Input: the file's bytes.
"""

from tests.fuzz.conversions import check_reading

from kindsl.robots.interchange.format import ReadingChoices
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf


def one_input(data: bytes) -> None:
    """Convert a URDF, with a fixed and a floating base."""
    check_reading(lambda is_floating: robot_of_urdf(data, "robot", ReadingChoices(is_floating)))
