"""Pieces of sentences that several features say."""

from collections.abc import Iterable
from math import degrees
from typing import NamedTuple

from kindsl.frontends.features.quantity_text import vector
from kindsl.mechanics.rigid.pose import PLAIN, RigidPose, angles


def pose_text(pose: RigidPose) -> str:
    """Return a pose: origin in metres, intrinsic x, y, z angles in degrees."""
    turned = vector(degrees(angle) for angle in angles(pose.rotation, PLAIN))
    return f"origin {vector(pose.translation)} m, turned {turned}° about x, y, z"


class Hover(NamedTuple):
    """A text in Markdown about a stretch of the document."""

    start: int
    end: int
    markdown: str


def code(name: str) -> str:
    """Return a name as Markdown shows it, in words where it is missing."""
    return f"`{name}`" if name else "(no name)"


def paragraph(title: str, lines: Iterable[str]) -> str:
    """Return a title and a list below it."""
    items = "\n".join(f"- {line}" for line in lines)
    return f"{title}\n\n{items}"
