"""What holds of a robot that was read from another format."""

from collections.abc import Callable

from kindsl.judgement.analysis.analysis import analyse
from kindsl.robots.interchange.format import FormatError, ReadRobot
from kindsl.robots.interchange.kindsl_writing import kindsl_text


def check_reading(read: Callable[[bool], ReadRobot]) -> None:
    """Check that a file is a document without an error of syntax, or refused in a sentence.

    Args:
        read: Reads the file, given whether its base floats.
    """
    for is_floating in (False, True):
        try:
            robot = read(is_floating).robot
        except FormatError as error:
            assert str(error) and not str(error).endswith(".")
            continue
        text = kindsl_text(robot)
        found = [f for f in analyse(text).findings if f.code.startswith(("KD0", "KD1", "KD2"))]
        assert found == [], f"{found[0].message}\n{text}"
