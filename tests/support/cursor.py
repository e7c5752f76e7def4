"""Texts with a cursor: `$0` marks the offset."""

from kindsl.rules.analysis import Analysis, analyse
from kindsl.rules.settings import Settings


def split_cursor(marked: str) -> tuple[str, int]:
    """Return the text without its `$0`, and where that stood."""
    before, mark, after = marked.partition("$0")
    assert mark, "the fixture has no $0"
    return before + after, len(before)


def at_cursor(marked: str, settings: Settings | None = None) -> tuple[Analysis, int]:
    """Return the analysis of a marked text and the cursor's offset."""
    text, offset = split_cursor(marked)
    return analyse(text, settings or Settings()), offset
