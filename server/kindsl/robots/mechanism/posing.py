"""A skeleton in another configuration: the same bodies, with its joints moved."""

from collections.abc import Sequence
from dataclasses import replace
from math import cos, sin

from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.mechanism.skeleton import Skeleton


def posed(skeleton: Skeleton, q: Sequence[float]) -> Skeleton:
    """Return the robot whose zero is a configuration of another.

    Args:
        skeleton: The robot.
        q: Joint positions in the order of its links, radians and metres.
    """
    moved = zip(skeleton.placements, skeleton.joint_kinds, q, strict=True)
    placements = tuple(place.then(_motion(kind, value)) for place, kind, value in moved)
    return replace(skeleton, placements=placements)


def _motion(kind: str, value: float) -> RigidPose:
    """Return the pose of a joint's moving side in its fixed one: about z, or along it."""
    if kind == "prismatic":
        return RigidPose(IDENTITY.rotation, (0.0, 0.0, value))
    c, s = cos(value), sin(value)
    return RigidPose(((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))
