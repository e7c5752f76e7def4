"""Impossible bodies made possible, for formats whose programs refuse them."""

from kindsl.mechanics.rigid.body import nearest_possible
from kindsl.robots.mechanism.linkage import Linkage


def repaired(skeleton: Linkage) -> tuple[Linkage, tuple[str, ...]]:
    """Return a robot whose bodies have the nearest possible inertia, and a note on each changed."""
    masses = [None if b.mass is None else nearest_possible(b.mass) for b in skeleton.bodies]
    notes = tuple(
        f"inertia of '{name}' is impossible: the nearest possible one written"
        for name, old, new in zip(skeleton.body_names, skeleton.masses, masses, strict=True)
        if new is not None and new != old
    )
    return skeleton.with_masses(masses), notes
