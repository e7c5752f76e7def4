"""A document after a gesture."""

from kindsl.analysis.analysis import Analysis, analyse
from kindsl.features.manipulation.gesture import Gesture, Refusal


def changed(text: str, gesture: Gesture | Refusal) -> Analysis:
    """Return what a gesture makes of a text; its edits are in order."""
    assert isinstance(gesture, Gesture), gesture
    starts = [edit.start for edit in gesture.edits]
    assert starts == sorted(starts)
    return analyse(text).edited(gesture.edits)
