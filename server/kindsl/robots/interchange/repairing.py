"""Impossible bodies made possible, for formats whose programs refuse them."""

from dataclasses import replace

from kindsl.mechanics.rigid.body import nearest_possible
from kindsl.robots.mechanism.skeleton import Skeleton


def repaired(skeleton: Skeleton) -> tuple[Skeleton, tuple[str, ...]]:
    """Return a robot whose bodies have the nearest possible inertia, and a note on each changed."""
    masses = tuple(map(nearest_possible, skeleton.masses))
    notes = tuple(
        f"inertia of '{name}' is impossible: the nearest possible one written"
        for name, old, new in zip(skeleton.body_names, skeleton.masses, masses, strict=True)
        if new != old
    )
    return replace(skeleton, masses=masses), notes
