"""A drawing as PNG; needs Pillow."""

from io import BytesIO

from PIL import Image, ImageDraw, ImageFont

from kindsl.products.reports.drawing.shapes import Disc, Drawing, Line, Polygon, Shape

# Drawn larger and made smaller, since Pillow's edges are hard.
_FINER = 3
_WHITE = "#ffffff"


def png_bytes(drawing: Drawing) -> bytes:
    """Return the content of a file."""
    width, height = round(drawing.width), round(drawing.height)
    sheet = Image.new("RGB", (width * _FINER, height * _FINER), _WHITE)
    pen = ImageDraw.Draw(sheet, "RGBA")
    for shape in drawing.shapes:
        _draw(pen, shape)
    file = BytesIO()
    sheet.reduce(_FINER).save(file, "PNG")
    return file.getvalue()


def _draw(pen: ImageDraw.ImageDraw, shape: Shape) -> None:
    color = f"#{shape.color}"
    if isinstance(shape, Line):
        ends = [(x * _FINER, y * _FINER) for x, y in (shape.start, shape.end)]
        pen.line(ends, color, round(shape.width * _FINER))
        for x, y in ends:
            pen.circle((x, y), shape.width * _FINER / 2, color)
    elif isinstance(shape, Polygon):
        corners = [(x * _FINER, y * _FINER) for x, y in shape.corners]
        pen.polygon(corners, f"{color}{round(255 * shape.opacity):02x}")
        pen.line([*corners, corners[0]], f"#{shape.edge}", round(shape.width * _FINER), "curve")
    elif isinstance(shape, Disc):
        x, y = shape.center
        pen.circle((x * _FINER, y * _FINER), shape.radius * _FINER, color)
    else:
        x, y = shape.place
        font = ImageFont.load_default(shape.size * _FINER)
        at = (x * _FINER, y * _FINER)
        pen.text(at, shape.text, color, font, "ls", stroke_width=_FINER, stroke_fill=_WHITE)
