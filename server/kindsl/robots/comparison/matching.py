"""Matching of the joints of two robots: by a map, by names, else by shape and place."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from math import dist
from typing import NamedTuple

from kindsl.mechanics.rigid.body import MassDistribution, lumped, seen_from
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.comparison.features import axis_of, lines_apart
from kindsl.robots.mechanism.linkage import AttachedFrame, Linkage

# Of a mismatch of shape, beside one of mass or place: anything else is better.
_OTHER_SHAPE = 100.0
# Masses do not depend on where the other's base is, which may not be known.
_MASS = 10.0
_TINY = 1e-12


class MatchedJoints(NamedTuple):
    """The bodies that are one.

    Attributes:
        theirs: Index of the other's body by our body's, the bases included.
        only_ours: Our joints that match none.
        only_theirs: The other's.
    """

    theirs: Mapping[int, int]
    only_ours: tuple[str, ...]
    only_theirs: tuple[str, ...]

    @property
    def n_joints(self) -> int:
        """The number of matching joints."""
        return len(self.theirs) - 1


class _ViewAtZero(NamedTuple):
    """A robot at zero in a frame that both share.

    Attributes:
        subtrees: The mass of each body with all that it carries.
        shapes: Each body's subtree in brackets, the same in whatever order.
    """

    skeleton: Linkage
    children: list[list[int]]
    poses: list[RigidPose]
    subtrees: list[MassDistribution]
    shapes: list[str]


def matching_frames(
    ours: Linkage, theirs: Linkage
) -> Iterator[tuple[AttachedFrame, AttachedFrame]]:
    """Yield the frames whose names are equal as a document would write them."""
    its = {writable(frame.name): frame for frame in theirs.frames}
    for frame in ours.frames:
        if other := its.get(writable(frame.name)):
            yield frame, other


def bodies_by_name(ours: Linkage, theirs: Linkage) -> dict[int, int]:
    """Return the bodies that are one, by ours: of one name, else on one joint, else of one mass."""
    names = {name: its for its, name in enumerate(theirs.link_names, 1)}
    named = ((body, names.pop(name, 0)) for body, name in enumerate(ours.link_names, 1))
    found = {0: 0} | {body: its for body, its in named if its}
    for is_one in (_are_on_one_joint, _are_one_body):
        for body in range(1, len(ours.body_names)):
            free = () if body in found else sorted(names.values())
            its = next((its for its in free if is_one(ours, body, theirs, its)), 0)
            if its:
                found[body] = names.pop(theirs.body_names[its])
    return dict(sorted(found.items()))


def _are_on_one_joint(ours: Linkage, body: int, theirs: Linkage, its: int) -> bool:
    return ours.joint_names[body - 1] == theirs.joint_names[its - 1]


def _are_one_body(ours: Linkage, body: int, theirs: Linkage, its: int) -> bool:
    is_same_place = ours.placements[body - 1] == theirs.placements[its - 1]
    mass = ours.masses[body]
    return is_same_place and mass == theirs.masses[its] and mass.mass != 0.0


def writable(name: str) -> str:
    """Return a name as a document can write it: `tip.0` becomes `tip_0`."""
    return re.sub(r"\W", "_", name)


def matched(
    ours: Linkage,
    theirs: Linkage,
    named: Mapping[str, str],
    frames: Callable[[], Iterable[RigidPose]],
) -> MatchedJoints:
    """Return the matching with the fewest unmatched joints; names win over shapes.

    Args:
        ours: A robot.
        theirs: Another.
        named: Joints of the other by ours, which say what names and shapes do not.
        frames: Returns where the other's base may be in our base's frame.
    """
    view, other = _view(ours, IDENTITY), _view(theirs, IDENTITY)
    known = {**_same_names(ours, theirs), **named}
    by_names = _paired(view, other, known)
    n_named = sum(name in known for name in ours.joint_names)
    if n_named == by_names.n_joints == max(ours.n_links, theirs.n_links):
        return by_names
    views = (_view(theirs, frame) for frame in frames())
    options = [(_paired(view, other, named), other) for other in views]
    by_shape, _ = min(options, key=lambda option: _badness(option[0], view, option[1]))
    return by_names if n_named and by_names.n_joints >= by_shape.n_joints else by_shape


def _same_names(ours: Linkage, theirs: Linkage) -> dict[str, str]:
    """Return the joints whose names are equal, or equal once written in a document."""
    written = {writable(name): name for name in theirs.joint_names}
    pairs = {name: written.get(writable(name)) for name in ours.joint_names}
    exact = {name: name for name in ours.joint_names if name in theirs.joint_names}
    taken = set(exact.values())
    return {a: b for a, b in pairs.items() if b is not None and b not in taken} | exact


def _view(skeleton: Linkage, frame: RigidPose) -> _ViewAtZero:
    children: list[list[int]] = [[] for _ in skeleton.body_names]
    for link, parent in skeleton.links():
        children[parent].append(link)
    poses = [frame.then(pose) for pose in skeleton.zero_poses]
    subtrees = [seen_from(m, pose) for m, pose in zip(skeleton.masses, poses, strict=True)]
    shapes = [""] * len(poses)
    for body in reversed(range(len(poses))):
        subtrees[body] = lumped((subtrees[body], *(subtrees[child] for child in children[body])))
        kind = skeleton.joint_kinds[body - 1][0] if body else ""
        shapes[body] = f"{kind}({''.join(sorted(shapes[child] for child in children[body]))})"
    return _ViewAtZero(skeleton, children, poses, subtrees, shapes)


def _paired(ours: _ViewAtZero, theirs: _ViewAtZero, named: Mapping[str, str]) -> MatchedJoints:
    found = {0: 0}
    pending = [(0, 0)]
    while pending:
        body, other = pending.pop()
        children = ours.children[body], theirs.children[other]
        pairs = list(_child_pairs(ours, theirs, children, named))
        found.update(pairs)
        pending += pairs
    taken = set(found.values())
    return MatchedJoints(
        found,
        tuple(n for i, n in enumerate(ours.skeleton.joint_names, 1) if i not in found),
        tuple(n for i, n in enumerate(theirs.skeleton.joint_names, 1) if i not in taken),
    )


def _child_pairs(
    ours: _ViewAtZero,
    theirs: _ViewAtZero,
    children: tuple[list[int], list[int]],
    named: Mapping[str, str],
) -> Iterator[tuple[int, int]]:
    left, right = list(children[0]), list(children[1])
    names = {theirs.skeleton.joint_names[child - 1]: child for child in right}
    for child in children[0]:
        other = names.get(named.get(ours.skeleton.joint_names[child - 1], ""))
        if other is not None:
            yield child, other
    right = [r for r in right if theirs.skeleton.joint_names[r - 1] not in named.values()]
    left = [x for x in left if ours.skeleton.joint_names[x - 1] not in named]
    costs = sorted((_cost(ours, a, theirs, b), a, b) for a in left for b in right)
    for _, a, b in costs:
        is_same_kind = ours.shapes[a][0] == theirs.shapes[b][0]
        if a in left and b in right and is_same_kind:
            left.remove(a)
            right.remove(b)
            yield a, b


def _badness(option: MatchedJoints, ours: _ViewAtZero, theirs: _ViewAtZero) -> tuple[int, float]:
    costs = (_cost(ours, a, theirs, b) for a, b in option.theirs.items() if a)
    return -option.n_joints, sum(costs)


def _cost(ours: _ViewAtZero, a: int, theirs: _ViewAtZero, b: int) -> float:
    """Return the difference of two joints with their subtrees: shape, then mass, then place."""
    one, other = ours.subtrees[a], theirs.subtrees[b]
    shape = 0.0 if ours.shapes[a] == theirs.shapes[b] else _OTHER_SHAPE
    mass = _MASS * abs(one.mass - other.mass) / max(abs(one.mass), abs(other.mass), _TINY)
    apart = dist(one.com, other.com) if one.mass and other.mass else 0.0
    kind = ours.skeleton.joint_kinds[a - 1]
    axes = lines_apart(axis_of(kind, ours.poses[a]), axis_of(kind, theirs.poses[b]))
    return shape + mass + apart + sum(axes)
