"""A body's inertia on plain floats: evaluated, and moved to other frames."""

from collections.abc import Mapping
from typing import NamedTuple

from kindsl.features.rigid_pose import RigidPose, Rotation, Triple, transposed, triple, written_pose
from kindsl.features.unknown import Unknown, pose_expressions, why_unknown
from kindsl.semantics.declarations import MOMENTS, Inertia, Link, inertia_values

Tensor = Rotation


class RigidInertia(NamedTuple):
    """Mass, centre of mass and inertia tensor in one frame.

    Attributes:
        mass: Kilograms.
        com: Centre of mass, metres.
        tensor: About the frame's origin and axes, rows, kg·m²; products with their minus signs.
    """

    mass: float
    com: Triple
    tensor: Tensor

    @property
    def moments(self) -> dict[str, float]:
        """The six numbers of the language by name, products with the language's signs."""
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = self.tensor
        return dict(zip(MOMENTS, (xx, yy, zz, -xy, -xz, -yz), strict=True))

    @property
    def about_com(self) -> Tensor:
        """The tensor about the centre of mass, same axes."""
        return _added(self.tensor, point_tensor(-self.mass, self.com))

    def seen_from(self, pose: RigidPose) -> "RigidInertia":
        """Return the same body in frame A, `pose` being this frame's pose in A."""
        columns = transposed(self.about_com)
        half = [pose.turn(column) for column in columns]
        turned = [pose.turn(row) for row in transposed((half[0], half[1], half[2]))]
        com = pose.point(self.com)
        tensor = _added((turned[0], turned[1], turned[2]), point_tensor(self.mass, com))
        return RigidInertia(self.mass, com, tensor)


def point_tensor(mass: float, position: Triple) -> Tensor:
    """Return the inertia tensor about the origin of a point mass, kg·m²."""
    x, y, z = position
    xx, yy, zz = x * x, y * y, z * z
    return (
        (mass * (yy + zz), -mass * x * y, -mass * x * z),
        (-mass * x * y, mass * (xx + zz), -mass * y * z),
        (-mass * x * z, -mass * y * z, mass * (xx + yy)),
    )


def written_inertia(inertia: Inertia, values: Mapping[str, float]) -> RigidInertia | Unknown:
    """Return an inertia in the frame that it is written in, or why it is not known."""
    mass = inertia.mass.value(values) if inertia.mass is not None else None
    com = triple(inertia.com, values)
    moments = [inertia.moments[m].value(values) for m in MOMENTS if m in inertia.moments]
    known = [value for value in moments if value is not None]
    if mass is None or com is None or len(known) != len(MOMENTS):
        return why_unknown(inertia_values(inertia), values)
    xx, yy, zz, xy, xz, yz = known
    return RigidInertia(mass, com, ((xx, -xy, -xz), (-xy, yy, -yz), (-xz, -yz, zz)))


def link_inertia(link: Link, values: Mapping[str, float]) -> RigidInertia | Unknown:
    """Return a link's inertia in its link frame, or why it is not known."""
    if link.inertia is None:
        return Unknown("it has no inertia section")
    written = written_inertia(link.inertia, values)
    if link.inertia.frame is None or isinstance(written, Unknown):
        return written
    frame = next((f for f in link.frames if f.name == link.inertia.frame), None)
    if frame is None:
        return Unknown(f"it has no frame `{link.inertia.frame}`")
    pose = written_pose(frame.pose, values)
    return (
        why_unknown(pose_expressions(frame.pose), values)
        if pose is None
        else written.seen_from(pose)
    )


def _added(a: Tensor, b: Tensor) -> Tensor:
    rows = [tuple(x + y for x, y in zip(p, q, strict=True)) for p, q in zip(a, b, strict=True)]
    return rows[0], rows[1], rows[2]  # type: ignore[return-value]
