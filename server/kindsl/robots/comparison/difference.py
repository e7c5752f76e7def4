"""Mechanical changes between two versions of a robot, matched by name, each frame as written."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, fields
from math import dist, fsum, hypot

from kindsl.mechanics.rigid.body import principal_moments_about_com, seen_from, shifted
from kindsl.mechanics.rigid.pose import RigidPose, angle_between
from kindsl.robots.comparison.matching import bodies_by_name
from kindsl.robots.mechanism.linkage import Linkage

# Rounding of numbers that were computed, beside them: metres, radians, masses.
_ROUNDING = 1e-9
# Of a tensor about the CoM, which is a difference of two that may be larger.
_TENSOR_ROUNDING = 1e-6


@dataclass(frozen=True, slots=True)
class Renamed:
    """A link with another name."""

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
    """The pose of a joint or frame changed: by how many metres, by how many radians."""

    name: str
    distance: float
    angle: float


@dataclass(frozen=True, slots=True)
class JointKindChange:
    """A joint became prismatic or revolute."""

    joint: str
    old: str
    new: str


@dataclass(frozen=True, slots=True)
class MassChange:
    """Mass properties changed.

    Attributes:
        link: The link's name.
        mass: Old and new mass, kg.
        com_distance: Between the old and the new centre of mass, metres: in the link's frame or,
            if that is less because the frame was turned or put elsewhere, in the base's at zero.
        principal_moments: Old and new principal moments about the centre of mass, ascending,
            kg m^2.
        inertia_change: Norm of the change of the tensor about the centre of mass, over the greater
            of the old and the new norm; the lesser of both frames, too.
    """

    link: str
    mass: tuple[float, float]
    com_distance: float
    principal_moments: tuple[tuple[float, ...], tuple[float, ...]]
    inertia_change: float


@dataclass(frozen=True, slots=True)
class Difference:
    """The changes from an old to a new robot, those of links under their new names.

    Attributes:
        joint_frames: Joint frames that moved in their predecessor's frame.
        frames: Frames that moved in their link's frame.
        zero_poses: Links and frames that moved in the base's frame at zero.
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
        """True if nothing changed, names included."""
        totals = self.total_mass, self.reach
        lists = (getattr(self, field.name) for field in fields(self)[:-3])
        is_same_base = self.base_kind[0] == self.base_kind[1]
        return is_same_base and not any(lists) and all(_is_close(a, b) for a, b in totals)


def difference(old: Linkage, new: Linkage) -> Difference:
    """Return the changes from `old` to `new`."""
    bodies = bodies_by_name(old, new)
    pairs = [(old.body_names[i], new.body_names[j]) for i, j in bodies.items()]
    matched, kept = (set(names) for names in zip(*pairs, strict=True))
    joints, new_joints = _joint_frames(old), _joint_frames(new)
    frames, new_frames = _frames(old), _frames(new)
    renamed = dict(pairs)
    at_zero = {renamed.get(name, name): pose for name, pose in _zero_poses(old).items()}
    return Difference(
        added_links=_without(new.body_names, kept),
        removed_links=_without(old.body_names, matched),
        renamed_links=tuple(Renamed(a, b) for a, b in pairs if a != b),
        reparented=tuple(_reparented(old, new, bodies)),
        added_joints=_without(new_joints, joints),
        removed_joints=_without(joints, new_joints),
        joint_kinds=tuple(_joint_kinds(old, new)),
        added_frames=_without(new_frames, frames),
        removed_frames=_without(frames, new_frames),
        joint_frames=tuple(_moved(joints, new_joints)),
        frames=tuple(_moved(frames, new_frames)),
        zero_poses=tuple(_moved(at_zero, _zero_poses(new))),
        masses=tuple(_masses(old, new, bodies)),
        base_kind=(_base_kind(old), _base_kind(new)),
        total_mass=(_total_mass(old), _total_mass(new)),
        reach=(_reach(old), _reach(new)),
    )


def _is_close(a: float, b: float, least: float = 0.0) -> bool:
    return abs(a - b) <= _ROUNDING * max(abs(a), abs(b), least)


def _without(names: Iterable[str], known: Iterable[str]) -> tuple[str, ...]:
    others = set(known)
    return tuple(name for name in names if name not in others)


def _reparented(old: Linkage, new: Linkage, bodies: Mapping[int, int]) -> Iterator[Reparented]:
    for body, its in bodies.items():
        if body and bodies.get(old.parents[body - 1]) != new.parents[its - 1]:
            before, after = old.parents[body - 1], new.parents[its - 1]
            yield Reparented(new.body_names[its], old.body_names[before], new.body_names[after])


def _joint_kinds(old: Linkage, new: Linkage) -> Iterator[JointKindChange]:
    kinds = dict(zip(new.joint_names, new.joint_kinds, strict=True))
    for name, kind in zip(old.joint_names, old.joint_kinds, strict=True):
        if kinds.get(name, kind) != kind:
            yield JointKindChange(name, kind, kinds[name])


def _joint_frames(skeleton: Linkage) -> dict[str, RigidPose]:
    return dict(zip(skeleton.joint_names, skeleton.placements, strict=True))


def _frames(skeleton: Linkage) -> dict[str, RigidPose]:
    return {frame.name: frame.pose for frame in skeleton.frames}


def _zero_poses(skeleton: Linkage) -> dict[str, RigidPose]:
    poses = skeleton.zero_poses
    of_frames = {frame.name: poses[frame.body].then(frame.pose) for frame in skeleton.frames}
    return {**dict(zip(skeleton.link_names, poses[1:], strict=True)), **of_frames}


def _moved(old: Mapping[str, RigidPose], new: Mapping[str, RigidPose]) -> Iterator[Moved]:
    for name in (name for name in old if name in new):
        distance = _unless_rounding(dist(old[name].translation, new[name].translation))
        angle = _unless_rounding(angle_between(old[name], new[name]))
        if distance or angle:
            yield Moved(name, distance, angle)


def _unless_rounding(value: float) -> float:
    return value if value > _ROUNDING else 0.0


def _masses(old: Linkage, new: Linkage, bodies: Mapping[int, int]) -> Iterator[MassChange]:
    moving = bodies if old.is_floating or new.is_floating else [i for i in bodies if i]
    poses = old.zero_poses, new.zero_poses
    for body in moving:
        pair = old.masses[body], new.masses[bodies[body]]
        # Where a link's frame lies in the link is a convention.
        seen = seen_from(pair[0], poses[0][body]), seen_from(pair[1], poses[1][bodies[body]])
        tensors = [[shifted(each, -1.0).moments for each in one] for one in (pair, seen)]
        change = MassChange(
            new.body_names[bodies[body]],
            (pair[0].mass, pair[1].mass),
            _unless_rounding(min(dist(a.com, b.com) for a, b in (pair, seen))),
            (principal_moments_about_com(pair[0]), principal_moments_about_com(pair[1])),
            min(_tensor_change(a, b) for a, b in tensors),
        )
        if not _is_rounding(change):
            yield change


def _tensor_change(old: Iterable[float], new: Iterable[float]) -> float:
    one, other = list(old), list(new)
    scale = max(_norm(one), _norm(other))
    return _norm([b - a for a, b in zip(one, other, strict=True)]) / scale if scale else 0.0


def _norm(tensor: list[float]) -> float:
    return hypot(*tensor, *tensor[3:])


def _is_rounding(change: MassChange) -> bool:
    return (
        _is_close(*change.mass)
        and not change.com_distance
        and all(_is_close(*pair, 1e-6) for pair in zip(*change.principal_moments, strict=True))
        and change.inertia_change <= _TENSOR_ROUNDING
    )


def _base_kind(skeleton: Linkage) -> str:
    return "floating" if skeleton.is_floating else "fixed"


def _total_mass(skeleton: Linkage) -> float:
    return fsum(body.mass for body in skeleton.masses[0 if skeleton.is_floating else 1 :])


def _reach(skeleton: Linkage) -> float:
    ways = [0.0]
    for parent, placement in zip(skeleton.parents, skeleton.placements, strict=True):
        ways.append(ways[parent] + hypot(*placement.translation))
    ends = (ways[frame.body] + hypot(*frame.pose.translation) for frame in skeleton.frames)
    return max((*ways, *ends))
