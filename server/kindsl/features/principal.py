"""Principal moments of an inertia tensor on plain floats."""

from math import acos, cos, pi, sqrt

from kindsl.features.rigid_inertia import Tensor
from kindsl.features.rigid_pose import Triple


def principal_moments(tensor: Tensor) -> Triple:
    """Return the eigenvalues of a symmetric 3x3 tensor in ascending order, same unit.

    Source: Smith 1961, "Eigenvalues of a symmetric 3 x 3 matrix".
    """
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = tensor
    off = xy * xy + xz * xz + yz * yz
    if off == 0.0:
        low, mid, high = sorted((xx, yy, zz))
        return low, mid, high
    mean = (xx + yy + zz) / 3.0
    a, b, c = xx - mean, yy - mean, zz - mean
    scale = sqrt((a * a + b * b + c * c + 2.0 * off) / 6.0)
    determinant = a * (b * c - yz * yz) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz)
    angle = acos(min(max(0.5 * determinant / scale**3, -1.0), 1.0)) / 3.0
    high = mean + 2.0 * scale * cos(angle)
    low = mean + 2.0 * scale * cos(angle + 2.0 * pi / 3.0)
    return low, 3.0 * mean - high - low, high
