"""The document that a tool is about, a file of the folder or a text, and its bodies."""

from collections.abc import Callable
from typing import TypeVar

from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.tool import Arguments, Field
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.lines import LineIndex
from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError

_T = TypeVar("_T")

UNNAMED = "document.kindsl"


class DocumentArguments(Arguments):
    """A document, either `path` or `text`."""

    path: str | None = Field(None, description="A .kindsl file, from the server's folder")
    text: str | None = Field(None, description="The whole document, instead of a path")


class BoundArguments(DocumentArguments):
    """A document and values of its parameters."""

    parameters: dict[str, float] = Field({}, description="Values of parameters by their names")


def document(arguments: DocumentArguments, folder: Folder) -> tuple[str, Analysis]:
    """Return what to call the document, and its analysis.

    Raises:
        ToolError: There is not exactly one, or it cannot be read.
    """
    path, given = arguments.path, arguments.text
    if (path is None) == (given is None):
        raise ToolError("give either 'path' or 'text'" + (", not both" if path is not None else ""))
    name = UNNAMED if path is None else path
    settings = folder.settings_for(name)
    values = arguments.parameters if isinstance(arguments, BoundArguments) else {}
    found = folder.read(name) if given is None else given
    return name, analyse(found, settings.rebound(values) if values else settings)


def built(analysis: Analysis, build: Callable[[], _T]) -> _T:
    """Return a document's mechanism or bodies.

    Raises:
        ToolError: It cannot be read whole, or is no tree of bodies.
    """
    for finding in analysis.findings:
        if finding.code.startswith("KD0") and finding.severity is Severity.ERROR:
            line = LineIndex(analysis.text).position(finding.start)[0] + 1
            raise ToolError(f"line {line} cannot be read ({finding.code}): {finding.message}")
    try:
        return build()
    except UnboundParameterError as error:
        raise ToolError(f"{error}; give 'parameters'") from None
    except (ModelError, ModuleNotFoundError) as error:
        raise ToolError(str(error)) from None
