"""Alignment of the link frames of two robots: conventions are found, not assumed.

A link frame may lie anywhere in its link, a joint turn the other way and be zero elsewhere. For
each pair of bodies the pose is chosen under which most of what is fixed to them agrees: the axes of
the joints that they carry, their mass, and where the parent puts them at zero.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from math import atan2, dist
from typing import NamedTuple

from kindsl.mechanics.rigid.body import MassDistribution, lumped, seen_from
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose, product, rotation_from_z, transposed
from kindsl.robots.comparison.features import (
    HALF_TURNS,
    AxisLine,
    Features,
    axis_of,
    frames_of,
    lines_apart,
    second_moment_gap,
    seen_features,
)
from kindsl.robots.comparison.matching import MatchedJoints
from kindsl.robots.mechanism.linkage import Linkage, motion

# Nobody chooses to have a joint's zero so little elsewhere: it is a number that differs.
DRIFT = 0.05
_GRADES = ((1e-10, 1.0), (1e-6, 0.8), (3e-4, 0.5))
_VERTICAL = AxisLine(IDENTITY.translation, (0.0, 0.0, 1.0), is_free=True)
_TURNED_ONLY = 0.4
_AXES_OF_ROOT = 4
_MOST_ROOTS = 6
_SAME = 1e-9
_MOST_OPTIONS = 6
_APART = 1e-6
_LIKELY = 0.5


class AlignedJoint(NamedTuple):
    """The other's joint: its sign, and our value at its zero, rad or m; no drift."""

    sign: float
    offset: float


class Alignment(NamedTuple):
    """The other's link frames in ours, and its joints' signs and zeros, by our body."""

    frames: dict[int, RigidPose]
    joints: dict[int, AlignedJoint]


Cost = Callable[[int, Alignment], int]


class _BodyPair(NamedTuple):
    """Two matching bodies whose relative frame is sought."""

    ours: Features
    theirs: Features
    size: float


def base_frames(ours: Linkage, theirs: Linkage) -> list[RigidPose]:
    """Return candidates for the other's base in ours before joints are matched."""
    one, other = (Features((), _whole(skeleton)) for skeleton in (ours, theirs))
    return [IDENTITY, *_candidates(one, other)]


def likely_base_frames(
    ours: Linkage, theirs: Linkage, matching: MatchedJoints
) -> Iterator[RigidPose]:
    """Yield candidates for the other's base in ours, the best first; ours is among them."""
    root = _root_pair(ours, theirs, matching, size_of(ours))
    is_likely = _agreement(root, IDENTITY) >= _LIKELY * _agreement(root, IDENTITY, root.ours)
    if is_likely:
        yield IDENTITY
    options = _candidates(root.ours, root.theirs)
    best = sorted(options, key=lambda each: -_agreement(root, each))
    yield from _unlike_each_other(best, (IDENTITY,), _MOST_ROOTS)
    if not is_likely:
        yield IDENTITY


def as_written(matching: MatchedJoints) -> Alignment:
    """Return the conventions of a robot whose frames, zeros and signs are ours."""
    bodies = matching.theirs
    joints = {body: AlignedJoint(1.0, 0.0) for body in bodies if body}
    return Alignment(dict.fromkeys(bodies, IDENTITY), joints)


def aligned(
    ours: Linkage, theirs: Linkage, matching: MatchedJoints, root: RigidPose, cost: Cost
) -> Alignment:
    """Return the conventions under which two robots agree most.

    Args:
        ours: A robot.
        theirs: Another.
        matching: Their matching bodies.
        root: The other's base frame in ours.
        cost: Returns the number of differences of a body and its joint.
    """
    size = size_of(ours)
    frames, joints = {0: root}, dict[int, AlignedJoint]()
    for body in sorted(matching.theirs)[1:]:
        other, parent = matching.theirs[body], frames[ours.parents[body - 1]]
        D = ours.placements[body - 1].inverse().then(parent).then(theirs.placements[other - 1])
        pair = _pair(ours, theirs, matching, body, size)
        slides = ours.joint_kinds[body - 1] == "prismatic"
        tried = [
            Alignment({**frames, body: each}, {**joints, body: _counted(D, each, slides, size)})
            for each in _options(pair, D, slides)
        ]
        if len(tried) > 1:
            tried.sort(key=lambda each: cost(body, each) + _n_apart(pair, each.frames[body]))
        frames, joints = tried[0]
    return Alignment(frames, joints)


def size_of(skeleton: Linkage) -> float:
    """Return the greatest distance of a joint from the base's origin at zero, metres."""
    return max(dist(pose.translation, IDENTITY.translation) for pose in skeleton.zero_poses) or 1.0


def _unlike_each_other(
    frames: Iterable[RigidPose], known: Sequence[RigidPose], most: int
) -> list[RigidPose]:
    kept: list[RigidPose] = []
    for frame in frames:
        if all(dist(frame.numbers, other.numbers) > _SAME for other in (*known, *kept)):
            kept.append(frame)
            if len(kept) == most:
                break
    return kept


def around(ours: Linkage, alignment: Alignment, body: int) -> tuple[RigidPose, RigidPose]:
    """Return the poses before and after the other's joint frame that make it ours."""
    joint = alignment.joints[body]
    at_zero = motion(ours.joint_kinds[body - 1], -joint.sign * joint.offset)
    before = alignment.frames[ours.parents[body - 1]]
    return before, at_zero.then(alignment.frames[body].inverse())


def _whole(skeleton: Linkage) -> MassDistribution:
    first = 0 if skeleton.is_floating else 1
    pairs = list(zip(skeleton.masses, skeleton.zero_poses, strict=True))[first:]
    return lumped([seen_from(body, pose) for body, pose in pairs])


def _root_pair(ours: Linkage, theirs: Linkage, matching: MatchedJoints, size: float) -> _BodyPair:
    pairs = sorted(matching.theirs.items())[1 : 1 + _AXES_OF_ROOT]
    heavy = [(a, b) for a, b in pairs if ours.masses[a].mass and theirs.masses[b].mass]
    is_base_heavy = ours.is_floating and ours.masses[0].mass and theirs.masses[0].mass
    vertical = () if ours.is_floating or theirs.is_floating else (_VERTICAL,)

    def features(robot: Linkage, side: int) -> Features:
        poses = robot.zero_poses
        bodies = [pair[side] for pair in pairs]
        lines = (axis_of(robot.joint_kinds[body - 1], poses[body]) for body in bodies)
        points = (poses[pair[side]].point(robot.masses[pair[side]].com) for pair in heavy)
        mass = robot.masses[0] if is_base_heavy else _whole(robot)
        return Features((*lines, *vertical), mass, tuple(points))

    return _BodyPair(features(ours, 0), features(theirs, 1), size)


def _pair(
    ours: Linkage, theirs: Linkage, matching: MatchedJoints, body: int, size: float
) -> _BodyPair:
    own, its = axis_of(ours.joint_kinds[body - 1], IDENTITY), matching.theirs[body]
    carried = [
        (child, other)
        for child, other in matching.theirs.items()
        if child and ours.parents[child - 1] == body and theirs.parents[other - 1] == its
    ]

    def features(robot: Linkage, side: int) -> Features:
        children = [pair[side] - 1 for pair in carried]
        lines = (axis_of(robot.joint_kinds[i], robot.placements[i]) for i in children)
        return Features((own, *lines), robot.masses[(body, its)[side]])

    return _BodyPair(features(ours, 0), features(theirs, 1), size)


def _candidates(ours: Features, theirs: Features) -> Iterator[RigidPose]:
    """Yield candidates for the other frame in ours, by frames that both features define."""
    for frame, other in zip(frames_of(ours), frames_of(theirs), strict=True):
        if frame is not None and other is not None:
            back = other.inverse()
            yield from (frame.then(turn).then(back) for turn in HALF_TURNS)


def _options(pair: _BodyPair, D: RigidPose, slides: bool) -> list[RigidPose]:
    """Return the likely frames: our own if that does, else where the parent puts it, else any.

    One under which all agrees is the only one.
    """
    found: list[tuple[float, RigidPose]] = []
    whole = _agreement(pair, IDENTITY, pair.ours) + 1.0
    for option in (HALF_TURNS[0], HALF_TURNS[1], D, *_candidates(pair.ours, pair.theirs)):
        frame = _on_axis(option, slides)
        score = _agreement(pair, frame) + _placed(D, frame, slides, pair.size)
        if score >= whole - 1e-9:
            return [frame]
        found.append((score, frame))
    found.sort(key=lambda each: -each[0])
    return _unlike_each_other([frame for _, frame in found], (), _MOST_OPTIONS)


def _n_apart(pair: _BodyPair, frame: RigidPose) -> int:
    others = seen_features(pair.theirs, frame).lines
    gaps = (lines_apart(a, b) for a, b in zip(pair.ours.lines, others, strict=True))
    return sum(max(sine, distance / pair.size) > _APART for sine, distance in gaps)


def _on_axis(frame: RigidPose, slides: bool) -> RigidPose:
    """Return the nearest frame whose z axis is ours, either way round."""
    x, y, z = (row[2] for row in frame.rotation)
    side = -1.0 if z < 0.0 else 1.0
    turn = transposed(rotation_from_z((side * x, side * y, side * z)))
    rotation = product(turn, frame.rotation) if x or y else frame.rotation
    x, y, z = frame.translation
    return RigidPose(rotation, (x, y, z) if slides else (0.0, 0.0, z))


def _agreement(pair: _BodyPair, frame: RigidPose, theirs: Features | None = None) -> float:
    """Return the number of features that agree, partly if they agree roughly."""
    other = seen_features(pair.theirs, frame) if theirs is None else theirs
    total = 0.0
    for line, carried in zip(pair.ours.lines, other.lines, strict=True):
        sine, distance = lines_apart(line, carried)
        total += _grade(max(sine, distance / pair.size))
    for point, its in zip(pair.ours.points, other.points, strict=True):
        total += _grade(dist(point, its) / pair.size)
    one, two = pair.ours.mass, other.mass
    if one.mass and two.mass:
        total += _grade(dist(one.com, two.com) / pair.size)
        total += _grade(min(second_moment_gap(one, two), _moment_gap(one, two)))
    return total


def _moment_gap(one: MassDistribution, other: MassDistribution) -> float:
    size = max(map(abs, one.moments)) or 1.0
    return max(abs(a - b) for a, b in zip(one.moments, other.moments, strict=True)) / size


def _grade(gap: float) -> float:
    return next((grade for limit, grade in _GRADES if gap <= limit), 0.0)


def _placed(D: RigidPose, frame: RigidPose, slides: bool, size: float) -> float:
    """Return how well the parent places a frame: at zero, or at another joint value."""
    E = D.then(frame.inverse())
    x, y, z = E.translation
    across = max(abs(E.rotation[0][2]), abs(E.rotation[1][2]), abs(x) / size, abs(y) / size)
    if E.rotation[2][2] < 0.0:
        return 0.0
    if slides:
        return _free_or_zero(max(across, abs(E.rotation[1][0])), abs(z) / size)
    return _free_or_zero(max(across, abs(z) / size), abs(atan2(E.rotation[1][0], E.rotation[0][0])))


def _free_or_zero(gap: float, value: float) -> float:
    return max(_grade(max(gap, value)), _TURNED_ONLY * _grade(gap))


def _counted(D: RigidPose, frame: RigidPose, slides: bool, size: float) -> AlignedJoint:
    sign = -1.0 if frame.rotation[2][2] < 0.0 else 1.0
    E = D.then(frame.inverse())
    value = E.translation[2] if slides else atan2(E.rotation[1][0], E.rotation[0][0])
    return AlignedJoint(sign, value if abs(value) > DRIFT * (size if slides else 1.0) else 0.0)
