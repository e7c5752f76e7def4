"""The commands that a page shows in its ```console blocks, and what they print."""

import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

PROMPT = "$ "
ANYTHING = "..."
_BLOCK = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_PATIENCE = 120  # seconds


@dataclass(frozen=True, slots=True)
class Command:
    """A command of a page.

    Attributes:
        text: What is typed behind the prompt.
        expected: The lines that the page shows below it; `...` stands for any lines.
        start: Offset in the page of the first of these lines.
        end: Offset in the page behind the last.
    """

    text: str
    expected: tuple[str, ...]
    start: int
    end: int


def commands_of(page: str) -> list[Command]:
    """Return the commands of a page, in order."""
    return [command for block in _BLOCK.finditer(page) for command in _commands(block)]


def run_page(page: str, folder: Path) -> list[tuple[Command, tuple[str, ...]]]:
    """Run a page's commands one after the other in a folder.

    Returns:
        Each command with the lines that it printed, on both streams.
    """
    printed, status = [], 0
    for command in commands_of(page):
        output, status = _run(command.text, folder, status)
        printed.append((command, tuple(line.rstrip() for line in output.splitlines())))
    return printed


def matches(expected: tuple[str, ...], printed: tuple[str, ...]) -> bool:
    """Tell whether lines were printed as the page shows them."""
    pattern = "".join(
        r"(?:.*\n)*" if line == ANYTHING else re.escape(line) + r"\n" for line in expected
    )
    return re.fullmatch(pattern, "".join(line + "\n" for line in printed)) is not None


def rewritten(page: str, printed: list[tuple[Command, tuple[str, ...]]]) -> str:
    """Return the page with what was printed in the place of what does not match it."""
    for command, lines in reversed(printed):
        if not matches(command.expected, lines):
            shown = "".join(line + "\n" for line in lines)
            page = page[: command.start] + shown + page[command.end :]
    return page


def _commands(block: re.Match[str]) -> list[Command]:
    found: list[Command] = []
    offset = block.start(1)
    for line in block[1].splitlines(keepends=True):
        offset += len(line)
        if line.startswith(PROMPT):
            found.append(Command(line.removeprefix(PROMPT).rstrip(), (), offset, offset))
        elif found:
            last = found.pop()
            expected = (*last.expected, line.rstrip())
            found.append(Command(last.text, expected, last.start, offset))
    return found


def _run(command: str, folder: Path, status: int) -> tuple[str, int]:
    """Run a command in a shell in which `$?` is the status of the one before."""
    search = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    plain = {"PATH": search, "NO_COLOR": "1", "COLUMNS": "100", "PYTHONUNBUFFERED": "1"}
    run = subprocess.run(
        ["sh", "-c", f"(exit {status}); {command}"], cwd=folder, env={**os.environ, **plain},
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        encoding="utf-8", timeout=_PATIENCE, check=False,
    )  # fmt: skip
    return run.stdout, run.returncode
