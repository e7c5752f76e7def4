"""What a hover is made of."""

from collections.abc import Iterable
from typing import NamedTuple


class Hover(NamedTuple):
    """A text in Markdown about a stretch of the document."""

    start: int
    end: int
    markdown: str


def paragraph(title: str, lines: Iterable[str]) -> str:
    """Return a title and a list below it."""
    items = "\n".join(f"- {line}" for line in lines if line)
    return f"{title}\n\n{items}" if items else title
