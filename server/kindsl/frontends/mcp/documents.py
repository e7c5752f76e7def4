"""The document that a tool is about: a file of the folder, or a text."""

from kindsl.frontends.mcp.errors import ToolError
from kindsl.frontends.mcp.folder import Folder
from kindsl.frontends.mcp.tool import Arguments, Field
from kindsl.judgement.analysis.analysis import Analysis, analyse

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
    if given is not None:
        name, found, settings = UNNAMED, given, folder.settings_for(UNNAMED)
    else:
        assert path is not None
        name, found, settings = path, folder.read(path), folder.settings_for(path)
    values = arguments.parameters if isinstance(arguments, BoundArguments) else {}
    return name, analyse(found, settings.rebound(values) if values else settings)
