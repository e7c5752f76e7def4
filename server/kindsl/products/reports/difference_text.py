"""A mechanical difference in words and numbers for people."""

from collections.abc import Iterator
from math import degrees
from typing import NamedTuple

from kindsl.robots.comparison.difference import Difference, MassChange, Moved

# Relative change of a tensor whose principal moments print the same.
_TURNED = 1e-6


class ChangeRow(NamedTuple):
    """One line: what kind of thing, its name, what happened to it."""

    kind: str
    name: str
    change: str


def change_rows(found: Difference) -> Iterator[ChangeRow]:
    """Yield what changed, structure first, then geometry, then masses, then totals."""
    yield from _structure(found)
    for kind, moves in (
        ("joint frame", found.joint_frames),
        ("frame", found.frames),
        ("pose at zero", found.zero_poses),
    ):
        yield from (ChangeRow(kind, move.name, _motion(move)) for move in moves)
    for change in found.masses:
        yield from (ChangeRow("inertia", change.link, text) for text in _mass(change))
    yield from _totals(found)


def _structure(found: Difference) -> Iterator[ChangeRow]:
    if found.base_kind[0] != found.base_kind[1]:
        yield ChangeRow("base", "", f"{found.base_kind[0]} -> {found.base_kind[1]}")
    for kind, added, removed in (
        ("link", found.added_links, found.removed_links),
        ("joint", found.added_joints, found.removed_joints),
        ("frame", found.added_frames, found.removed_frames),
    ):
        yield from (ChangeRow(kind, name, "added") for name in added)
        yield from (ChangeRow(kind, name, "removed") for name in removed)
    for pair in found.renamed_links:
        yield ChangeRow("link", pair.new, f"renamed, was '{pair.old}'")
    for moved in found.reparented:
        yield ChangeRow(
            "link", moved.link, f"attached to '{moved.new_parent}' instead of '{moved.old_parent}'"
        )
    for joint in found.joint_kinds:
        yield ChangeRow("joint", joint.joint, f"{joint.old} -> {joint.new}")


def _motion(move: Moved) -> str:
    return f"moved {move.distance * 1e3:.4g} mm, turned {degrees(move.angle):.4g} deg"


def _mass(change: MassChange) -> Iterator[str]:
    old, new = change.mass
    if old != new:
        yield f"mass {old:.6g} -> {new:.6g} kg{_percent(old, new)}"
    if change.com_distance:
        yield f"CoM moved {change.com_distance * 1e3:.4g} mm"
    before, after = change.principal_moments
    if any(f"{a:.4g}" != f"{b:.4g}" for a, b in zip(before, after, strict=True)):
        yield f"principal moments {_triple(before)} -> {_triple(after)} kg m^2"
    elif change.inertia_change > _TURNED:
        yield f"principal axes turned, inertia about the CoM changed by {change.inertia_change:.2%}"


def _triple(moments: tuple[float, ...]) -> str:
    return f"({', '.join(f'{moment:.4g}' for moment in moments)})"


def _totals(found: Difference) -> Iterator[ChangeRow]:
    for name, (old, new), unit in (("mass", found.total_mass, "kg"), ("reach", found.reach, "m")):
        if f"{old:.9g}" != f"{new:.9g}":
            yield ChangeRow("total", name, f"{old:.6g} -> {new:.6g} {unit}{_percent(old, new)}")


def _percent(old: float, new: float) -> str:
    return f" ({100.0 * (new - old) / old:+.3g} %)" if old else ""
