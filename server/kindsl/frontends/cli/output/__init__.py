"""Knows the formats that findings are reported in, one file each.

Must not know where the findings come from.
"""

from collections.abc import Callable
from importlib import import_module

from kindsl.frontends.cli.outcome import RunOutcome

FORMATS = ("text", "json", "sarif", "github", "gitlab", "junit")


def renderer(name: str) -> Callable[[RunOutcome], str]:
    """Return the function that writes an outcome in a format."""
    render: Callable[[RunOutcome], str] = import_module(f"{__name__}.{name}_format").render
    return render
