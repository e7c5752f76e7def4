"""What makes a command start and end quickly, and never with a traceback."""

import gc
import os
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, NoReturn

if TYPE_CHECKING:
    import argparse

DEFECT = 2
_WIDTH = 98


def run_and_exit(command: Callable[[], int]) -> NoReturn:
    """Run a command and end the process with its status, without tidying up what ends anyway.

    The garbage collector is off until the command wants it: importing makes no garbage, only many
    objects to look through. KINDSL_TRACEBACK shows where a defect of ours comes from.
    """
    gc.disable()
    try:
        status = command()
    except SystemExit as error:
        status = error.code if isinstance(error.code, int) else 1
    except Exception as error:
        if os.environ.get("KINDSL_TRACEBACK"):
            raise
        what = f"{type(error).__name__}: {error}"
        sys.stderr.write(f"kindsl: error: internal error: {what}\n")
        status = DEFECT
    _flush()
    os._exit(status)


def _flush() -> None:
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except (OSError, ValueError):
            continue


def help_formatter(prog: str) -> "argparse.HelpFormatter":
    """Return what lays out `--help`, without importing what measures the terminal."""
    import argparse

    columns = os.environ.get("COLUMNS", "")
    width = int(columns) - 2 if columns.isdigit() else _WIDTH
    return argparse.RawDescriptionHelpFormatter(prog, width=width)
