"""The server: the protocol is the SDK's, the tools are ours."""

import contextlib
import gc
import logging
from pathlib import Path

import anyio
from mcp.server.lowlevel import Server
from mcp.server.stdio import stdio_server
from mcp.types import (
    CallToolRequestParams,
    CallToolResult,
    ListToolsResult,
    PaginatedRequestParams,
    Tool,
)

import kindsl
from kindsl.frontends.mcp.examples import examples
from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.tool import all_tools, answer, text
from kindsl.language.text.nearest import hint, nearest_name

_INSTRUCTIONS = (
    "Robots in the Kinematics-DSL (.kindsl). 'language' explains how to write one; 'check' each "
    "text that you write, 'view' it, and repair what is found before you go on."
)
_log = logging.getLogger(__name__)


def server_for(root: Path) -> Server:
    """Return a server whose tools read and write below a folder."""
    folder, tools = Folder(root), all_tools()

    async def list_tools(
        _context: object, _params: PaginatedRequestParams | None
    ) -> ListToolsResult:
        listed = ((tool, tool.arguments.model_json_schema()) for tool in tools.values())
        return ListToolsResult(
            tools=[Tool(name=t.name, description=t.description, input_schema=s) for t, s in listed]
        )

    async def call_tool(_context: object, params: CallToolRequestParams) -> CallToolResult:
        def run() -> CallToolResult:
            try:
                tool = tools.get(params.name)
                if tool is None:
                    near = hint(nearest_name(params.name, list(tools)), after=":")
                    raise ToolError(f"the tools are {', '.join(tools)}, not '{params.name}'{near}")
                return CallToolResult(content=[*answer(tool, params.arguments or {}, folder)])
            except ToolError as error:
                return CallToolResult(content=[text(str(error))], is_error=True)
            except Exception:
                _log.exception("%s failed", params.name)
                failure = f"{params.name} failed by an internal error; stderr has the details"
                return CallToolResult(content=[text(failure)], is_error=True)

        return await anyio.to_thread.run_sync(run)

    return Server(
        "kindsl",
        version=kindsl.__version__,
        instructions=_INSTRUCTIONS,
        on_list_tools=list_tools,
        on_call_tool=call_tool,
    )


async def serve_stdio(root: Path) -> None:
    """Serve until the client closes stdin."""
    server = server_for(root)
    async with stdio_server() as (reading, writing), anyio.create_task_group() as tasks:
        tasks.start_soon(anyio.to_thread.run_sync, _warm_up, Folder(root))
        await server.run(reading, writing, server.create_initialization_options())


def _warm_up(folder: Folder) -> None:
    """Load what the first answers need, while the client still greets."""
    tools, example = all_tools(), examples()[0]
    for name in ("check", "compute", "view"):
        with contextlib.suppress(ToolError):
            answer(tools[name], {"text": example}, folder)
    # The collector need not walk what was loaded, time and again.
    gc.freeze()
