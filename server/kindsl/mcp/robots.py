"""Any description of a robot in the folder, to compare; only the named file is read."""

import re
from collections.abc import Mapping
from functools import partial
from pathlib import Path

from kindsl.comparison.compared_robot import ComparedRobot
from kindsl.comparison.document_side import described_document
from kindsl.interchange.descriptions import ReadDescription, read_description, read_robot
from kindsl.interchange.format import FormatError
from kindsl.interchange.registry import format_of_suffix
from kindsl.mcp.documents import BoundArguments, document
from kindsl.mcp.errors import ToolError
from kindsl.mcp.folder import Folder
from kindsl.mcp.mechanics import skeleton_of
from kindsl.text.lines import LineIndex

_DOCUMENT = ".kindsl"
_EVALUATED = "xacro"
_OTHER_FILES = re.compile(r"<include\b|\bfile\s*=")


def is_document(given: str) -> bool:
    """Return whether a path is a document's of ours."""
    return given.endswith(_DOCUMENT)


def compared_document(given: str, folder: Folder, parameters: Mapping[str, float]) -> ComparedRobot:
    """Return the robot of a document, its parameters with these values.

    Raises:
        ToolError: It cannot be read, or is no tree of bodies.
    """
    arguments = BoundArguments(path=given, text=None, parameters=dict(parameters))
    path, analysis = document(arguments, folder)
    skeleton, lines = skeleton_of(analysis), LineIndex(analysis.text)
    robot = described_document(path, analysis.model, analysis.context.values, skeleton)
    return ComparedRobot(
        path, robot, lambda at: lines.position(analysis.resolver.span(at)[0])[0] + 1
    )


def compared_other(
    given: str, folder: Folder, floating: bool | None
) -> tuple[ComparedRobot, tuple[str, ...]]:
    """Return the robot of another format, or of a folder of generated code, and notes on it.

    Args:
        given: The path.
        folder: Where it counts from.
        floating: Whether the root floats where the file leaves that open; None if nobody says.

    Raises:
        ToolError: It cannot be read, or needs other files.
    """
    path = folder.path(given)
    try:
        if path.is_dir():
            folder.require_own_files(given)
            read = read_description(path, given, floating)
        else:
            read = _read(given, folder, floating)
        return ComparedRobot(given, read.robot), read.notes
    except (FormatError, OSError) as error:
        raise ToolError(f"'{given}' cannot be read: {error}") from None
    except ModuleNotFoundError as error:
        raise ToolError(f"'{given}' cannot be read: {error.name} is not installed") from None


def _read(given: str, folder: Folder, floating: bool | None) -> ReadDescription:
    format = format_of_suffix(Path(given).suffix)
    if format is None:
        raise ToolError(f"'{given}' is no robot: name a .kindsl, .urdf, .sdf or .xml file")
    if format.name == _EVALUATED:
        raise ToolError("a xacro file runs expressions: convert it with 'kindsl convert' first")
    text = folder.read(given)
    if format.parse is None:
        if _OTHER_FILES.search(text):
            raise ToolError(f"'{given}' names other files, which this server does not read")
        return read_description(folder.path(given), given, floating)
    read = partial(format.parse, text, Path(given).stem)
    return read_robot(format, read, text.encode("utf-8", "replace"), given, floating)
