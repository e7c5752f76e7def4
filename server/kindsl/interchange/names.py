"""Names that both generators take."""

import re
from collections.abc import Iterable

from kindsl.syntax.tables import KEYWORDS

_OUTSIDE = re.compile(r"[^A-Za-z0-9_]+")


def valid_names(things: Iterable[tuple[str, str]]) -> dict[tuple[str, str], str]:
    """Return a valid, unique name for each (kind, name), as like the given one as possible."""
    taken: set[str] = set()
    names: dict[tuple[str, str], str] = {}
    for kind, original in things:
        names[kind, original] = _free(valid_name(original), kind, taken)
        taken.add(names[kind, original].lower())
    return names


def valid_name(name: str) -> str:
    """Return a name that is an identifier and no keyword."""
    plain = _OUTSIDE.sub("_", name).strip("_") or "unnamed"
    if plain[0].isdigit():
        plain = f"_{plain}"
    return f"{plain}_" if plain in KEYWORDS else plain


def _free(name: str, kind: str, taken: set[str]) -> str:
    number = 2
    free = name if name.lower() not in taken else f"{name}_{kind}"
    while free.lower() in taken:
        free = f"{name}_{number}"
        number += 1
    return free
