"""Compare the mechanics of two robots: what moves where, what weighs what.

Each is a file of any format (.kindsl, .urdf, .sdf, .xml of MuJoCo) or a folder of generated code.
Names of links, their frames and signs of axes do not count. Answers which numbers differ, the one
that changes torques most first.
"""

import json
import re
from functools import partial
from pathlib import Path

from kindsl.frontends.mcp.documents import BoundArguments, built, document
from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.tool import Arguments, Content, Field, text
from kindsl.judgement.analysis.compared_document import compared_document
from kindsl.language.semantics.expressions import Values
from kindsl.products.reports.mechanics import facts, lines, report_of
from kindsl.robots.comparison.side import ComparedSide
from kindsl.robots.interchange.descriptions import (
    ReadDescription,
    read_description,
    read_foreign,
    read_robot,
)
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.registry import format_of_suffix

_EVALUATED = "xacro"
_OTHER_FILES = re.compile(r"<include\b|\bfile\s*=")


class DiffArguments(Arguments):
    """Two robots."""

    a: str = Field(description="A file or folder, from the server's folder")
    b: str = Field(description="Another")
    parameters: dict[str, float] = Field({}, description="Values of parameters by their names")


def run(arguments: DiffArguments, folder: Folder) -> list[Content]:
    """Return what differs."""
    both, values = (arguments.a, arguments.b), arguments.parameters
    sides = {p: _compared_robot(p, folder, values) for p in both if p.endswith(".kindsl")}
    others = [path for path in both if path not in sides]
    foreign = read_foreign(others, sides.values(), partial(_read_other, folder))
    sides |= {path: read.robot for path, read in foreign.items()}
    notes = [f"note: {note}" for read in foreign.values() for note in read.notes]
    old, new = (sides[path] for path in both)
    report = report_of(old, new)
    found = "\n".join((*lines(report), *notes))
    return [text(found), text(json.dumps(facts(report), indent=1))]


def _compared_robot(given: str, folder: Folder, parameters: Values) -> ComparedSide:
    arguments = BoundArguments(path=given, text=None, parameters=dict(parameters))
    path, analysis = document(arguments, folder)
    return compared_document(
        path, analysis, analysis.context.values, built(analysis, analysis.skeleton)
    )


def _read_other(folder: Folder, given: str, floating: bool | None) -> ReadDescription:
    """Return the robot of another format, or of a folder of generated code.

    The root floats as `floating` says where the file leaves that open; None if nobody says.

    Raises:
        ToolError: It cannot be read, or needs other files.
    """
    path = folder.path(given)
    try:
        if path.is_dir():
            folder.require_own_files(given)
            return read_description(path, given, floating)
        return _read(given, folder, floating)
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
    return read_robot(read, given, floating)
