"""All commands, found by walking `cli`: a module with a `SUMMARY` is one.

What the others are is read in their texts: to import them all takes longer than most commands run.
"""

from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType
from typing import Any

from kindsl.frontends import cli
from kindsl.language.text.modules import module_names


def command_summaries() -> dict[str, str]:
    """Return what each command does, by its name as it is typed."""
    from ast import literal_eval

    found = ((name, _constant(name, "SUMMARY")) for name in module_names(cli))
    return {name.replace("_", "-"): literal_eval(text) for name, text in found if text}


def command_module(command: str) -> ModuleType | None:
    """Import the module of a command, None if there is no such command."""
    name = _module_name(command)
    if _constant(name, "SUMMARY") is None:
        return None
    return import_module(f"kindsl.frontends.cli.{name}")


def runs_long(command: str) -> bool:
    """Return whether a command runs until it is stopped, and so has to tidy up when it ends."""
    return _constant(_module_name(command), "RUNS_LONG") == "True"


def _module_name(command: str) -> str:
    """Return the module of a command; a name with an underscore is none as it would be typed."""
    return command.replace("-", "_") if command.replace("-", "").isalnum() else ""


def _constant(module: str, name: str) -> str | None:
    """Return the text of a constant, which is on one line of a module; None without it."""
    spec = PathFinder.find_spec(f"kindsl.frontends.cli.{module}", cli.__path__) if module else None
    if spec is None or spec.origin is None:
        return None
    loader: Any = spec.loader
    _, is_there, rest = loader.get_data(spec.origin).decode().partition(f"\n{name} = ")
    return rest.partition("\n")[0] if is_there else None
