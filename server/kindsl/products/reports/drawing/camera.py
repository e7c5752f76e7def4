"""Looking at a robot from a fixed direction, without perspective, so that lengths compare."""

from collections.abc import Sequence
from math import cos, radians, sin
from typing import NamedTuple

from kindsl.mechanics.rigid.pose import Vector3, dot
from kindsl.products.reports.drawing.shapes import Spot

WIDTH, HEIGHT = 640.0, 480.0
_MARGIN = 56.0
_AZIMUTH, _ELEVATION = radians(-50.0), radians(22.0)
_NEGLIGIBLE = 1e-9

# Directions in the base's frame: to the right of the sheet, up on it, out of it.
_RIGHT = (-sin(_AZIMUTH), cos(_AZIMUTH), 0.0)
_OUT = (cos(_ELEVATION) * cos(_AZIMUTH), cos(_ELEVATION) * sin(_AZIMUTH), sin(_ELEVATION))
_UP = (-sin(_ELEVATION) * cos(_AZIMUTH), -sin(_ELEVATION) * sin(_AZIMUTH), cos(_ELEVATION))


class Camera(NamedTuple):
    """The projection of points onto the paper.

    Attributes:
        scale: Pixels a metre.
        middle: The point in the middle of the sheet, metres to the right and up.
    """

    scale: float
    middle: tuple[float, float]

    def spot(self, point: Vector3) -> Spot:
        """Return where a point of the base's frame is on the sheet."""
        x, y = _flat(point)
        right, up = self.middle
        return WIDTH / 2 + self.scale * (x - right), HEIGHT / 2 - self.scale * (y - up)


def across(angle: float) -> Vector3:
    """Return a unit vector in the sheet, in the base's frame: angle 0 is right, a quarter up."""
    c, s = cos(angle), sin(angle)
    x, y, z = (c * right + s * up for right, up in zip(_RIGHT, _UP, strict=True))
    return x, y, z


def depth(point: Vector3) -> float:
    """Return how far out of the sheet a point is, metres."""
    return dot(_OUT, point)


def camera_for(points: Sequence[Vector3]) -> Camera:
    """Return the camera that sees some points of the base's frame as large as they fit."""
    flat = [_flat(point) for point in points] or [(0.0, 0.0)]
    (left, right), (low, high) = ((min(axis), max(axis)) for axis in zip(*flat, strict=True))
    scales = [
        (sheet - 2 * _MARGIN) / size
        for sheet, size in ((WIDTH, right - left), (HEIGHT, high - low))
        if size > _NEGLIGIBLE
    ]
    of_one_metre = WIDTH - 2 * _MARGIN
    return Camera(min(scales, default=of_one_metre), ((left + right) / 2, (low + high) / 2))


def _flat(point: Vector3) -> tuple[float, float]:
    return dot(_RIGHT, point), dot(_UP, point)
