"""Show a .kindsl, .urdf or .sdf robot as a picture: bodies, joints, axes, frames, centres of mass.

Look at it after each change of a document: a wrong frame or axis is seen at once. A broken document
is drawn as far as it can be read, with a sentence on what is missing.
"""

from base64 import b64encode
from typing import Literal

from mcp.types import ImageContent

from kindsl.frontends.mcp.documents import BoundArguments, document
from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.tool import Content, Field, text
from kindsl.judgement.analysis.body_doubts import body_doubts
from kindsl.products.reports.drawing.robot import robot_drawing
from kindsl.products.reports.drawing.shapes import Drawing
from kindsl.products.reports.drawing.svg import svg_text
from kindsl.products.reports.motions import ConfigurationSpace, MotionError, motions_from
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.scene.picture import picture


class ViewArguments(BoundArguments):
    """A document and how to see it."""

    q: list[float] | dict[str, float] | None = Field(
        None, description="Joint positions, radians and metres: a list by id, or by names"
    )
    preset: Literal["bodies", "kinematics", "inertia", "frames", "all"] = Field(
        "bodies", description="What to show"
    )
    format: Literal["png", "svg"] = Field("png", description="The kind of picture")


def run(arguments: ViewArguments, folder: Folder) -> list[Content]:
    """Return the picture."""
    _, analysis = document(arguments, folder)
    shown = picture(analysis.model, analysis.context.values, None)
    if shown.skeleton is None:
        raise ToolError(shown.message or "there is nothing to draw")
    moved, doubts = _moved(shown.skeleton, arguments.q), body_doubts(analysis, analysis.findings)
    drawing = robot_drawing(moved, preset=arguments.preset, doubts=doubts)
    notes = [text(shown.message)] if shown.message else []
    return [_content(drawing, arguments.format), *notes]


def _moved(skeleton: Linkage, q: list[float] | dict[str, float] | None) -> Linkage:
    space = ConfigurationSpace(skeleton.joint_names, skeleton.is_floating)
    try:
        return skeleton.moved_to(motions_from({"q": q}, space)[0].q)
    except MotionError as error:
        raise ToolError(str(error)) from None


def _content(drawing: Drawing, kind: str) -> Content:
    if kind == "svg":
        return text(svg_text(drawing))
    try:
        from kindsl.products.reports.drawing.png import png_bytes
    except ModuleNotFoundError:
        raise ToolError("PNG needs Pillow: pip install 'kindsl[mcp]'; or ask for 'svg'") from None
    data = b64encode(png_bytes(drawing)).decode("ascii")
    return ImageContent(type="image", data=data, mime_type="image/png")
