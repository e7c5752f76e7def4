"""Bodies of a document that is not whole: what is missing is zero, what is lost is left out."""

from collections.abc import Mapping
from math import isfinite
from types import MappingProxyType
from typing import NamedTuple

from kindsl.language.semantics.declarations import Frame, Joint, Link, Pose, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.model import Model
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.mechanics.rigid.body import NO_BODY, MassDistribution, seen_from
from kindsl.mechanics.rigid.pose import RigidPose, Vector3, pose_from
from kindsl.robots.mechanism.numbering import numbered_by_tree
from kindsl.robots.mechanism.skeleton import Skeleton, skeleton_of

# Nothing is known of earlier versions.
NOTHING: Mapping[str, RigidPose] = MappingProxyType({})
_NUMBERS_OF_POSE = 6


def skeleton_as_far_as_known(
    model: Model, values: Mapping[str, float], earlier: Mapping[str, RigidPose] = NOTHING
) -> Skeleton | None:
    """Return the bodies that the base carries, None if there is not even one.

    Args:
        model: A document's model, however broken.
        values: Of parameters by name, and of constants by `<name>`.
        earlier: Where joints were, by name: it stands for a pose that is not whole.
    """
    try:
        return skeleton_of(model, numbered_by_tree(model), LenientReader(values, earlier))
    except ValueError:
        # No base, no link at all, or names that are used twice: there is no tree to draw.
        return None


class LenientReader(NamedTuple):
    """Reads the numbers that exist; one that is missing or infinite is zero.

    Attributes:
        values: Of parameters by name, and of constants by `<name>`.
        earlier: Poses of joints by name, for those that are not whole.
    """

    values: Mapping[str, float]
    earlier: Mapping[str, RigidPose] = NOTHING

    def joint_pose(self, joint: Joint) -> RigidPose:
        """Return a joint's frame in its predecessor's."""
        known = self.earlier.get(joint.name)
        return self._pose(joint.pose) if known is None or self.is_whole(joint.pose) else known

    def is_whole(self, pose: Pose) -> bool:
        """Return whether all six numbers of a pose are known."""
        vectors = (pose.translation, pose.rotation)
        numbers = [self._value(c) for v in vectors if v is not None for c in v.components]
        return len(numbers) == _NUMBERS_OF_POSE and None not in numbers

    def frame_pose(self, frame: Frame) -> RigidPose:
        """Return an optional frame in its link's."""
        return self._pose(frame.pose)

    def body(self, link: Link) -> MassDistribution:
        """Return a link's mass distribution about its frame; nothing where it is not whole."""
        inertia = link.inertia
        if inertia is None or inertia.com is None:
            return NO_BODY
        mass = self._value(inertia.mass)
        moments = [self._value(inertia.moments.get(name)) for name in MOMENTS]
        if mass is None or None in moments:
            return NO_BODY
        ix, iy, iz, ixy, ixz, iyz = (moment or 0.0 for moment in moments)
        given = MassDistribution(mass, self._vector(inertia.com), (ix, iy, iz, ixy, ixz, iyz))
        if inertia.frame is None:
            return given
        frame = next((frame for frame in link.frames if frame.name == inertia.frame), None)
        return NO_BODY if frame is None else seen_from(given, self.frame_pose(frame))

    def _pose(self, pose: Pose) -> RigidPose:
        return pose_from(self._vector(pose.translation), self._vector(pose.rotation))

    def _vector(self, vector: Vector | None) -> Vector3:
        if vector is None:
            return 0.0, 0.0, 0.0
        x, y, z = (self._value(component) or 0.0 for component in vector.components)
        return x, y, z

    def _value(self, expression: Expression | None) -> float | None:
        number = None if expression is None else expression.value(self.values)
        return number if number is not None and isfinite(number) else None
