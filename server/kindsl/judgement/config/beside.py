"""Finds the robot of a transforms document."""

import os
from collections.abc import Callable

from kindsl.judgement.config.robots import SUFFIX


def robot_beside(path: str, robot: str | None, name_of: Callable[[str], str | None]) -> str | None:
    """Return the file of the robot in the same folder, None if that is ambiguous.

    It is the document of the same name, else the one with the same robot, else the only one.

    Args:
        path: The transforms document.
        robot: The robot's name in it, if there is one.
        name_of: Returns the name of the robot that a file describes, None without one.
    """
    same_name = os.path.splitext(path)[0] + SUFFIX
    if os.path.isfile(same_name):
        return same_name
    folder = os.path.dirname(path) or os.curdir
    files = [os.path.join(folder, name) for name in sorted(os.listdir(folder))]
    robots = [file for file in files if file.endswith(SUFFIX)]
    chosen = [file for file in robots if robot is not None and name_of(file) == robot] or robots
    return chosen[0] if len(chosen) == 1 else None
