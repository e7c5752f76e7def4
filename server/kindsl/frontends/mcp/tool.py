"""The tools, found by walking `tools`: each module is called as its tool and holds one.

A module has a docstring, which assistants read, and `run`, whose arguments' type is what it takes.
"""

from collections.abc import Callable
from importlib import import_module
from typing import Any, NamedTuple, get_type_hints

from mcp.types import ImageContent, TextContent
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from kindsl.frontends.mcp import tools
from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.language.text.modules import module_names
from kindsl.language.text.nearest import hint, nearest_name

Content = TextContent | ImageContent


class Arguments(BaseModel):
    """The arguments of a tool: those that a subclass names, and no others."""

    model_config = ConfigDict(extra="forbid", strict=True)


class Tool(NamedTuple):
    """A tool; `run` takes its arguments and the folder, and raises ToolError."""

    name: str
    description: str
    arguments: type[Arguments]
    run: Callable[[Any, Folder], list[Content]]


def all_tools() -> dict[str, Tool]:
    """Return the tools by their names."""
    return {name: _tool(name) for name in module_names(tools)}


def answer(tool: Tool, given: dict[str, Any], folder: Folder) -> list[Content]:
    """Return what a tool says.

    Raises:
        ToolError: The arguments are wrong, or it cannot do what they ask.
    """
    try:
        arguments = tool.arguments.model_validate(given)
    except ValidationError as error:
        raise ToolError(_what_is_right(tool, error)) from None
    return tool.run(arguments, folder)


def text(content: str) -> Content:
    """Return a text that cannot fail to be sent."""
    return TextContent(type="text", text=content.encode("utf-8", "replace").decode("utf-8"))


def _tool(name: str) -> Tool:
    module = import_module(f"kindsl.frontends.mcp.tools.{name}")
    arguments = get_type_hints(module.run)["arguments"]
    return Tool(name, str(module.__doc__).strip(), arguments, module.run)


def _what_is_right(tool: Tool, error: ValidationError) -> str:
    first = error.errors(include_url=False, include_input=False, include_context=False)[0]
    name, fields = str(first["loc"][0]), tool.arguments.model_fields
    takes = f"{tool.name} takes {', '.join(fields)}"
    if name not in fields:
        return f"{takes}, not '{name}'{hint(nearest_name(name, list(fields)), after=':')}"
    meant = fields[name].description or ""
    if first["type"] == "missing":
        return f"{tool.name} needs '{name}': {meant[:1].lower()}{meant[1:]}"
    return f"'{name}' of {tool.name} {first['msg'].lower().removeprefix('input ')}: {meant}"


__all__ = ["Arguments", "Content", "Field", "Tool", "all_tools", "answer", "text"]
