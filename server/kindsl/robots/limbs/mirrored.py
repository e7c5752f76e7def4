"""A left and a right limb as points at the body that carries both: mirror images, or copies.

A copy of a limb that is flat is its mirror image, too. Where limbs are not flat, a robot that
mirrors its other limbs but has one copied was not finished.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import dist, hypot
from typing import NamedTuple

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose, Vector3
from kindsl.robots.limbs.limb import Body, Limbs, matched

# Points nearer than this are the same, m and as a share of the limb: designs are written in
# millimetres.
_SAME, _SHARE = 1e-3, 0.01
# Fewer points are flat anyhow.
_FEWEST = 3


class PairOfLimbs(NamedTuple):
    """A left and a right limb.

    Attributes:
        left: The head of the left one.
        right: The head of the right one.
        is_mirrored: Whether they are mirror images, and no copies of each other.
        is_copied: Whether the right one is the left one moved, and not its mirror image.
    """

    left: Body
    right: Body
    is_mirrored: bool
    is_copied: bool


def pairs_of(groups: Iterable[Limbs], masses: Mapping[str, MassDistribution]) -> list[PairOfLimbs]:
    """Return the left and right limbs of a robot that can be compared."""
    found = []
    for limbs in groups:
        heads = dict(limbs.heads)
        for one, other, how in limbs.pairs():
            left, right = (heads[side] for side in sorted((one, other), key=repr))
            rows = matched(left, right) if how == "LR" else None
            if rows is not None:
                found.append(_pair(left, right, masses))
    return found


def unmirrored(pairs: Sequence[PairOfLimbs]) -> Iterator[PairOfLimbs]:
    """Yield the one pair that is copied where all others that could be are mirrored."""
    copied = [pair for pair in pairs if pair.is_copied]
    if len(copied) == 1 and any(pair.is_mirrored for pair in pairs):
        yield from copied


def _pair(left: Body, right: Body, masses: Mapping[str, MassDistribution]) -> PairOfLimbs:
    here, there = (list(_points(head, _AT_CARRIER, masses)) for head in (left, right))
    if len(here) != len(there) or len(here) < _FEWEST:
        return PairOfLimbs(left, right, False, False)
    size = max(hypot(*(a - b for a, b in zip(p, here[0], strict=True))) for p in here)
    within = max(_SAME, _SHARE * size)
    origin = RigidPose(left.rotation, left.translation)
    target = RigidPose(right.rotation, right.translation)
    copies = [target.point(origin.inverse().point(point)) for point in here]
    is_copy = _are_same(copies, there, within)
    moved = [tuple(p[i] - here[0][i] + there[0][i] for i in range(3)) for p in here]
    is_copy = is_copy or _are_same(moved, there, within)
    is_image = any(_are_same([_mirror(p, axis) for p in here], there, within) for axis in range(3))
    is_flat = any(
        _are_same([_mirror(p, axis, here[0][axis]) for p in here], here, within)
        for axis in range(3)
    )
    return PairOfLimbs(
        left, right, is_image and not is_copy, is_copy and not is_image and not is_flat
    )


_AT_CARRIER = RigidPose(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))


def _points(
    body: Body, carrier: RigidPose, masses: Mapping[str, MassDistribution]
) -> Iterator[Vector3]:
    """Yield the origins of all joints of a limb and its centres of mass, in the carrier's frame."""
    pose = carrier.then(RigidPose(body.rotation, body.translation))
    yield pose.translation
    if body.name in masses:
        yield pose.point(masses[body.name].com)
    for child in (*body.children, *body.held):
        yield from _points(child, pose, masses)


def _mirror(point: Vector3, axis: int, at: float = 0.0) -> Vector3:
    x, y, z = (2.0 * at - c if i == axis else c for i, c in enumerate(point))
    return x, y, z


def _are_same(ones: Sequence[Sequence[float]], others: Sequence[Vector3], within: float) -> bool:
    return all(dist(a, b) <= within for a, b in zip(ones, others, strict=True))
