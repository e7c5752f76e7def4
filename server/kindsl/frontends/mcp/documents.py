"""The document that a tool is about, a file of the folder or a text, and its bodies."""

from collections.abc import Callable
from typing import TypeVar

from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.tool import Arguments, Field
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.analysis.translated_robot import UnreadableRobotError, analysed_robot
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.lines import LineIndex
from kindsl.robots.interchange.syntaxes import syntax_of
from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError

_T = TypeVar("_T")

UNNAMED = "document.kindsl"


class DocumentArguments(Arguments):
    """A document, either `path` or `text`."""

    path: str | None = Field(
        None, description="A .kindsl, .urdf or .sdf file, from the server's folder"
    )
    text: str | None = Field(None, description="The whole document, instead of a path")


class BoundArguments(DocumentArguments):
    """A document and values of its parameters."""

    parameters: dict[str, float] = Field({}, description="Values of parameters by their names")


def document(arguments: DocumentArguments, folder: Folder) -> tuple[str, Analysis]:
    """Return what to call the robot, and its analysis to compute with.

    Raises:
        ToolError: There is not exactly one, or it cannot be read.
    """
    name, text, settings = _given(arguments, folder)
    try:
        return name, analysed_robot(arguments.path or "", text, settings)
    except UnreadableRobotError as error:
        first = next(iter(error.defects), None)
        line = "" if first is None else f"line {LineIndex(text).place(first.start)[0]}: "
        raise ToolError(line + (str(error) if first is None else first.message)) from None


def judged(arguments: DocumentArguments, folder: Folder) -> tuple[str, Analysis]:
    """Return what to call the robot, and the analysis of its file as it stands.

    Raises:
        ToolError: There is not exactly one, or it cannot be read.
    """
    name, text, settings = _given(arguments, folder)
    return name, Analysis(syntax_of(arguments.path or "", text), settings)


def _given(arguments: DocumentArguments, folder: Folder) -> tuple[str, str, Settings]:
    path, given = arguments.path, arguments.text
    if (path is None) == (given is None):
        raise ToolError("give either 'path' or 'text'" + (", not both" if path is not None else ""))
    name = UNNAMED if path is None else path
    settings = folder.settings_for(name)
    values = arguments.parameters if isinstance(arguments, BoundArguments) else {}
    found = folder.read(name) if given is None else given
    return name, found, settings.rebound(values) if values else settings


def built(analysis: Analysis, build: Callable[[], _T]) -> _T:
    """Return a document's mechanism or bodies.

    Raises:
        ToolError: It cannot be read whole, or is no tree of bodies.
    """
    for finding in analysis.findings:
        if finding.code.startswith("KD0") and finding.severity is Severity.ERROR:
            line = LineIndex(analysis.text).place(finding.start)[0]
            raise ToolError(f"line {line} cannot be read ({finding.code}): {finding.message}")
    try:
        return build()
    except UnboundParameterError as error:
        raise ToolError(f"{error}; give 'parameters'") from None
    except (ModelError, ModuleNotFoundError) as error:
        raise ToolError(str(error)) from None
