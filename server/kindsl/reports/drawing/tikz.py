"""A drawing in TikZ, for LaTeX: 100 pixels are 2 cm."""

from kindsl.reports.drawing.shapes import Disc, Drawing, Line, Shape, Spot

_CM = 0.02


def tikz_text(drawing: Drawing) -> str:
    """Return a `tikzpicture`."""
    colors = sorted({shape.color for shape in drawing.shapes})
    defined = (f"\\definecolor{{k{color}}}{{HTML}}{{{color.upper()}}}" for color in colors)
    shapes = (_shape(shape) for shape in drawing.shapes)
    lines = ["\\begin{tikzpicture}[line cap=round]", *defined, *shapes, "\\end{tikzpicture}"]
    return "\n".join(lines)


def _shape(shape: Shape) -> str:
    if isinstance(shape, Line):
        width = f"line width={shape.width * _CM:.3f}cm"
        return f"\\draw[k{shape.color}, {width}] {_at(shape.start)} -- {_at(shape.end)};"
    if isinstance(shape, Disc):
        return f"\\fill[k{shape.color}] {_at(shape.center)} circle ({shape.radius * _CM:.3f});"
    text = shape.text.replace("_", "\\_")
    style = f"k{shape.color}, anchor=base west, inner sep=0, font=\\scriptsize"
    return f"\\node[{style}] at {_at(shape.place)} {{{text}}};"


def _at(spot: Spot) -> str:
    x, y = spot
    return f"({x * _CM:.3f},{-y * _CM:.3f})"
