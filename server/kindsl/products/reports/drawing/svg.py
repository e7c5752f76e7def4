"""A drawing as SVG."""

from html import escape

from kindsl.products.reports.drawing.shapes import Disc, Drawing, Line, Polygon, Shape


def svg_text(drawing: Drawing) -> str:
    """Return an element that stands alone, or in a page."""
    size = f'width="{drawing.width:g}" height="{drawing.height:g}"'
    box = f'viewBox="0 0 {drawing.width:g} {drawing.height:g}"'
    shapes = "".join(f"{_shape(shape)}\n" for shape in drawing.shapes)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} {box}>\n'
        f'<rect width="100%" height="100%" fill="#ffffff"/>\n{shapes}</svg>\n'
    )


def _shape(shape: Shape) -> str:
    if isinstance(shape, Line):
        (x1, y1), (x2, y2) = shape.start, shape.end
        ends = f'x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}"'
        width = f'stroke-width="{shape.width:.2g}" stroke-linecap="round"'
        return f'<line {ends} stroke="#{shape.color}" {width}/>'
    if isinstance(shape, Polygon):
        corners = " ".join(f"{x:.1f},{y:.1f}" for x, y in shape.corners)
        edge = f'stroke="#{shape.edge}" stroke-width="{shape.width:.2g}" stroke-linejoin="round"'
        fill = f'fill="#{shape.color}"'
        if shape.opacity < 1.0:
            fill += f' fill-opacity="{shape.opacity:g}"'
        return f'<polygon points="{corners}" {fill} {edge}/>'
    if isinstance(shape, Disc):
        x, y = shape.center
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{shape.radius:.1f}" fill="#{shape.color}"/>'
    x, y = shape.place
    font = f'font-family="sans-serif" font-size="{shape.size:g}" fill="#{shape.color}"'
    halo = 'stroke="#ffffff" stroke-width="3" paint-order="stroke"'
    return f'<text x="{x:.1f}" y="{y:.1f}" {font} {halo}>{escape(shape.text)}</text>'
