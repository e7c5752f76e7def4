"""What a hover tells of an optional frame: whose it is, and where."""

from collections.abc import Iterator

from kindsl.analysis.analysis import Analysis
from kindsl.features.hover_text import paragraph
from kindsl.features.unknown import Unknown
from kindsl.features.wording import pose_text
from kindsl.features.zero_configuration import frame_pose, own_pose
from kindsl.semantics.declarations import Frame


def frame_hover(analysis: Analysis, frame: Frame) -> str:
    """Return what there is to tell of a frame."""
    return paragraph(f"**frame `{frame.name}`** of `{frame.link}`", _lines(analysis, frame))


def _lines(analysis: Analysis, frame: Frame) -> Iterator[str]:
    own = own_pose(analysis, frame)
    if isinstance(own, Unknown):
        yield f"its pose is not known: {own.reason}"
        return
    yield f"in the link frame: {pose_text(own)}"
    pose = frame_pose(analysis, frame)
    if isinstance(pose, Unknown):
        yield f"its pose in the base is not known: {pose.reason}"
    else:
        yield f"zero configuration, in the base: {pose_text(pose)}"
