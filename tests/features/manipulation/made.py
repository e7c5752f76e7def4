"""A document after a gesture."""

from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.judgement.analysis.analysis import Analysis, analyse


def changed(text: str, gesture: Gesture | Refusal) -> Analysis:
    """Return what a gesture makes of a text; its edits are in order."""
    assert isinstance(gesture, Gesture), gesture
    starts = [edit.start for edit in gesture.edits]
    assert starts == sorted(starts)
    return analyse(text).edited(gesture.edits)
