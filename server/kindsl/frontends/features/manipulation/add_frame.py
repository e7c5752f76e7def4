"""Fix a new frame to a link where somebody points."""

from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.frontends.features.manipulation.new_blocks import fresh_name, with_frame
from kindsl.frontends.features.manipulation.written_value import written_number
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.mechanics.rigid.pose import Vector3


def add_frame(analysis: Analysis, link: str, point: Vector3) -> Gesture | Refusal:
    """Return the edit that adds a frame to a link.

    Args:
        analysis: The document.
        link: The name of a link or of the base.
        point: The frame's origin in the link's frame, metres, as it is to be written.
    """
    body = analysis.model.body_named.get(link)
    if body is None:
        return Refusal(f"there is no link '{link}'")
    name = fresh_name(analysis.model, "frame")
    edit = with_frame(analysis, body, frame_lines(name, point))
    if edit is None:
        return Refusal(f"link '{link}' is not whole")
    return Gesture(f"Add frame '{name}' to '{link}'", (edit,), (name,))


def frame_lines(name: str, point: Vector3) -> list[str]:
    """Return the lines of a frame that is not turned."""
    return [f"{name} {{", *(f"    {line}" for line in pose_lines(point)), "}"]


def pose_lines(point: Vector3) -> list[str]:
    """Return the lines of a pose that is not turned."""
    x, y, z = (written_number(value, "").text for value in point)
    return [f"translation = ({x}, {y}, {z})", "rotation = (0.0, 0.0, 0.0)"]
