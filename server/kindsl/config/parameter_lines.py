"""Values of parameters as the lines of a `kindsl.toml`."""

import re
from collections.abc import Iterable, Mapping

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def parameter_lines(values: Iterable[tuple[str, float]]) -> list[str]:
    """Return a line for each parameter, for below `[parameters]`."""
    return [f"{key(name)} = {value!r}" for name, value in values]


def parameter_table(values: Mapping[str, float]) -> str:
    """Return the whole table, to be copied by hand."""
    return "\n".join(("[parameters]", *parameter_lines(values.items()), ""))


def key(name: str) -> str:
    """Return a name as a key of TOML."""
    return name if _BARE.fullmatch(name) else f'"{name}"'
