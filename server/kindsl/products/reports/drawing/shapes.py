"""A drawing as flat shapes, the first ones behind; y points down, the unit is a pixel."""

from typing import NamedTuple

Spot = tuple[float, float]


class Line(NamedTuple):
    """A straight line with round ends; `width` in pixels, `color` as `rrggbb`."""

    start: Spot
    end: Spot
    width: float
    color: str


class Polygon(NamedTuple):
    """A filled convex polygon with an edge of its own colour, `width` in pixels."""

    corners: tuple[Spot, ...]
    color: str
    edge: str
    width: float
    opacity: float = 1.0


class Disc(NamedTuple):
    """A filled circle."""

    center: Spot
    radius: float
    color: str


class Label(NamedTuple):
    """A text that begins at its place, `size` pixels high."""

    place: Spot
    text: str
    size: float
    color: str


Shape = Line | Polygon | Disc | Label


class Drawing(NamedTuple):
    """Shapes on a white sheet of some size, pixels."""

    width: float
    height: float
    shapes: tuple[Shape, ...]
