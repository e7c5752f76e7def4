"""The text that a gesture adds or rewrites as a whole, previewed before it is accepted."""

from typing import NamedTuple

from kindsl.language.text.edits import TextEdit


class Gesture(NamedTuple):
    """A change of the document.

    Attributes:
        title: Its title, in the imperative.
        edits: Disjoint, in the order of the text.
        names: The links, joints and frames that are new, in the order of the text.
    """

    title: str
    edits: tuple[TextEdit, ...]
    names: tuple[str, ...] = ()


class Refusal(NamedTuple):
    """The reason why nothing changes: one sentence without final period."""

    reason: str
