"""Two robots of any files: what moves where and what weighs what, apart from conventions."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from math import acos, hypot
from typing import NamedTuple

from kindsl.language.text.nearest import hint, nearest_name
from kindsl.language.text.phrases import counted
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.comparison.alignment import Alignment, aligned, base_frames, likely_base_frames
from kindsl.robots.comparison.conventions import conventions
from kindsl.robots.comparison.matching import MatchedJoints, matched, matching_frames
from kindsl.robots.comparison.number_differences import (
    NumberDifference,
    Tolerances,
    frame_differences,
    inertia_differences,
    joint_differences,
)
from kindsl.robots.comparison.turned_axes import axis_differences, described_with_axis
from kindsl.robots.comparison.twins import TwinFile
from kindsl.robots.comparison.written import Described, written_frame
from kindsl.robots.mechanism.skeleton import Skeleton

# Of gravity beside ours, radians: as much as the digits of an angle allow.
_TILT = 3e-4
_FAR = 2.0
# So few differences are no base frame elsewhere, which moves all.
_FEW = 1
_MOST_AXES = 6
# Numbers explain a difference better than another direction of gravity.
_OF_STRUCTURE = 10


@dataclass(frozen=True, slots=True)
class MechanicalComparison:
    """The result of comparing the mechanics of two robots.

    Attributes:
        matching: Which joints match.
        alignment: The conventions of the other beside ours.
        numbers: The numbers that differ.
        structure: Other differences, one sentence each: joints without a match, other kinds.
        conventions: Differences without any meaning for the mechanics, one sentence each.
    """

    matching: MatchedJoints
    alignment: Alignment
    numbers: tuple[NumberDifference, ...]
    structure: tuple[str, ...]
    conventions: tuple[str, ...]

    @property
    def is_equal(self) -> bool:
        """True if the mechanics are equal within the digits written."""
        return not self.numbers and not self.structure


class ComparedTwin(NamedTuple):
    """A twin, and what it says otherwise.

    Attributes:
        twin: The file.
        is_generated: Whether it is a folder of generated code.
        found: The comparison.
    """

    twin: TwinFile
    is_generated: bool
    found: MechanicalComparison


def compared_mechanics(
    ours: Described,
    theirs: Described,
    joints: Mapping[str, str] | None = None,
    tolerance: float = 0.0,
) -> MechanicalComparison:
    """Compare two robots.

    Args:
        ours: A robot.
        theirs: Another, or the same in another file.
        joints: Names of the other's joints by ours, where they do not tell.
        tolerance: Relative, of what counts as equal besides what the digits leave open.
    """
    one, other = ours.skeleton, theirs.skeleton
    given = joints or {}
    wrong = tuple(unknown_joints(ours, theirs, given))
    named = {a: b for a, b in given.items() if a in one.joint_names and b in other.joint_names}
    matching = matched(one, other, named, lambda: base_frames(one, other))
    bounds = Tolerances(_size(one), tolerance)
    tried: list[MechanicalComparison] = []
    for root in likely_base_frames(one, other, matching):
        tried.append(_under(ours, theirs, matching, bounds, root))
        if _n_differences(tried[-1]) <= _FEW:
            break
    found = min(tried, key=_n_differences)
    if found.numbers:
        # The choice between frames may have been led astray by digits, which cost time to heed.
        root = found.alignment.frames[0]
        again = _under(ours, theirs, matching, bounds, root, is_rough=False)
        found = min(found, again, key=_n_differences)
    found = _with_axes_told(ours, theirs, bounds, found)
    return replace(found, structure=(*wrong, *found.structure))


def unknown_joints(ours: Described, theirs: Described, joints: Mapping[str, str]) -> Iterator[str]:
    """Yield which names of a map of joints no joint has, one sentence each."""
    sides = (ours, joints, "here"), (theirs, joints.values(), f"in {theirs.label}")
    for side, names, where in sides:
        known = side.skeleton.joint_names
        for name in names:
            if name not in known:
                yield f"there is no joint '{name}' {where}{hint(nearest_name(name, known), ',')}"


def _with_axes_told(
    ours: Described, theirs: Described, bounds: Tolerances, found: MechanicalComparison
) -> MechanicalComparison:
    """Tell axes that are turned as such, where that says what many numbers say."""
    told: list[NumberDifference] = []
    bodies = sorted({each.body for each in found.numbers if each.body})[:_MOST_AXES]
    for body in bodies:
        if _n_differences(found) <= _FEW:
            break
        matching, its = found.matching, found.matching.theirs[body]
        for axis, turn in axis_differences(ours, theirs, matching, found.alignment, body):
            other = described_with_axis(theirs, its, turn)
            again = _under(ours, other, matching, bounds, found.alignment.frames[0])
            if _n_differences(again) + 1 < _n_differences(found):
                frames = again.alignment.frames
                frames[body] = frames[body].then(turn.inverse())
                theirs, found = other, again
                told.append(axis)
                break
    return replace(found, numbers=(*told, *found.numbers))


def _under(
    ours: Described,
    theirs: Described,
    matching: MatchedJoints,
    bounds: Tolerances,
    root: RigidPose,
    is_rough: bool = True,
) -> MechanicalComparison:
    """Compare with the other's base at a pose in ours, frames chosen roughly or by all digits."""
    of_choice = bounds._replace(is_rough=is_rough)

    def cost(body: int, tried: Alignment) -> int:
        return len(list(_body_numbers(ours, theirs, matching, tried, of_choice, body)))

    alignment = aligned(ours.skeleton, theirs.skeleton, matching, root, cost)
    structure = tuple(_structure(ours, theirs, matching, alignment))
    if not _is_one_robot(ours.skeleton, theirs.skeleton, matching):
        return MechanicalComparison(matching, alignment, (), structure[:1], ())
    numbers = tuple(_numbers(ours, theirs, matching, alignment, bounds))
    told = tuple(conventions(ours, theirs, matching, alignment))
    return MechanicalComparison(matching, alignment, numbers, structure, told)


def _n_differences(found: MechanicalComparison) -> int:
    return len(found.numbers) + _OF_STRUCTURE * len(found.structure)


def _is_one_robot(ours: Skeleton, theirs: Skeleton, matching: MatchedJoints) -> bool:
    return _FAR * matching.n_joints > max(ours.n_links, theirs.n_links)


def _size(skeleton: Skeleton) -> float:
    return max(hypot(*pose.translation) for pose in skeleton.zero_poses()) or 1.0


def _structure(
    ours: Described, theirs: Described, matching: MatchedJoints, alignment: Alignment
) -> Iterator[str]:
    one, other = ours.skeleton, theirs.skeleton
    if matching.only_ours or matching.only_theirs:
        yield _unmatched(ours, theirs, matching)
    for body, its in matching.theirs.items():
        if body and one.joint_kinds[body - 1] != other.joint_kinds[its - 1]:
            kinds = one.joint_kinds[body - 1], other.joint_kinds[its - 1]
            name = one.joint_names[body - 1]
            yield f"joint '{name}' is {kinds[0]} here and {kinds[1]} in {theirs.label}"
    for frame, same in matching_frames(one, other):
        if matching.theirs.get(frame.body, same.body) != same.body:
            here, there = one.body_names[frame.body], other.body_names[same.body]
            yield f"frame '{frame.name}' is on '{here}' here, on '{there}' in {theirs.label}"
    if any(ours.inertias) != any(theirs.inertias):
        where = f"in {theirs.label}" if any(ours.inertias) else "here"
        yield f"no link has an inertia {where}"
    if one.is_floating != other.is_floating:
        kind, its_kind = ("floating" if each.is_floating else "fixed" for each in (one, other))
        yield f"the base is {kind} here and {its_kind} in {theirs.label}"
    elif not one.is_floating:
        tilt = acos(max(-1.0, min(1.0, alignment.frames[0].rotation[2][2])))
        if tilt > _TILT:
            yield f"gravity acts {tilt:.4g} rad apart: the fixed base of {theirs.label} is tilted"


def _unmatched(ours: Described, theirs: Described, matching: MatchedJoints) -> str:
    numbers = (counted(each.skeleton.n_links, "joint") for each in (ours, theirs))
    here, there = numbers
    match = "1 joint matches" if matching.n_joints == 1 else f"{matching.n_joints} joints match"
    told = f"{match}: {here} here, {there} in {theirs.label}"
    rest = [f"'{name}' only here" for name in matching.only_ours[:3]]
    rest += [f"'{name}' only there" for name in matching.only_theirs[:3]]
    return f"{told}; {', '.join(rest)}"


def _numbers(
    ours: Described,
    theirs: Described,
    matching: MatchedJoints,
    alignment: Alignment,
    bounds: Tolerances,
) -> Iterator[NumberDifference]:
    for body in sorted(matching.theirs):
        yield from _body_numbers(ours, theirs, matching, alignment, bounds, body)
    yield from _frames(ours, theirs, matching, alignment, bounds)


def _body_numbers(
    ours: Described,
    theirs: Described,
    matching: MatchedJoints,
    alignment: Alignment,
    bounds: Tolerances,
    body: int,
) -> Iterator[NumberDifference]:
    """Yield the differences of a body's mass, and of the joint that carries it."""
    one, other, its = ours.skeleton, theirs.skeleton, matching.theirs[body]
    joint = one.joint_names[body - 1] if body else ""
    if {one.body_names[body], joint} & (ours.unknown | theirs.unknown):
        return
    if body and one.joint_kinds[body - 1] == other.joint_kinds[its - 1]:
        yield from joint_differences(ours, theirs, body, its, alignment, bounds)
    is_heavy = any(ours.inertias) and any(theirs.inertias)
    if is_heavy and (body or (one.is_floating and other.is_floating)):
        yield from inertia_differences(ours, theirs, body, its, alignment, bounds)


def _frames(
    ours: Described,
    theirs: Described,
    matching: MatchedJoints,
    alignment: Alignment,
    bounds: Tolerances,
) -> Iterator[NumberDifference]:
    """Yield the differences of frames that both have; where links with a mass are is a convention.

    It is none where one side has the frame of that name alone, whose place it means.
    """
    for frame, other in matching_frames(ours.skeleton, theirs.skeleton):
        is_heavy = frame.name in ours.heavy_frames and other.name in theirs.heavy_frames
        if is_heavy or matching.theirs.get(frame.body) != other.body:
            continue
        written = ours.frames.get(frame.name) or written_frame(frame.name, frame.pose)
        pose = alignment.frames[frame.body].then(other.pose)
        yield from frame_differences(written, theirs.frames.get(other.name), pose, bounds)
