"""Which words may be names, and for what."""

import re

from kindsl.features.symbol_at import EntityKind
from kindsl.syntax.tables import KEYWORDS

_NAME = re.compile(r"[^\W\d]\w*")
_VALUES = frozenset((EntityKind.PARAMETER, EntityKind.CONSTANT))


def objection(word: str, kind: EntityKind, targets: frozenset[str]) -> str | None:
    """Return why a word cannot name such a thing, or None if it can.

    Args:
        word: The wanted name.
        kind: What it is to name.
        targets: The generators that must accept it.
    """
    if not _NAME.fullmatch(word):
        return f"'{word}' is no name: letters, digits and '_' make one, a digit does not begin it"
    if word.lower() == "pi":
        return f"'{word}' means the number pi"
    if word in KEYWORDS:
        return f"'{word}' is a keyword"
    if not word.isascii() and "robcogen" in targets:
        return f"'{word}' has letters that robcogen does not take in a name"
    if kind in _VALUES and word.lower().startswith("pi") and "robcogen2" in targets:
        return f"'{word}' begins with 'pi', where robcogen2 stops reading"
    return None
