"""Pieces of sentences that several features say."""

from math import degrees

from kindsl.features.quantity_text import vector
from kindsl.rigid.pose import RigidPose


def pose_text(pose: RigidPose) -> str:
    """Return a pose: origin in metres, intrinsic x, y, z angles in degrees."""
    turned = vector(degrees(angle) for angle in pose.angles)
    return f"origin {vector(pose.translation)} m, turned {turned}° about x, y, z"
