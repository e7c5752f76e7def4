"""What a completion is made of."""

import re
from typing import NamedTuple

_PLACEHOLDER = re.compile(r"\$\{\d+:([^}]*)\}|\$\d+")


class CompletionItem(NamedTuple):
    """Something that may be typed.

    Attributes:
        label: What the list shows.
        kind: `keyword`, `snippet`, `link`, `joint`, `frame`, `parameter`, `constant` or `value`.
        text: What is inserted; with placeholders `${1:name}` and `$0` if it is a snippet.
        detail: A few words beside the label.
        rank: The smaller, the higher in the list.
        is_snippet: Whether the text has placeholders.
    """

    label: str
    kind: str
    text: str
    detail: str = ""
    rank: int = 5
    is_snippet: bool = False

    @property
    def plain_text(self) -> str:
        """The text for an editor that knows no placeholders."""
        return without_placeholders(self.text) if self.is_snippet else self.text


def without_placeholders(text: str) -> str:
    """Return a snippet as plain text, its defaults filled in."""
    return _PLACEHOLDER.sub(lambda match: match[1] or "", text)
