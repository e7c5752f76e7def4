"""Start and end of a command: quick, and never with a traceback."""

import contextlib
import gc
import os
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, NoReturn

from kindsl.frontends.cli.console import write

if TYPE_CHECKING:
    import argparse

DEFECT = 2
_WIDTH = 98


def run_and_exit(command: Callable[[], int]) -> NoReturn:
    """Run a command and end the process with its status, skipping the interpreter's clean-up.

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
        write(sys.stderr, f"kindsl: error: internal error: {what}\n")
        status = DEFECT
    os._exit(_flushed(status))


def _flushed(status: object) -> int:
    try:
        if sys.stdout is not None:
            write(sys.stdout, "")
    except SystemExit as error:
        status = error.code
    with contextlib.suppress(OSError, ValueError, AttributeError):
        sys.stderr.flush()
    return status if isinstance(status, int) else DEFECT


def help_formatter(prog: str) -> "argparse.HelpFormatter":
    """Return the formatter of `--help`, without an import for the terminal's size."""
    import argparse

    columns = os.environ.get("COLUMNS", "")
    width = int(columns) - 2 if columns.isdigit() else _WIDTH
    return argparse.RawDescriptionHelpFormatter(prog, width=width)
