"""Unified diffs of documents."""

import difflib

from kindsl.language.text.printable import printable


def unified_diff(path: str, old: str, new: str) -> str:
    """Return the difference of two texts; empty if there is none."""
    shown = printable(path)
    lines = difflib.unified_diff(_lines(old), _lines(new), shown, shown, lineterm="\n")
    return "".join(
        line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines
    )


def _lines(text: str) -> list[str]:
    pieces = text.split("\n")
    return [piece + "\n" for piece in pieces[:-1]] + ([pieces[-1]] if pieces[-1] else [])
