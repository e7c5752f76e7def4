"""Names that both generators take."""

import re
from collections.abc import Iterable

from kindsl.language.semantics.reserved_words import RESERVED_BY
from kindsl.language.syntax.tables import KEYWORDS

_OUTSIDE = re.compile(r"[^A-Za-z0-9_]+")


def valid_names(things: Iterable[tuple[str, str]]) -> list[str]:
    """Return a valid name for each (kind, name), as like the given one as possible.

    None is another's, in upper or lower case, and no frame has the name `fr_<link>`, which the
    generators give to the frame of a link. Who comes first keeps its name.
    """
    taken: set[str] = set()
    of_link_frames: set[str] = set()
    names = []
    for kind, original in things:
        others = (taken, of_link_frames) if kind == "frame" else (taken,)
        name = _free(valid_name(original), kind, others)
        taken.add(name.lower())
        if kind == "link":
            of_link_frames.add(f"fr_{name}".lower())
        names.append(name)
    return names


def valid_name(name: str) -> str:
    """Return a name that is an identifier and no keyword, neither here nor in generated code."""
    plain = _OUTSIDE.sub("_", name).strip("_") or "unnamed"
    if plain[0].isdigit():
        plain = f"_{plain}"
    return f"{plain}_" if plain in KEYWORDS or plain in RESERVED_BY else plain


def _free(name: str, kind: str, others: tuple[set[str], ...]) -> str:
    number = 2
    free = f"{name}_{kind}" if _is_in(name, others) else name
    while _is_in(free, others):
        free = f"{name}_{number}"
        number += 1
    return free


def _is_in(name: str, others: tuple[set[str], ...]) -> bool:
    return any(name.lower() in names for names in others)
