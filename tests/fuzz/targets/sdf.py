"""An SDF: a document that reads without an error of syntax, or one clear sentence.

Input: the file's bytes.
"""

from tests.fuzz.conversions import check_reading

from kindsl.robots.interchange.format import ReadingChoices
from kindsl.robots.interchange.sdf.sdf_reading import robot_of_sdf


def one_input(data: bytes) -> None:
    """Convert an SDF, with a fixed and a floating base."""
    check_reading(lambda is_floating: robot_of_sdf(data, "robot", ReadingChoices(is_floating)))
