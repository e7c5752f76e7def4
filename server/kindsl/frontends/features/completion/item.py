"""The parts of a completion."""

import re
from typing import NamedTuple

_PLACEHOLDER = re.compile(r"\$\{\d+:([^}]*)\}|\$\d+")
_BLANKS = re.compile(r"\s+")


class CompletionItem(NamedTuple):
    """Something that may be typed.

    Attributes:
        kind: `keyword`, `snippet`, `link`, `joint`, `frame`, `parameter`, `constant` or `value`.
        text: The text to insert; with placeholders `${1:name}` and `$0` if it is a snippet.
        detail: A few words beside the label.
        is_asked_for: Whether it is shown only to whom asks for the list, not by itself.
    """

    label: str
    kind: str
    text: str
    detail: str = ""
    is_asked_for: bool = False

    @property
    def is_snippet(self) -> bool:
        """True if the text has placeholders."""
        return "$" in self.text

    @property
    def plain_text(self) -> str:
        """The text for an editor that knows no placeholders, on one line.

        Some of these editors take a text of several lines for one and write NUL for each line end.
        """
        return _BLANKS.sub(" ", without_placeholders(self.text))


def without_placeholders(text: str) -> str:
    """Return a snippet as plain text, its defaults filled in."""
    return _PLACEHOLDER.sub(lambda match: match[1] or "", text)
