"""What changed mechanically between two mechanisms."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from kindsl.dynamics.bodies import Bodies
from kindsl.dynamics.evaluation.mechanics import Mechanics
from kindsl.spatial.arrays import Array
from kindsl.spatial.inertia import point_inertia

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
    """A link that another one carries now."""

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
        com_distance: Between the old and the new centre of mass in the link frame, metres.
        principal_moments: Old and new principal moments about the centre of mass, ascending,
            kg m^2.
        inertia_change: Norm of the change of the tensor about the centre of mass, over the norm of
            the old one or the new one, whichever is greater.
    """

    link: str
    mass: tuple[float, float]
    com_distance: float
    principal_moments: tuple[tuple[float, ...], tuple[float, ...]]
    inertia_change: float


@dataclass(frozen=True, slots=True)
class Difference:
    """What changed from an old to a new mechanism; joint frames move in their predecessors.

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
        """Whether nothing changed that mechanics would notice, names included."""
        old_new = self.base_kind, self.total_mass, self.reach
        lists = (
            *(self.added_links, self.removed_links, self.renamed_links, self.reparented),
            *(self.added_joints, self.removed_joints, self.joint_kinds),
            *(self.added_frames, self.removed_frames, self.joint_frames, self.frames),
            *(self.zero_poses, self.masses),
        )
        return not any(lists) and all(_is_close(a, b) for a, b in old_new)


def difference(old: Bodies, new: Bodies) -> Difference:
    """Return what changed from `old` to `new`; links, joints and frames are matched by name."""
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


def _only_in(bodies: Bodies, other: Bodies) -> tuple[str, ...]:
    return _missing(_body_names(bodies), _body_names(other))


def _body_names(bodies: Bodies) -> tuple[str, ...]:
    return bodies.base_name, *bodies.link_names


def _renamed(old: Bodies, new: Bodies) -> Iterator[Renamed]:
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


def _joint_of(bodies: Bodies, link: str) -> str:
    return bodies.joint_names[bodies.link_names.index(link)]


def _is_same_body(old: Bodies, old_link: str, new: Bodies, new_link: str) -> bool:
    i, j = old.link_names.index(old_link), new.link_names.index(new_link)
    return bool(
        old.masses[i + 1] == new.masses[j + 1] != 0.0
        and np.array_equal(old.coms[i + 1], new.coms[j + 1])
        and np.array_equal(old.inertias[i + 1], new.inertias[j + 1])
        and np.array_equal(old.p_r_j[i], new.p_r_j[j])
        and np.array_equal(old.p_R_j[i], new.p_R_j[j])
    )


def _reparented(old: Bodies, new: Bodies, new_name: Mapping[str, str]) -> Iterator[Reparented]:
    parents = dict(zip(new.link_names, new.parents, strict=True))
    for name, parent in zip(old.link_names, old.parents, strict=True):
        now = new_name.get(name, name)
        if now in parents:
            before, after = _body_names(old)[parent], _body_names(new)[parents[now]]
            if new_name.get(before, before) != after:
                yield Reparented(now, before, after)


def _joint_kinds(old: Bodies, new: Bodies) -> Iterator[JointKindChange]:
    kinds = dict(zip(new.joint_names, new.joint_kinds, strict=True))
    for name, kind in zip(old.joint_names, old.joint_kinds, strict=True):
        if name in kinds and kinds[name] != kind:
            yield JointKindChange(name, kind, kinds[name])


def _frame_names(bodies: Bodies) -> tuple[str, ...]:
    return tuple(frame.name for frame in bodies.frames)


def _joint_frames(bodies: Bodies) -> dict[str, tuple[Array, Array]]:
    poses = zip(bodies.joint_names, bodies.p_R_j, bodies.p_r_j, strict=True)
    return {name: (R, r) for name, R, r in poses}


def _frames(bodies: Bodies) -> dict[str, tuple[Array, Array]]:
    return {frame.name: (frame.body_R_frame, frame.body_r_frame) for frame in bodies.frames}


def _zero_poses(bodies: Bodies) -> dict[str, tuple[Array, Array]]:
    poses = Mechanics(bodies).forward_kinematics(np.zeros(bodies.n_links))
    return {name: (T[:3, :3], T[:3, 3]) for name, T in poses.items()}


def _renamed_keys(
    poses: dict[str, tuple[Array, Array]], new_name: Mapping[str, str]
) -> dict[str, tuple[Array, Array]]:
    return {new_name.get(name, name): pose for name, pose in poses.items()}


def _moved(
    old: Mapping[str, tuple[Array, Array]], new: Mapping[str, tuple[Array, Array]]
) -> Iterator[Moved]:
    for name, (R_old, r_old) in old.items():
        if name not in new:
            continue
        R_new, r_new = new[name]
        distance = float(np.linalg.norm(r_new - r_old))
        angle = _angle(R_old.T @ R_new)
        if distance > _LENGTH_TOLERANCE or angle > _ANGLE_TOLERANCE:
            yield Moved(name, distance, angle)


def _angle(R: Array) -> float:
    """Return the angle of a rotation, exact near zero too."""
    axis = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return float(np.arctan2(np.linalg.norm(axis), np.trace(R) - 1.0))


def _masses(old: Bodies, new: Bodies, new_name: Mapping[str, str]) -> Iterator[MassChange]:
    index = {name: i for i, name in enumerate(_body_names(new))}
    for i, name in enumerate(_body_names(old)):
        now = new_name.get(name, name)
        if now not in index or (i == 0 and not (old.is_floating or new.is_floating)):
            continue
        change = _mass_change(now, old, i, new, index[now])
        if not _is_same_mass(change):
            yield change


def _mass_change(name: str, old: Bodies, i: int, new: Bodies, j: int) -> MassChange:
    return MassChange(
        name,
        (float(old.masses[i]), float(new.masses[j])),
        float(np.linalg.norm(new.coms[j] - old.coms[i])),
        (_principal_moments(old, i), _principal_moments(new, j)),
        _inertia_change(_about_com(old, i), _about_com(new, j)),
    )


def _inertia_change(old: Array, new: Array) -> float:
    scale = max(np.linalg.norm(old), np.linalg.norm(new))
    return float(np.linalg.norm(new - old) / scale) if scale > 0.0 else 0.0


def _is_same_mass(change: MassChange) -> bool:
    moments = zip(*change.principal_moments, strict=True)
    return (
        _is_close(*change.mass)
        and change.com_distance <= _LENGTH_TOLERANCE
        and all(abs(a - b) <= _RELATIVE_TOLERANCE * max(abs(a), abs(b), 1e-6) for a, b in moments)
        and change.inertia_change <= _TENSOR_TOLERANCE
    )


def _principal_moments(bodies: Bodies, body: int) -> tuple[float, ...]:
    return tuple(float(moment) for moment in np.linalg.eigvalsh(_about_com(bodies, body)))


def _about_com(bodies: Bodies, body: int) -> Array:
    at_com = point_inertia(bodies.masses[body], bodies.coms[body])
    return np.asarray(bodies.inertias[body] - at_com)


def _base_kind(bodies: Bodies) -> str:
    return "floating" if bodies.is_floating else "fixed"


def _total_mass(bodies: Bodies) -> float:
    return float(bodies.masses[0 if bodies.is_floating else 1 :].sum())


def _reach(bodies: Bodies) -> float:
    ways = [0.0]
    for i, parent in enumerate(bodies.parents):
        ways.append(ways[parent] + float(np.linalg.norm(bodies.p_r_j[i])))
    ends = (ways[f.body] + float(np.linalg.norm(f.body_r_frame)) for f in bodies.frames)
    return max((*ways, *ends))
