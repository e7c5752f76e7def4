"""Steps written from a page, so that they can be undone and redone there."""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.language.text.edits import TextEdit, apply_edits

_CHANGED = "the document has changed since"


class Step(NamedTuple):
    """A text before and after something was written.

    Attributes:
        label: Its title, in the imperative.
        old: The text before.
        new: The text after.
    """

    label: str
    old: str
    new: str


class Steps:
    """The writings of one document, the newest last."""

    def __init__(self) -> None:
        self._done: list[Step] = []
        self._undone: list[Step] = []

    def add(self, label: str, text: str, edits: Sequence[TextEdit]) -> None:
        """Remember edits of a text; what was taken back before cannot be made again."""
        self._done.append(Step(label, text, apply_edits(text, edits)))
        self._undone.clear()

    def to_undo(self, text: str) -> Step | str:
        """Return the step that leads back from a text, or why there is none."""
        if not self._done:
            return "there is nothing to undo"
        last = self._done[-1]
        return Step(last.label, last.new, last.old) if last.new == text else _CHANGED

    def to_redo(self, text: str) -> Step | str:
        """Return the step that leads on from a text, or why there is none."""
        if not self._undone:
            return "there is nothing to redo"
        return self._undone[-1] if self._undone[-1].old == text else _CHANGED

    def undone(self) -> None:
        """Know that the last step was taken back."""
        self._undone.append(self._done.pop())

    def redone(self) -> None:
        """Know that the step that was taken back last was made again."""
        self._done.append(self._undone.pop())
