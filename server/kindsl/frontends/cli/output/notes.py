"""Notes on a conversion: the file once, and one note for all that became of things alike."""

import re
from collections.abc import Iterable

from kindsl.language.text.groups import grouped
from kindsl.language.text.phrases import listed
from kindsl.language.text.printable import printable

_NAME = re.compile(r"'[^']*'")
_MOST_NAMES = 4


def rendered_notes(path: str, remarks: Iterable[str], *, is_verbose: bool) -> str:
    """Return notes about a file for a terminal, one for all that differ in their names only.

    Remarks are sentences with names in quotes, the thing that each is about first.
    """
    shown = list(remarks) if is_verbose else folded(remarks)
    notes = "".join(f"  note: {printable(remark)}\n" for remark in shown)
    return f"{path}:\n{notes}" if notes else ""


def folded(remarks: Iterable[str]) -> list[str]:
    """Return one remark for all that differ in their names only, with the names of the others."""
    kinds = grouped((_NAME.sub("''", remark), remark) for remark in remarks)
    return [_folded(alike) for alike in kinds.values()]


def _folded(alike: list[str]) -> str:
    first, *others = alike
    if not others:
        return first
    names = [_NAME.findall(remark)[0] for remark in others if _NAME.search(remark)]
    shown, left = names[:_MOST_NAMES], len(others) - len(names[:_MOST_NAMES])
    return f"{first}; likewise {listed([*shown, f'{left} more'] if left else shown)}"
