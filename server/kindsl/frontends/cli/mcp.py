"""Lets an assistant check, view and compute robots: a Model Context Protocol server on stdio.

It reads and writes in the folder it is started in, and nowhere else.
"""

import argparse
import sys

SUMMARY = "run the server for assistants"
RUNS_LONG = True


def add_arguments(_parser: argparse.ArgumentParser) -> None:
    """Declare no options: the folder is where it is started."""


def run(_args: argparse.Namespace) -> int:
    """Serve until the client closes stdin.

    Returns:
        0; 2 when the protocol's library is not installed.
    """
    import asyncio
    from pathlib import Path

    try:
        from kindsl.frontends.mcp.server import serve_stdio
    except ModuleNotFoundError as error:
        needs = f"{error.name} is not installed: pip install 'kindsl[mcp]'"
        print(f"kindsl mcp: error: {needs}", file=sys.stderr)
        return 2
    asyncio.run(serve_stdio(Path.cwd()))
    return 0
