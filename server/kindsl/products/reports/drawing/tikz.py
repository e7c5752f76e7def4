"""A drawing in TikZ, for LaTeX: 100 pixels are 2 cm."""

from kindsl.products.reports.drawing.shapes import Disc, Drawing, Line, Polygon, Shape, Spot

_CM = 0.02


def tikz_text(drawing: Drawing) -> str:
    """Return a `tikzpicture`."""
    used = {shape.color for shape in drawing.shapes}
    colors = sorted(used | {s.edge for s in drawing.shapes if isinstance(s, Polygon)})
    defined = (f"\\definecolor{{k{color}}}{{HTML}}{{{color.upper()}}}" for color in colors)
    shapes = (_shape(shape) for shape in drawing.shapes)
    lines = ["\\begin{tikzpicture}[line cap=round]", *defined, *shapes, "\\end{tikzpicture}"]
    return "\n".join(lines)


def _shape(shape: Shape) -> str:
    if isinstance(shape, Line):
        width = f"line width={shape.width * _CM:.3f}cm"
        return f"\\draw[k{shape.color}, {width}] {_at(shape.start)} -- {_at(shape.end)};"
    if isinstance(shape, Polygon):
        look = f"draw=k{shape.edge}, line width={shape.width * _CM:.3f}cm, line join=round"
        if shape.opacity < 1.0:
            look += f", fill opacity={shape.opacity:g}"
        corners = " -- ".join(map(_at, shape.corners))
        return f"\\filldraw[fill=k{shape.color}, {look}] {corners} -- cycle;"
    if isinstance(shape, Disc):
        return f"\\fill[k{shape.color}] {_at(shape.center)} circle ({shape.radius * _CM:.3f});"
    text = shape.text.replace("_", "\\_")
    style = f"k{shape.color}, anchor=base west, inner sep=0, font=\\scriptsize"
    return f"\\node[{style}] at {_at(shape.place)} {{{text}}};"


def _at(spot: Spot) -> str:
    x, y = spot
    return f"({x * _CM:.3f},{-y * _CM:.3f})"
