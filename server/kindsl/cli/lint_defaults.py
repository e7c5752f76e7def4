"""The options of `kindsl lint` as they are when none is given."""

from types import SimpleNamespace
from typing import Any

DEFAULTS: dict[str, Any] = {
    "stdin_filename": None,
    "select": None,
    "ignore": None,
    "target": None,
    "param": (),
    "params": None,
    "config": None,
    "isolated": False,
    "fix": False,
    "unsafe_fixes": False,
    "diff": False,
    "output_format": "text",
    "max_warnings": None,
    "exit_zero": False,
    "statistics": False,
    "quiet": False,
    "watch": False,
    "jobs": 0,
    "explain": None,
    "list_rules": False,
}


def only_paths(arguments: list[str]) -> SimpleNamespace | None:
    """Return the options for arguments that are paths and nothing else, None for others.

    So the usual call needs no parser of arguments, which takes longer than reading a document.
    """
    if any(argument.startswith("-") and argument != "-" for argument in arguments):
        return None
    return SimpleNamespace(paths=arguments, **DEFAULTS)
