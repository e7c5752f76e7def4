"""Poses on plain floats, without NumPy."""

from math import atan2, cos, hypot, pi, sin
from typing import NamedTuple

# For people: nearer to a quarter turn, one sum is plainer than two angles.
PLAIN = 1e-9
# For programs: no more than rounding, so that a quarter turn is one.
_ROUNDING = 1e-15
# As far as eleven decimals leave an angle open, rounded or cut off.
_CUT_OFF = 1e-11
_ROUND = pi / 12.0

Vector3 = tuple[float, float, float]
Rotation = tuple[Vector3, Vector3, Vector3]

ORIGIN: Vector3 = (0.0, 0.0, 0.0)
Z_AXIS: Vector3 = (0.0, 0.0, 1.0)


class RigidPose(NamedTuple):
    """The pose of a frame B in a frame A.

    Attributes:
        rotation: `A_R_B`, rows; takes coordinates of B to those of A.
        translation: B's origin in A, metres.
    """

    rotation: Rotation
    translation: Vector3

    @property
    def numbers(self) -> tuple[float, ...]:
        """All twelve: the translation, then the rotation by rows."""
        return (*self.translation, *(number for row in self.rotation for number in row))

    def then(self, other: "RigidPose") -> "RigidPose":
        """Return the pose of C in A, `other` being the pose of C in B."""
        return RigidPose(product(self.rotation, other.rotation), self.point(other.translation))

    def point(self, position: Vector3) -> Vector3:
        """Return a position given in B, in A."""
        turned = self.turn(position)
        x, y, z = self.translation
        return turned[0] + x, turned[1] + y, turned[2] + z

    def turn(self, direction: Vector3) -> Vector3:
        """Return a direction given in B, in A."""
        return turned(self.rotation, direction)

    def inverse(self) -> "RigidPose":
        """Return where A is in B."""
        x, y, z = rotation = transposed(self.rotation)
        r = self.translation
        return RigidPose(rotation, (-dot(x, r), -dot(y, r), -dot(z, r)))


IDENTITY = RigidPose(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), Z_AXIS), ORIGIN)


def pose_from(translation: Vector3, angles: Vector3) -> RigidPose:
    """Return the pose after a translation, then turns about x, the new y, the new z.

    Args:
        translation: Metres.
        angles: Radians.
    """
    (cx, cy, cz), (sx, sy, sz) = map(cos, angles), map(sin, angles)
    rotation = (
        (cy * cz, -cy * sz, sy),
        (cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy),
        (sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy),
    )
    return RigidPose(rotation, translation)


def rotation_from_quaternion(x: float, y: float, z: float, w: float) -> Rotation | None:
    """Return the rotation of a quaternion of any length, w being its scalar; None without one."""
    length = hypot(x, y, z, w)
    if not length > 0.0:
        return None
    x, y, z, w = x / length, y / length, z / length, w / length
    return (
        (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)),
        (2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)),
        (2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)),
    )


def rotation_from_z(axis: Vector3) -> Rotation:
    """Return a rotation that takes z to an axis; none if it is z already.

    It is the smallest one on z's side; on the other, one after a half turn about x, since the
    smallest is not defined near -z.
    """
    side = -1.0 if axis[2] < 0.0 else 1.0
    length = hypot(*axis)
    x, y, z = axis[0] / length, side * axis[1] / length, side * axis[2] / length
    k = 1.0 / (1.0 + z)
    return (
        (1.0 - k * x * x, -k * x * y, x),
        (side * (-k * x * y), side * (1.0 - k * y * y), side * y),
        (side * -x, side * -y, side * z),
    )


def pose_from_fixed_axes(translation: Vector3, angles: Vector3) -> RigidPose:
    """Return the pose after turns about the fixed x, y, z (roll, pitch, yaw), then a translation.

    They are the turns about own axes the other way round, backwards.

    Args:
        translation: Metres.
        angles: Radians.
    """
    x, y, z = angles
    back = pose_from(translation, (-x, -y, -z))
    return RigidPose(transposed(back.rotation), translation)


def angles(rotation: Rotation, within: float) -> Vector3:
    """Return the turns about x, the new y, the new z that make a rotation, radians.

    Where y is a quarter turn, x and z turn about one axis and only their sum counts. The turn about
    x is ill-defined nearby, so the other two are read off what it leaves: together they make the
    rotation to the last digit all the same.

    Args:
        rotation: `A_R_B`, rows.
        within: How near to a quarter turn z is taken for zero and x for the sum, radians; then
            the rotation is met to that much.
    """
    (r00, r01, r02), (r10, r11, r12), (r20, r21, r22) = rotation
    cos_y = hypot(r00, r01)
    if cos_y <= within:
        return atan2(r21, r11), atan2(r02, cos_y), 0.0
    x = atan2(-r12, r22)
    c, s = cos(x), sin(x)
    return x, atan2(r02, c * r22 - s * r12), atan2(c * r10 + s * r20, c * r11 + s * r21)


def fixed_axis_angles(rotation: Rotation) -> Vector3:
    """Return the turns about the fixed x, y, z (roll, pitch, yaw) that make a rotation, radians."""
    x, y, z = angles(transposed(rotation), _ROUNDING)
    return 0.0 - x, 0.0 - y, 0.0 - z


def angle_between(one: RigidPose, other: RigidPose) -> float:
    """Return the angle of the rotation between two poses, exact near zero too; radians."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = product(transposed(one.rotation), other.rotation)
    return atan2(hypot(zy - yz, xz - zx, yx - xy), xx + yy + zz - 1.0)


def round_angle(value: float) -> float:
    """Return the nearest whole fraction of a turn, a multiple of 15 degrees; radians."""
    return round(value / _ROUND) * _ROUND + 0.0


def meant_angle(value: float) -> float:
    """Return the fraction of a turn that is written with eleven digits or more, else the angle."""
    fraction = round_angle(value)
    return fraction if abs(value - fraction) <= _CUT_OFF else value


def transposed(rotation: Rotation) -> Rotation:
    """Return the rotation the other way round."""
    a, b, c = rotation
    return (a[0], b[0], c[0]), (a[1], b[1], c[1]), (a[2], b[2], c[2])


def product(first: Rotation, second: Rotation) -> Rotation:
    """Return the matrix product, `A_R_C` of `A_R_B` and `B_R_C`."""
    (a, b, c), (d, e, f), (g, h, i) = second
    above, middle, below = [
        (x * a + y * d + z * g, x * b + y * e + z * h, x * c + y * f + z * i) for x, y, z in first
    ]
    return above, middle, below


def turned(rotation: Rotation, vector: Vector3) -> Vector3:
    """Return a vector given in B, in A, for `A_R_B`."""
    (a, b, c), (d, e, f), (g, h, i) = rotation
    x, y, z = vector
    return a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z


def dot(a: Vector3, b: Vector3) -> float:
    """Return the scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def minus(a: Vector3, b: Vector3) -> Vector3:
    """Return the difference."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def scaled(vector: Vector3, factor: float) -> Vector3:
    """Return a multiple of a vector."""
    x, y, z = vector
    return factor * x, factor * y, factor * z


def cross(a: Vector3, b: Vector3) -> Vector3:
    """Return the vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def nearest_on_way(point: Vector3, end: Vector3) -> Vector3:
    """Return the place between the origin and an end that is nearest to a point."""
    share = min(max(dot(point, end) / dot(end, end), 0.0), 1.0) if any(end) else 0.0
    return share * end[0], share * end[1], share * end[2]
