"""`CMakeLists.txt`: the headers to find, and the library of what is compiled."""

from collections.abc import Iterable

from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

_TEXT = template("robcogen/CMakeLists.txt")


def build(robot: GeneratedRobot, files: Iterable[str], has_runtime: bool) -> dict[str, str]:
    """Return the file by its name.

    Args:
        robot: The robot.
        files: The names of all headers and sources.
        has_runtime: Whether `iit/rbd` is among them.
    """
    named = [name for name in files if "iit/rbd/" not in name]
    runtime = "install(DIRECTORY iit/rbd DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/iit)\n"
    text = robot.filled(
        _TEXT,
        GENERATOR=robot.library.stamp.generator,
        DOCUMENT=robot.library.stamp.document,
        LOWER=robot.space.lower(),
        UPPER=robot.space.upper(),
        VERSION=robot.library.version,
        RUNTIME="${CMAKE_CURRENT_SOURCE_DIR}" if has_runtime else "",
        SOURCE=" ".join(name for name in named if name.endswith(".cpp")),
        HEADERS="\n  ".join(name for name in named if name.endswith(".h")),
        INSTALLED_RUNTIME=runtime if has_runtime else "",
    )
    return {"CMakeLists.txt": text}
