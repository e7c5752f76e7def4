"""All formats, found by walking this folder: a folder with a `FORMAT` is one."""

import pkgutil
from functools import cache
from importlib import import_module

from kindsl.robots import interchange
from kindsl.robots.interchange.format import Format


@cache
def all_formats() -> tuple[Format, ...]:
    """Return the formats by name, without loading what they need."""
    folders = (found.name for found in pkgutil.iter_modules(interchange.__path__) if found.ispkg)
    return tuple(
        import_module(f"kindsl.robots.interchange.{name}").FORMAT for name in sorted(folders)
    )


def format_named(name: str) -> Format | None:
    """Return the format of a name on the command line."""
    return next((format for format in all_formats() if format.name == name), None)


def format_of_suffix(suffix: str) -> Format | None:
    """Return the format of files with a suffix, its case ignored."""
    return next((format for format in all_formats() if suffix.lower() in format.suffixes), None)
