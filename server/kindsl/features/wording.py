"""Pieces of sentences that several features say."""

from collections.abc import Iterable
from math import degrees

from kindsl.features.quantity_text import vector
from kindsl.features.rigid_pose import RigidPose


def listed(words: Iterable[str]) -> str:
    """Return words as `a, b and c`."""
    parts = list(words)
    if len(parts) < 2:
        return "".join(parts)
    return f"{', '.join(parts[:-1])} and {parts[-1]}"


def counted(count: int, word: str) -> str:
    """Return a count with its noun: `1 joint`, `2 joints`."""
    return f"{count} {word}" if count == 1 else f"{count} {word}s"


def pose_text(pose: RigidPose) -> str:
    """Return a pose: origin in metres, intrinsic x, y, z angles in degrees."""
    turned = vector(degrees(angle) for angle in pose.angles)
    return f"origin {vector(pose.translation)} m, turned {turned}° about x, y, z"
