"""Steps written from a page, so that they can be undone and redone there."""

from typing import NamedTuple

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.language.text.edits import TextEdit, apply_edits, difference

Bindings = tuple[tuple[str, float], ...]
_CHANGED = Refusal("the document has changed since")


class Writing(NamedTuple):
    """The text to be written, as one step of undo.

    Attributes:
        label: Its title, in the imperative.
        text: The document that it was made for.
        edits: Of that text.
        bindings: Parameters to bind anew in the configuration file.
    """

    label: str
    text: str
    edits: tuple[TextEdit, ...]
    bindings: Bindings = ()


class _Step(NamedTuple):
    """The text before and after something was written."""

    label: str
    old: str
    new: str


class Steps:
    """The writings of one document, the newest last."""

    def __init__(self) -> None:
        self._steps: list[_Step] = []
        self._n_done = 0

    def undo(self, text: str) -> Writing | Refusal:
        """Return what takes the last step back, or why there is none."""
        if not self._n_done:
            return Refusal("there is nothing to undo")
        label, old, new = self._steps[self._n_done - 1]
        edit = difference(new, old)
        return Writing(f"Undo: {label}", text, (edit,)) if text == new else _CHANGED

    def redo(self, text: str) -> Writing | Refusal:
        """Return what makes the next step again, or why there is none."""
        if self._n_done == len(self._steps):
            return Refusal("there is nothing to redo")
        label, old, new = self._steps[self._n_done]
        return Writing(label, text, (difference(old, new),)) if text == old else _CHANGED

    def keep(self, gesture: str, writing: Writing) -> None:
        """Remember what was written; a new step forgets those that were undone."""
        if gesture not in ("undo", "redo"):
            new = apply_edits(writing.text, writing.edits)
            self._steps[self._n_done :] = [_Step(writing.label, writing.text, new)]
        self._n_done += -1 if gesture == "undo" else 1
