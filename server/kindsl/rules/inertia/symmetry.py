"""Symmetry of a part and its twin, as the joint frames have it."""

from collections.abc import Mapping, Sequence
from itertools import product
from math import dist, hypot
from operator import mul
from typing import NamedTuple

from kindsl.rigid.pose import IDENTITY, RigidPose, Vector3
from kindsl.semantics.declarations import Link
from kindsl.semantics.kinematic_tree import Edge, KinematicTree
from kindsl.semantics.numbers import written_pose

SIGNS: tuple[Vector3, ...] = tuple(product((1.0, -1.0), repeat=3))  # type: ignore[arg-type]
_DEEPEST = 16
_SAME = 0.02


class _Symmetry(NamedTuple):
    """The map from a part to its twin.

    Attributes:
        n_moved: Axes of the common carrier along which it moves the part besides.
        trace: Of its reflection or turn; the greater, the less it changes.
    """

    n_moved: int
    trace: float


def twin_signs(
    tree: KinematicTree, one: Link, other: Link, values: Mapping[str, float]
) -> list[Vector3]:
    """Return the signs that may make coordinates in a part's link frame those in its twin's.

    A reflection or a turn in the frame of the body that carries both takes the part's joints to
    those of its twin, and the axes of its link frame, so reversed, to those of its twin's. Along
    one axis that is not reversed the twin may be moved besides: hind legs are often copies of the
    fore legs. What moves nothing comes first, and of those what changes least.

    Args:
        tree: The robot.
        one: A part.
        other: Its twin.
        values: Of the parameters.

    Returns:
        Signs of x, y and z; none where the parts do not lie so, or one carries the other.
    """
    here, there = _way_up(tree, one), _way_up(tree, other)
    carriers = {edge.predecessor for edge in there}
    carrier = next((edge.predecessor for edge in here if edge.predecessor in carriers), None)
    mine, others = _seen(here, carrier, values), _seen(there, carrier, values)
    if not mine or len(mine) != len(others):
        return []
    found: list[tuple[_Symmetry, Vector3]] = []
    for signs in SIGNS:
        if all(_is_mirrored(signs, *pair) for pair in zip(mine[:-1], others[:-1], strict=True)):
            symmetry = _symmetry(signs, mine[-1], others[-1])
            found += [] if symmetry is None else [(symmetry, signs)]
    found.sort(key=lambda each: (each[0].n_moved, -each[0].trace))
    return [signs for _, signs in found]


def with_signs(signs: Vector3, vector: Vector3) -> Vector3:
    """Return a vector with its components times the signs."""
    return signs[0] * vector[0], signs[1] * vector[1], signs[2] * vector[2]


def _way_up(tree: KinematicTree, link: Link) -> list[Edge]:
    """Return the edges from a link to the base, the first of them if they are very many."""
    way: list[Edge] = []
    edge = tree.supporting_edge(link)
    while edge is not None and len(way) < _DEEPEST:
        way.append(edge)
        edge = tree.supporting_edge(edge.predecessor)
    return way


def _seen(
    way: Sequence[Edge], carrier: Link | None, values: Mapping[str, float]
) -> list[RigidPose]:
    """Return the bodies up to a carrier as a link sees them, none if one's place is not known."""
    seen: list[RigidPose] = []
    for edge in way:
        pose = written_pose(edge.joint.pose, values) if edge.joint is not None else None
        if pose is None:
            return []
        seen.append((seen[-1] if seen else IDENTITY).then(pose.inverse()))
        if edge.predecessor is carrier:
            return seen
    return []


def _is_mirrored(signs: Vector3, mine: RigidPose, others: RigidPose) -> bool:
    """Return whether two parts see their carriers at places that differ by signs."""
    here, there = with_signs(signs, mine.translation), others.translation
    return dist(here, there) <= _SAME * max(hypot(*here), hypot(*there))


def _symmetry(signs: Vector3, mine: RigidPose, others: RigidPose) -> _Symmetry | None:
    """Return what takes a part to its twin, given how they see their common carrier."""
    one, other = mine.inverse(), others.inverse()
    rows = zip(one.rotation, other.rotation, strict=True)
    diagonal = [sum(map(mul, with_signs(signs, a), b)) for a, b in rows]
    if _is_mirrored(signs, mine, others):
        is_same_place = _is_mirrored((1.0, 1.0, 1.0), one, other)
        return None if is_same_place else _Symmetry(0, sum(diagonal))
    size = max(hypot(*one.translation), hypot(*other.translation))
    places = zip(one.translation, other.translation, strict=True)
    moved = [abs(d * x - y) > _SAME * size for d, (x, y) in zip(diagonal, places, strict=True)]
    is_along_axes = all(abs(d) > 1.0 - _SAME for d in diagonal)
    if sum(moved) == 1 and is_along_axes and diagonal[moved.index(True)] > 0.0:
        return _Symmetry(1, sum(diagonal))
    return None
