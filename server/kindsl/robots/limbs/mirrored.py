"""A left and a right limb as points at the body that carries both: mirror images, or copies.

A copy of a limb that is flat is its mirror image, too. Where limbs are not flat, a robot that
mirrors its other limbs but has one copied was not finished. The same arm on a turned mount at the
other side is meant so: both sides then look nearly alike.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from math import dist
from typing import NamedTuple

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose, Vector3
from kindsl.robots.limbs.limb import Body, Limbs, matched
from kindsl.robots.limbs.mounts import SAME_PLACE

# Points of a limb that are nearer than this share of it are the same.
_SHARE = 0.01
# How far a copy that is turned is from its mirror image at least, as a share of the limb: 0.09 in
# the one published robot that turns an arm, 0.16 and more in 37 of 44 limbs copied below the head.
_UNLIKE = 0.2
# A point is its own mirror image.
_FEWEST = 2


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


def pairs_of(
    carried: Iterable[Sequence[Limbs]], masses: Mapping[str, MassDistribution]
) -> list[PairOfLimbs]:
    """Return the left and right limbs of a robot that can be compared.

    Args:
        carried: The limbs of each body that carries some.
        masses: Of the links, where they are known.
    """
    found = []
    for groups in carried:
        heads = [pair for limbs in groups for pair in _heads(limbs)]
        axes = {axis for pair in heads if (axis := _only_axis_between(*pair)) is not None}
        for left, right in heads:
            if matched(left, right) is not None:
                axis = _only_axis_between(left, right)
                across = axes or set(range(3)) if axis is None else {axis}
                found.append(_pair(left, right, across, masses))
    return found


def _heads(limbs: Limbs) -> Iterator[tuple[Body, Body]]:
    heads = dict(limbs.heads)
    for one, other, how in limbs.pairs():
        if how == "LR":
            left, right = sorted((one, other), key=repr)
            yield heads[left], heads[right]


def _only_axis_between(left: Body, right: Body) -> int | None:
    """Return the one axis of the carrier along which two heads are apart, if it is one."""
    pairs = zip(left.translation, right.translation, strict=True)
    apart = [axis for axis, (x, y) in enumerate(pairs) if abs(x - y) > SAME_PLACE]
    return apart[0] if len(apart) == 1 else None


def unmirrored(pairs: Sequence[PairOfLimbs]) -> Iterator[PairOfLimbs]:
    """Yield the one pair that is copied where all others that could be are mirrored."""
    copied = [pair for pair in pairs if pair.is_copied]
    if len(copied) == 1 and any(pair.is_mirrored for pair in pairs):
        yield from copied


def _pair(
    left: Body, right: Body, axes: Collection[int], masses: Mapping[str, MassDistribution]
) -> PairOfLimbs:
    """Return what two limbs are; who copies joints alone may have left the masses mirrored."""
    known: tuple[Mapping[str, MassDistribution], ...] = ({}, masses)
    images, copies = zip(*(_likeness(left, right, axes, each) for each in known), strict=True)
    is_copied = copies[0] if images[0] != copies[0] else copies[1] and not images[1]
    return PairOfLimbs(left, right, images[1] and not copies[1], is_copied)


def _likeness(
    left: Body, right: Body, axes: Collection[int], masses: Mapping[str, MassDistribution]
) -> tuple[bool, bool]:
    """Return whether a limb is the mirror image of another, and whether its copy: both if flat."""
    here, there = (list(_points(head, IDENTITY, masses)) for head in (left, right))
    if len(here) != len(there) or len(here) < _FEWEST:
        return False, False
    size = max(dist(point, here[0]) for point in here)
    within = max(SAME_PLACE, _SHARE * size)
    off = min(_apart([_mirror(point, axis) for point in here], there) for axis in axes)
    origin = RigidPose(left.rotation, left.translation).inverse()
    target = RigidPose(right.rotation, right.translation)
    turned = [target.point(origin.point(point)) for point in here]
    moved = [tuple(p[i] - here[0][i] + there[0][i] for i in range(3)) for p in here]
    is_copy = _apart(moved, there) <= within
    is_copy |= _apart(turned, there) <= within and off > _UNLIKE * size
    own = ([_mirror(point, axis, here[0][axis]) for point in here] for axis in axes)
    is_flat = any(_apart(image, here) <= within for image in own)
    return off <= within or (is_copy and is_flat), is_copy


def _points(
    body: Body, carrier: RigidPose, masses: Mapping[str, MassDistribution]
) -> Iterator[Vector3]:
    """Yield the origins of a limb's joints, and the centres of mass, in the carrier's frame.

    What a limb holds may be alike on both sides.
    """
    pose = carrier.then(RigidPose(body.rotation, body.translation))
    yield pose.translation
    if body.name in masses:
        yield pose.point(masses[body.name].com)
    for child in body.children:
        yield from _points(child, pose, masses)


def _mirror(point: Vector3, axis: int, at: float = 0.0) -> Vector3:
    x, y, z = (2.0 * at - c if i == axis else c for i, c in enumerate(point))
    return x, y, z


def _apart(ones: Sequence[Sequence[float]], others: Sequence[Vector3]) -> float:
    """Return the greatest distance of two points."""
    return max(map(dist, ones, others))
