"""Rigid bodies as distributions of mass, in the form that takes the fewest operations.

The generated code describes a body by the moments of its mass distribution of order 2, 1 and 0
(the blocks of its pseudo-inertia) instead of by a 6x6 inertia. They move between frames by adding
and rotating, and parts of them can be carried by the predecessor without any effect on forces.
"""

from dataclasses import dataclass

from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import (
    ZERO,
    Matrix,
    Vector,
    add,
    add_matrices,
    cross,
    rotate_symmetric,
    scale,
    subtract,
    symmetric,
    transform,
)


@dataclass(frozen=True, slots=True)
class MassMoments:
    """Moments of a body's mass about its frame's origin.

    Attributes:
        second: `integral r r^T dm`, 3x3, symmetric, kg m^2.
        first: `integral r dm`, mass times centre of mass, kg m.
        mass: `integral dm`, kg.
    """

    second: Matrix
    first: Vector
    mass: Scalar

    def __add__(self, other: "MassMoments") -> "MassMoments":
        return MassMoments(
            add_matrices(self.second, other.second),
            add(self.first, other.first),
            self.mass + other.mass,
        )

    def rotated(self, R: Matrix) -> "MassMoments":
        """Return the moments in a frame with the same origin; `R` rotates coordinates to it."""
        return MassMoments(rotate_symmetric(R, self.second), transform(R, self.first), self.mass)

    def rotated_about_z(self, cosine: Scalar, sine: Scalar) -> "MassMoments":
        """Return the moments in a frame from which this one is turned about z."""
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = self.second
        x, y, z = self.first
        t = cosine * (xx - yy) - sine * (2.0 * xy)
        new_xy = xy + sine * t
        new_xz, new_yz = cosine * xz - sine * yz, sine * xz + cosine * yz
        second = [
            [yy + cosine * t, new_xy, new_xz],
            [new_xy, xx - cosine * t, new_yz],
            [new_xz, new_yz, zz],
        ]
        first = [cosine * x - sine * y, sine * x + cosine * y, z]
        return MassMoments(second, first, self.mass)

    def displaced(self, r: Vector) -> "MassMoments":
        """Return the moments about an origin from which this one's is displaced by `r`."""
        first = add(self.first, scale(self.mass, r))
        second = symmetric(
            lambda i, j: self.second[i][j] + (self.first[i] * r[j] + r[i] * first[j])
        )
        return MassMoments(second, first, self.mass)

    def inertia(self) -> Matrix:
        """Return the inertia tensor `tr(second) 1 - second`."""
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = self.second
        return [
            [yy + zz, 0.0 - xy, 0.0 - xz],
            [0.0 - xy, xx + zz, 0.0 - yz],
            [0.0 - xz, 0.0 - yz, xx + yy],
        ]

    def force(self, a: Vector, W: Matrix) -> Vector:
        """Return the force of a motion in which the point r accelerates by `a + W r`."""
        return add(scale(self.mass, a), transform(W, self.first))

    def moment(self, a: Vector, W: Matrix) -> Vector:
        """Return the moment `integral r x (a + W r) dm` about the origin."""
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = self.second
        turning = [
            W[2][0] * xy - W[1][0] * xz + W[2][1] * yy - W[1][2] * zz + (W[2][2] - W[1][1]) * yz,
            W[0][1] * yz - W[2][1] * xy + W[0][2] * zz - W[2][0] * xx + (W[0][0] - W[2][2]) * xz,
            W[1][2] * xz - W[0][2] * yz + W[1][0] * xx - W[0][1] * yy + (W[1][1] - W[0][0]) * xy,
        ]
        return add(turning, cross(self.first, a))


def acceleration_field(w: Vector, wd: Vector) -> Matrix:
    """Return `W = wd x + (w x)(w x)`: the point r of a turning body accelerates by `W r`."""
    xx, yy, zz = (component * component for component in w)
    xy, xz, yz = w[0] * w[1], w[0] * w[2], w[1] * w[2]
    return [
        [0.0 - (yy + zz), xy - wd[2], xz + wd[1]],
        [xy + wd[2], 0.0 - (xx + zz), yz - wd[0]],
        [xz - wd[1], yz + wd[0], 0.0 - (xx + yy)],
    ]


def carried_by_predecessor(kind: str, body: MassMoments) -> MassMoments:
    """Return the part of a body, in its joint frame, that could as well sit on the predecessor.

    It takes no force to move that part along the joint, and the joint does not change it: of a
    body that turns, mass on the axis; of one that slides, the second moment.

    Source: Gautier and Khalil 1990, the base inertial parameters.
    """
    if kind == "prismatic":
        return MassMoments(body.second, ZERO, 0.0)
    second = [ZERO, ZERO, [0.0, 0.0, body.second[2][2]]]
    return MassMoments(second, [0.0, 0.0, body.first[2]], body.mass)


def without(body: MassMoments, part: MassMoments) -> MassMoments:
    """Return a body less one of its parts."""
    second = [subtract(a, b) for a, b in zip(body.second, part.second, strict=True)]
    return MassMoments(second, subtract(body.first, part.first), body.mass - part.mass)
