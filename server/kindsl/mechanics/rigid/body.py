"""Mass distribution of a rigid body in plain floats: moments, their bounds, what is possible.

A symmetric matrix is written as its six entries `xx yy zz xy xz yz`. Two matrices describe how mass
is spread:

- the inertia `I`, with the DSL's moments on the diagonal and its products negated beside it;
- the second moments `S`, the sums `m x x`, `m x y`, ...: `S = tr(I)/2 1 - I`, so that the products
  are its off-diagonal entries as written.

A body is possible if its mass is positive and `S` about the CoM is positive semidefinite. With the
eigenvalues `s1 <= s2 <= s3` of that `S` the principal moments are `s1+s2 <= s1+s3 <= s2+s3`, so
`s1 >= 0` says both that they are positive and that they obey the triangle inequality.

Source: Wensing, Kim, Slotine 2018, Linear matrix inequalities for physically consistent inertial
parameter identification; Traversaro et al. 2016.
"""

from collections.abc import Iterable, Sequence
from math import copysign, hypot, sqrt
from typing import NamedTuple

from kindsl.mechanics.rigid.pose import RigidPose, Vector3

Symmetric = tuple[float, float, float, float, float, float]

# How far arithmetic may move a moment of a body, of its greatest one.
ROUNDING_OF_MOMENTS = 1e-12

_SWEEPS = 30
_LOST = 1e-4  # of the largest second moment: a thickness that is told by rounding alone


class MassDistribution(NamedTuple):
    """A rigid body as the DSL gives it.

    Attributes:
        mass: kg.
        com: Centre of mass in some frame, m.
        moments: `Ix Iy Iz Ixy Ixz Iyz` about that frame's origin and axes, kg·m².
    """

    mass: float
    com: Vector3
    moments: Symmetric

    @classmethod
    def of(cls, numbers: Iterable[float]) -> "MassDistribution":
        """Return the body with these ten numbers: mass, centre of mass, moments."""
        mass, x, y, z, xx, yy, zz, xy, xz, yz = numbers
        return cls(mass, (x, y, z), (xx, yy, zz, xy, xz, yz))

    @property
    def numbers(self) -> tuple[float, ...]:
        """The ten numbers, one after the other."""
        return self.mass, *self.com, *self.moments


NO_BODY = MassDistribution(0.0, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0))


class Eigenpair(NamedTuple):
    """An eigenvalue and its unit eigenvector."""

    value: float
    axis: Vector3


# Ascending.
Eigenpairs = tuple[Eigenpair, Eigenpair, Eigenpair]


def second_moments_about_com(body: MassDistribution) -> Symmetric:
    """Return `S` about the CoM, axes as given."""
    m, (x, y, z), (ix, iy, iz, ixy, ixz, iyz) = body
    half = 0.5 * (ix + iy + iz)
    return (
        half - ix - m * x * x,
        half - iy - m * y * y,
        half - iz - m * z * z,
        ixy - m * x * y,
        ixz - m * x * z,
        iyz - m * y * z,
    )


def moments_of(second_moments: Symmetric) -> Symmetric:
    """Return the moments and products, as the DSL writes them, of second moments."""
    xx, yy, zz, xy, xz, yz = second_moments
    return (yy + zz, xx + zz, xx + yy, xy, xz, yz)


def shifted(body: MassDistribution, sign: float = 1.0) -> MassDistribution:
    """Return the body with `m (c.c 1 - c c')` added to its moments, or subtracted with sign -1.

    The sum is what the moments are about the frame's origin if they were given about the CoM.
    """
    m, (x, y, z), (ix, iy, iz, ixy, ixz, iyz) = body
    m *= sign
    return body._replace(
        moments=(
            ix + m * (y * y + z * z),
            iy + m * (x * x + z * z),
            iz + m * (x * x + y * y),
            ixy + m * x * y,
            ixz + m * x * z,
            iyz + m * y * z,
        )
    )


def moments_about_com(body: MassDistribution) -> Symmetric:
    """Return moments and products about the CoM, kg·m²; what arithmetic alone leaves is zero."""
    m, (x, y, z), moments = body
    least = ROUNDING_OF_MOMENTS * (abs(m) * (x * x + y * y + z * z) + max(map(abs, moments)))
    xx, yy, zz, xy, xz, yz = (
        moment if abs(moment) > least else 0.0 for moment in shifted(body, -1.0).moments
    )
    return xx, yy, zz, xy, xz, yz


def seen_from(body: MassDistribution, pose: RigidPose) -> MassDistribution:
    """Return a body in frame A, `pose` being the pose in A of the frame that it is given in."""
    Ix, Iy, Iz, Ixy, Ixz, Iyz = shifted(body, -1.0).moments
    xx, yy, zz, xy, xz, yz = _turned((Ix, Iy, Iz, -Ixy, -Ixz, -Iyz), pose)
    about_com = (xx, yy, zz, 0.0 - xy, 0.0 - xz, 0.0 - yz)
    return shifted(MassDistribution(body.mass, pose.point(body.com), about_com))


def lumped(parts: Sequence[MassDistribution]) -> MassDistribution:
    """Return bodies in one frame as one; masses may be negative, to take some away."""
    if len(parts) < 2:
        return parts[0] if parts else NO_BODY
    mass = sum(part.mass for part in parts)
    size = sum(abs(part.mass) for part in parts)
    x, y, z = (sum(part.mass * part.com[i] for part in parts) for i in range(3))
    com = (x / mass, y / mass, z / mass) if abs(mass) > 1e-14 * size else NO_BODY.com
    xx, yy, zz, xy, xz, yz = map(sum, zip(*(part.moments for part in parts), strict=True))
    return MassDistribution(mass, com, (xx, yy, zz, xy, xz, yz))


def less(body: MassDistribution, parts: Sequence[MassDistribution]) -> MassDistribution:
    """Return what is left of a body without parts of it."""
    if not parts:
        return body
    taken = (p._replace(mass=-p.mass, moments=tuple(-m for m in p.moments)) for p in parts)  # type: ignore[arg-type]
    return lumped((body, *taken))


def principal_moments(pairs: Eigenpairs) -> Vector3:
    """Return the ascending principal moments of the ascending eigenvalues of `S`."""
    a, b, c = (pair.value for pair in pairs)
    return a + b, a + c, b + c


def principal_moments_about_com(body: MassDistribution) -> Vector3:
    """Return the ascending principal moments about the centre of mass, kg·m²."""
    return principal_moments(eigensystem(second_moments_about_com(body)))


def nearest_possible(body: MassDistribution) -> MassDistribution:
    """Return the body whose second moments are the nearest ones that a body can have.

    Mass and centre of mass stay; of the second moments about it what is negative is left out.
    Source: the nearest positive semidefinite matrix in the Frobenius norm, Higham 1988.
    """
    pairs = eigensystem(second_moments_about_com(body))
    if pairs[0].value >= 0.0:
        return body
    kept = [(max(value, 0.0), axis) for value, axis in pairs]
    entries = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    xx, yy, zz, xy, xz, yz = (sum(s * a[i] * a[j] for s, a in kept) for i, j in entries)
    return shifted(body._replace(moments=moments_of((xx, yy, zz, xy, xz, yz))))


def is_clearly_positive(matrix: Symmetric) -> bool:
    """Return whether a matrix is positive definite far beyond the rounding of arithmetic.

    Source: Sylvester's criterion, with a margin: all leading minors, made equally large.
    """
    xx, yy, zz, xy, _, _ = matrix
    size = abs(xx + yy + zz)
    minors = xx * size * size, (xx * yy - xy * xy) * size, determinant(matrix)
    return min(minors) > 1e-12 * size * size * size


def determinant(matrix: Symmetric) -> float:
    """Return the determinant."""
    xx, yy, zz, xy, xz, yz = matrix
    return zz * (xx * yy - xy * xy) - xx * yz * yz - yy * xz * xz + 2.0 * xy * xz * yz


def eigensystem(matrix: Symmetric) -> Eigenpairs:
    """Return the eigenpairs of a symmetric matrix, ascending.

    Exact to rounding also for equal eigenvalues. Source: the cyclic Jacobi method, Golub and Van
    Loan 2013, sec. 8.5.
    """
    xx, yy, zz, xy, xz, yz = matrix
    diagonal, beside = [xx, yy, zz], [yz, xz, xy]
    axes = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
    scale = max(map(abs, matrix))
    for _ in range(_SWEEPS):
        if hypot(*beside) <= 1e-17 * scale:
            break
        for p, q, r in ((0, 1, 2), (0, 2, 1), (1, 2, 0)):
            if beside[r]:
                _rotate(diagonal, beside, axes, p, q, r)
    first, second, third = sorted(map(Eigenpair, diagonal, axes), key=lambda pair: pair.value)
    return first, second, third


def _rotate(
    diagonal: list[float], beside: list[float], axes: list[Vector3], p: int, q: int, r: int
) -> None:
    """Turn about axis r so that the entry of p and q, `beside[r]`, vanishes."""
    pq, rp, rq = beside[r], beside[q], beside[p]
    theta = (diagonal[q] - diagonal[p]) / (2.0 * pq)
    t = copysign(1.0, theta) / (abs(theta) + sqrt(theta * theta + 1.0))
    c = 1.0 / sqrt(t * t + 1.0)
    s = t * c
    diagonal[p] -= t * pq
    diagonal[q] += t * pq
    beside[r], beside[q], beside[p] = 0.0, c * rp - s * rq, s * rp + c * rq
    (px, py, pz), (qx, qy, qz) = axes[p], axes[q]
    axes[p] = c * px - s * qx, c * py - s * qy, c * pz - s * qz
    axes[q] = s * px + c * qx, s * py + c * qy, s * pz + c * qz


def greatest_second_moment(body: MassDistribution, half: MassDistribution, axis: Vector3) -> float:
    """Return an upper bound of `axis' S axis` about the CoM over all bodies within half-widths.

    If it is negative, no choice of the numbers within their rounding makes the body possible.

    Args:
        body: As written.
        half: How far each number may be from what is written.
        axis: A unit vector; the eigenvector of the smallest eigenvalue gives the sharpest bound.
    """
    x, y, z = axis
    weights = (0.5 - x * x, 0.5 - y * y, 0.5 - z * z, 2.0 * x * y, 2.0 * x * z, 2.0 * y * z)
    about_origin = _greatest_sum(weights, body.moments, half.moments)
    along = abs(x * body.com[0] + y * body.com[1] + z * body.com[2])
    reach = abs(x) * half.com[0] + abs(y) * half.com[1] + abs(z) * half.com[2]
    least = max(0.0, along - reach)
    return about_origin - max(0.0, body.mass - half.mass) * least * least


def greatest_moment(body: MassDistribution, half: MassDistribution, axis: Vector3) -> float:
    """Return an upper bound of the moment of inertia about an axis through the CoM.

    The arguments are those of `greatest_second_moment`, the axis that of the smallest moment.
    """
    x, y, z = axis
    weights = (x * x, y * y, z * z, -2.0 * x * y, -2.0 * x * z, -2.0 * y * z)
    about_origin = _greatest_sum(weights, body.moments, half.moments)
    along = x * body.com[0] + y * body.com[1] + z * body.com[2]
    across = [c - along * u for c, u in zip(body.com, axis, strict=True)]
    distance = hypot(*across)
    if distance == 0.0:
        return about_origin
    reach = sum(abs(a) * h for a, h in zip(across, half.com, strict=True)) / distance
    least = max(0.0, distance - reach)
    return about_origin - max(0.0, body.mass - half.mass) * least * least


def _greatest_sum(weights: Symmetric, values: Symmetric, halves: Symmetric) -> float:
    return sum(
        w * value + abs(w) * half for w, value, half in zip(weights, values, halves, strict=True)
    )


def equivalent_box(body: MassDistribution) -> tuple[Vector3, float] | None:
    """Return the sides of the uniform box with a body's mass and inertia, and its density.

    Of an impossible body, or one whose thickness is lost in rounding, there is none. The sides are
    in metres, ascending; the density is in kg/m³.
    """
    least, middle, most = (pair.value for pair in eigensystem(second_moments_about_com(body)))
    if body.mass <= 0.0 or least <= _LOST * most:
        return None
    a, b, c = (sqrt(12.0 * value / body.mass) for value in (least, middle, most))
    return (a, b, c), body.mass / (a * b * c)


def _turned(matrix: Symmetric, pose: RigidPose) -> Symmetric:
    """Return `R S R^T`."""
    xx, yy, zz, xy, xz, yz = matrix
    columns = (pose.turn((xx, xy, xz)), pose.turn((xy, yy, yz)), pose.turn((xz, yz, zz)))
    a, b, c = (pose.turn(row) for row in zip(*columns, strict=True))
    return a[0], b[1], c[2], a[1], a[2], b[2]
