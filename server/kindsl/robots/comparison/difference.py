"""Mechanical changes between two mechanisms."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import atan2, dist, fsum, hypot

from kindsl.mechanics.rigid.body import (
    MassDistribution,
    principal_moments_about_com,
    seen_from,
    shifted,
)
from kindsl.mechanics.rigid.pose import RigidPose, transposed
from kindsl.robots.mechanism.skeleton import Skeleton

_LENGTH_TOLERANCE = 1e-9
_ANGLE_TOLERANCE = 1e-9
_RELATIVE_TOLERANCE = 1e-9
# Of a tensor about the CoM, which is a difference of two that may be larger.
_TENSOR_TOLERANCE = 1e-6


@dataclass(frozen=True, slots=True)
class Renamed:
    """A link that is the same but for its name."""

    old: str
    new: str


@dataclass(frozen=True, slots=True)
class Reparented:
    """A link with another parent."""

    link: str
    old_parent: str
    new_parent: str


@dataclass(frozen=True, slots=True)
class Moved:
    """A pose that changed.

    Attributes:
        name: Of the joint or the frame.
        distance: Between the old and the new origin, metres.
        angle: Of the rotation between the old and the new axes, radians.
    """

    name: str
    distance: float
    angle: float


@dataclass(frozen=True, slots=True)
class JointKindChange:
    """A joint that slides instead of turning, or the reverse."""

    joint: str
    old: str
    new: str


@dataclass(frozen=True, slots=True)
class MassChange:
    """Mass properties that changed.

    Attributes:
        link: The link's name.
        mass: Old and new mass, kg.
        com_distance: Between the old and the new centre of mass, metres: in the link's frame or,
            if that is less because the frame was turned or put elsewhere, in the base's at zero.
        principal_moments: Old and new principal moments about the centre of mass, ascending,
            kg m^2.
        inertia_change: Norm of the change of the tensor about the centre of mass, over the norm of
            the old one or the new one, whichever is greater; in the one frame or the other, too.
    """

    link: str
    mass: tuple[float, float]
    com_distance: float
    principal_moments: tuple[tuple[float, ...], tuple[float, ...]]
    inertia_change: float


@dataclass(frozen=True, slots=True)
class Difference:
    """The changes from an old to a new mechanism; joint frames move in their predecessors.

    Attributes:
        added_links: Links that are new.
        removed_links: Links that are gone.
        renamed_links: Links that only changed their name.
        reparented: Links with another parent.
        added_joints: Joints that are new.
        removed_joints: Joints that are gone.
        joint_kinds: Joints of another kind.
        added_frames: Frames that are new.
        removed_frames: Frames that are gone.
        joint_frames: Joint frames that moved in their predecessor's frame.
        frames: Frames that moved in their link's frame.
        zero_poses: Links and frames that moved in the base's frame at zero.
        masses: Changed mass properties.
        base_kind: Old and new kind of the base, `"fixed"` or `"floating"`.
        total_mass: Old and new mass of the moving bodies, kg.
        reach: Old and new length of the longest way from the base to a link or frame, metres.
    """

    added_links: tuple[str, ...]
    removed_links: tuple[str, ...]
    renamed_links: tuple[Renamed, ...]
    reparented: tuple[Reparented, ...]
    added_joints: tuple[str, ...]
    removed_joints: tuple[str, ...]
    joint_kinds: tuple[JointKindChange, ...]
    added_frames: tuple[str, ...]
    removed_frames: tuple[str, ...]
    joint_frames: tuple[Moved, ...]
    frames: tuple[Moved, ...]
    zero_poses: tuple[Moved, ...]
    masses: tuple[MassChange, ...]
    base_kind: tuple[str, str]
    total_mass: tuple[float, float]
    reach: tuple[float, float]

    @property
    def is_empty(self) -> bool:
        """True if there is no mechanical change, names included."""
        old_new = self.base_kind, self.total_mass, self.reach
        lists = (
            *(self.added_links, self.removed_links, self.renamed_links, self.reparented),
            *(self.added_joints, self.removed_joints, self.joint_kinds),
            *(self.added_frames, self.removed_frames, self.joint_frames, self.frames),
            *(self.zero_poses, self.masses),
        )
        return not any(lists) and all(_is_close(a, b) for a, b in old_new)


def difference(old: Skeleton, new: Skeleton) -> Difference:
    """Return the changes from `old` to `new`; links, joints and frames are matched by name."""
    renamed = tuple(_renamed(old, new))
    new_name = {pair.old: pair.new for pair in renamed}
    old_name = {pair.new: pair.old for pair in renamed}
    return Difference(
        added_links=tuple(n for n in _only_in(new, old) if n not in old_name),
        removed_links=tuple(n for n in _only_in(old, new) if n not in new_name),
        renamed_links=renamed,
        reparented=tuple(_reparented(old, new, new_name)),
        added_joints=_missing(new.joint_names, old.joint_names),
        removed_joints=_missing(old.joint_names, new.joint_names),
        joint_kinds=tuple(_joint_kinds(old, new)),
        added_frames=_missing(_frame_names(new), _frame_names(old)),
        removed_frames=_missing(_frame_names(old), _frame_names(new)),
        joint_frames=tuple(_moved(_joint_frames(old), _joint_frames(new))),
        frames=tuple(_moved(_frames(old), _frames(new))),
        zero_poses=tuple(_moved(_renamed_keys(_zero_poses(old), new_name), _zero_poses(new))),
        masses=tuple(_masses(old, new, new_name)),
        base_kind=(_base_kind(old), _base_kind(new)),
        total_mass=(_total_mass(old), _total_mass(new)),
        reach=(_reach(old), _reach(new)),
    )


def _is_close(a: float | str, b: float | str) -> bool:
    if isinstance(a, str) or isinstance(b, str):
        return a == b
    return abs(a - b) <= _RELATIVE_TOLERANCE * max(abs(a), abs(b))


def _missing(names: tuple[str, ...], others: tuple[str, ...]) -> tuple[str, ...]:
    known = set(others)
    return tuple(name for name in names if name not in known)


def _only_in(skeleton: Skeleton, other: Skeleton) -> tuple[str, ...]:
    return _missing(skeleton.body_names, other.body_names)


def _renamed(old: Skeleton, new: Skeleton) -> Iterator[Renamed]:
    """Yield links that are gone, paired with new ones on the same joint or with the same body."""
    gone = [n for n in _only_in(old, new) if n != old.base_name]
    come = [n for n in _only_in(new, old) if n != new.base_name]
    if old.base_name != new.base_name:
        yield Renamed(old.base_name, new.base_name)
    by_joint = {_joint_of(new, name): name for name in come}
    for name in gone:
        same = by_joint.pop(_joint_of(old, name), None)
        if same is not None:
            come.remove(same)
            yield Renamed(name, same)
            continue
        for candidate in come:
            if _is_same_body(old, name, new, candidate):
                come.remove(candidate)
                by_joint.pop(_joint_of(new, candidate), None)
                yield Renamed(name, candidate)
                break


def _joint_of(skeleton: Skeleton, link: str) -> str:
    return skeleton.joint_names[skeleton.link_names.index(link)]


def _is_same_body(old: Skeleton, old_link: str, new: Skeleton, new_link: str) -> bool:
    i, j = old.link_names.index(old_link), new.link_names.index(new_link)
    body = old.masses[i + 1]
    is_same = body == new.masses[j + 1] and old.placements[i] == new.placements[j]
    return is_same and body.mass != 0.0


def _reparented(old: Skeleton, new: Skeleton, new_name: Mapping[str, str]) -> Iterator[Reparented]:
    parents = dict(zip(new.link_names, new.parents, strict=True))
    for name, parent in zip(old.link_names, old.parents, strict=True):
        now = new_name.get(name, name)
        if now in parents:
            before, after = old.body_names[parent], new.body_names[parents[now]]
            if new_name.get(before, before) != after:
                yield Reparented(now, before, after)


def _joint_kinds(old: Skeleton, new: Skeleton) -> Iterator[JointKindChange]:
    kinds = dict(zip(new.joint_names, new.joint_kinds, strict=True))
    for name, kind in zip(old.joint_names, old.joint_kinds, strict=True):
        if name in kinds and kinds[name] != kind:
            yield JointKindChange(name, kind, kinds[name])


def _frame_names(skeleton: Skeleton) -> tuple[str, ...]:
    return tuple(frame.name for frame in skeleton.frames)


def _joint_frames(skeleton: Skeleton) -> dict[str, RigidPose]:
    return dict(zip(skeleton.joint_names, skeleton.placements, strict=True))


def _frames(skeleton: Skeleton) -> dict[str, RigidPose]:
    return {frame.name: frame.pose for frame in skeleton.frames}


def _zero_poses(skeleton: Skeleton) -> dict[str, RigidPose]:
    poses = skeleton.zero_poses()
    of_frames = {frame.name: poses[frame.body].then(frame.pose) for frame in skeleton.frames}
    return {**dict(zip(skeleton.link_names, poses[1:], strict=True)), **of_frames}


def _renamed_keys(
    poses: Mapping[str, RigidPose], new_name: Mapping[str, str]
) -> dict[str, RigidPose]:
    return {new_name.get(name, name): pose for name, pose in poses.items()}


def _moved(old: Mapping[str, RigidPose], new: Mapping[str, RigidPose]) -> Iterator[Moved]:
    for name, before in old.items():
        if name not in new:
            continue
        distance = dist(before.translation, new[name].translation)
        angle = _angle_between(before, new[name])
        has_shifted, has_turned = distance > _LENGTH_TOLERANCE, angle > _ANGLE_TOLERANCE
        if has_shifted or has_turned:
            yield Moved(name, distance if has_shifted else 0.0, angle if has_turned else 0.0)


def _angle_between(old: RigidPose, new: RigidPose) -> float:
    """Return the angle of the rotation between two poses, exact near zero too."""
    back = old._replace(rotation=transposed(old.rotation))
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = back.then(new).rotation
    return atan2(hypot(zy - yz, xz - zx, yx - xy), xx + yy + zz - 1.0)


def _masses(old: Skeleton, new: Skeleton, new_name: Mapping[str, str]) -> Iterator[MassChange]:
    index = {name: i for i, name in enumerate(new.body_names)}
    old_poses, new_poses = old.zero_poses(), new.zero_poses()
    for i, name in enumerate(old.body_names):
        now = new_name.get(name, name)
        if now not in index or (i == 0 and not (old.is_floating or new.is_floating)):
            continue
        j = index[now]
        change = _mass_change(now, (old.masses[i], new.masses[j]), (old_poses[i], new_poses[j]))
        if not _is_same_mass(change):
            yield change


def _mass_change(
    name: str,
    bodies: tuple[MassDistribution, MassDistribution],
    poses: tuple[RigidPose, RigidPose],
) -> MassChange:
    """Return the change; where a link's frame lies in the link is a convention."""
    old, new = bodies
    in_base = [seen_from(body, pose) for body, pose in zip(bodies, poses, strict=True)]
    moved = min(dist(old.com, new.com), dist(in_base[0].com, in_base[1].com))
    return MassChange(
        name,
        (old.mass, new.mass),
        moved if moved > _LENGTH_TOLERANCE else 0.0,
        (principal_moments_about_com(old), principal_moments_about_com(new)),
        min(_inertia_change(*bodies), _inertia_change(*in_base)),
    )


def _inertia_change(one: MassDistribution, other: MassDistribution) -> float:
    old, new = shifted(one, -1.0).moments, shifted(other, -1.0).moments
    scale = max(_norm(old), _norm(new))
    change = [b - a for a, b in zip(old, new, strict=True)]
    return _norm(change) / scale if scale > 0.0 else 0.0


def _norm(tensor: Sequence[float]) -> float:
    """Return the root of the sum of the squares of all nine entries."""
    xx, yy, zz, *products = tensor
    return hypot(xx, yy, zz, *products, *products)


def _is_same_mass(change: MassChange) -> bool:
    moments = zip(*change.principal_moments, strict=True)
    return (
        _is_close(*change.mass)
        and change.com_distance == 0.0
        and all(abs(a - b) <= _RELATIVE_TOLERANCE * max(abs(a), abs(b), 1e-6) for a, b in moments)
        and change.inertia_change <= _TENSOR_TOLERANCE
    )


def _base_kind(skeleton: Skeleton) -> str:
    return "floating" if skeleton.is_floating else "fixed"


def _total_mass(skeleton: Skeleton) -> float:
    return fsum(body.mass for body in skeleton.masses[0 if skeleton.is_floating else 1 :])


def _reach(skeleton: Skeleton) -> float:
    ways = [0.0]
    for parent, placement in zip(skeleton.parents, skeleton.placements, strict=True):
        ways.append(ways[parent] + hypot(*placement.translation))
    ends = (ways[frame.body] + hypot(*frame.pose.translation) for frame in skeleton.frames)
    return max((*ways, *ends))
