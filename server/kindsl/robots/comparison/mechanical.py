"""Two robots of any files: what moves where and what weighs what, apart from conventions."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import acos
from typing import NamedTuple

from kindsl.language.text.nearest import hint, nearest_name
from kindsl.language.text.phrases import counted
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.comparison.alignment import (
    Alignment,
    aligned,
    as_written,
    base_frames,
    likely_base_frames,
    size_of,
)
from kindsl.robots.comparison.conventions import conventions, rounded_numbers
from kindsl.robots.comparison.matching import MatchedJoints, matched, matching_frames
from kindsl.robots.comparison.number_differences import (
    NumberDifference,
    Tolerances,
    frame_differences,
    inertia_differences,
    joint_differences,
)
from kindsl.robots.comparison.rounding import digits_of_rounding, is_rounded
from kindsl.robots.comparison.side import ComparedSide, Pair
from kindsl.robots.comparison.turned_axes import axis_differences, described_with_axis
from kindsl.robots.comparison.twins import TwinFile
from kindsl.robots.comparison.written import written_frame

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
        conventions: Differences that do not affect the mechanics, one sentence each.
        rounded: Numbers that one file has with fewer digits, which are conventions, too.
    """

    matching: MatchedJoints
    alignment: Alignment
    numbers: tuple[NumberDifference, ...]
    structure: tuple[str, ...]
    conventions: tuple[str, ...]
    rounded: tuple[NumberDifference, ...] = ()

    @property
    def is_equal(self) -> bool:
        """True if the mechanics are equal within the digits written."""
        return not self.numbers and not self.structure


class ComparedTwin(NamedTuple):
    """A twin and its differences.

    Attributes:
        twin: The file.
        is_generated: Whether it is a folder of generated code.
        found: The comparison.
    """

    twin: TwinFile
    is_generated: bool
    found: MechanicalComparison


def compared_mechanics(
    ours: ComparedSide,
    theirs: ComparedSide,
    joints: Mapping[str, str] | None = None,
    tolerance: float = 0.0,
) -> MechanicalComparison:
    """Compare two robots.

    Args:
        ours: A robot.
        theirs: Another, or the same in another file.
        joints: Names of the other's joints by ours, where neither names nor axes show them.
        tolerance: Relative, of what counts as equal besides what the digits leave open.
    """
    one, other = ours.skeleton, theirs.skeleton
    given = joints or {}
    wrong = tuple(unknown_joints(ours, theirs, given))
    named = {a: b for a, b in given.items() if a in one.joint_names and b in other.joint_names}
    matching = matched(one, other, named, lambda: base_frames(one, other))
    bounds = Tolerances(size_of(one), tolerance)
    rough = bounds._replace(is_rough=True)
    loose = bounds._replace(digits=digits_of_rounding(ours, theirs, matching.theirs))
    has_rounded = loose.digits is not None and not wrong
    if has_rounded:
        same = Pair(ours, theirs, matching, as_written(matching))
        if found_same := _under_rounding(same, bounds, loose):
            return found_same
    tried: list[MechanicalComparison] = []
    for root in likely_base_frames(one, other, matching):
        tried.append(_under(_aligned(ours, theirs, matching, root, rough), bounds))
        if _n_differences(tried[-1]) <= _FEW:
            break
    found = min(tried, key=_n_differences)
    if found.numbers:
        # The choice between frames may have been led astray by digits, which cost time to heed.
        root = found.alignment.frames[0]
        again = _under(_aligned(ours, theirs, matching, root, bounds), bounds)
        # A frame chosen for one body's sake may put others elsewhere.
        written = _under(Pair(ours, theirs, matching, as_written(matching)), bounds)
        found = min(found, again, written, key=lambda f: (_n_differences(f), len(f.conventions)))
    if has_rounded and found.numbers:
        aligned_pair = _aligned(ours, theirs, matching, found.alignment.frames[0], loose)
        found = _under_rounding(aligned_pair, bounds, loose) or found
    found = _with_turned_axes(ours, theirs, bounds, found)
    return replace(found, structure=(*wrong, *found.structure))


def unknown_joints(
    ours: ComparedSide, theirs: ComparedSide, joints: Mapping[str, str]
) -> Iterator[str]:
    """Yield the names in a map of joints that no joint has, one sentence each."""
    sides = (ours, joints, "here"), (theirs, joints.values(), f"in {theirs.label}")
    for side, names, where in sides:
        known = side.skeleton.joint_names
        for name in names:
            if name not in known:
                yield f"there is no joint '{name}' {where}{hint(nearest_name(name, known), ',')}"


def _under_rounding(
    pair: Pair, bounds: Tolerances, loose: Tolerances
) -> MechanicalComparison | None:
    """Compare two robots whose numbers differ by rounding only; None if more differs."""
    found = _under(pair, loose)
    if not found.is_equal:
        return None
    strict = _under(pair, bounds)
    rounded = (*strict.numbers, *strict.rounded)
    only = (*found.conventions, *_told_digits(pair, rounded))
    return replace(found, conventions=only, rounded=rounded)


def _with_turned_axes(
    ours: ComparedSide, theirs: ComparedSide, bounds: Tolerances, found: MechanicalComparison
) -> MechanicalComparison:
    """Replace many numbers by one axis where turning it explains them."""
    axes: list[NumberDifference] = []
    rough = bounds._replace(is_rough=True)
    bodies = sorted({each.body for each in found.numbers if each.body})[:_MOST_AXES]
    for body in bodies:
        if _n_differences(found) <= _FEW:
            break
        matching, root = found.matching, found.alignment.frames[0]
        for axis, turn in axis_differences(Pair(ours, theirs, matching, found.alignment), body):
            other = described_with_axis(theirs, matching.theirs[body], turn)
            again = _under(_aligned(ours, other, matching, root, rough), bounds)
            if _n_differences(again) + 1 < _n_differences(found):
                frames = again.alignment.frames
                frames[body] = frames[body].then(turn.inverse())
                theirs, found = other, again
                axes.append(axis)
                break
    return replace(found, numbers=(*axes, *found.numbers))


def _aligned(
    ours: ComparedSide,
    theirs: ComparedSide,
    matching: MatchedJoints,
    root: RigidPose,
    bounds: Tolerances,
) -> Pair:
    """Return both robots with the other's base at a pose in ours, frames chosen within bounds."""

    def cost(body: int, tried: Alignment) -> int:
        return len(list(_body_numbers(Pair(ours, theirs, matching, tried), bounds, body)))

    alignment = aligned(ours.skeleton, theirs.skeleton, matching, root, cost)
    return Pair(ours, theirs, matching, alignment)


def _under(pair: Pair, bounds: Tolerances) -> MechanicalComparison:
    matching, alignment = pair.matching, pair.alignment
    structure = tuple(_structure(pair))
    if not _is_one_robot(pair):
        return MechanicalComparison(matching, alignment, (), structure[:1], ())
    found = list(_numbers(pair, bounds))
    rounded = tuple(
        number
        for number in found
        if is_rounded(number.here_number, number.there_number, number.unit)
    )
    numbers = tuple(number for number in found if number not in rounded)
    only = (*conventions(pair), *_told_digits(pair, rounded))
    return MechanicalComparison(matching, alignment, numbers, structure, only, rounded)


def _told_digits(pair: Pair, rounded: Sequence[NumberDifference]) -> Iterator[str]:
    names = [f"{number.quantity} of '{number.owner}'" for number in rounded]
    return rounded_numbers(names, f" in {pair.theirs.label}")


def _n_differences(found: MechanicalComparison) -> int:
    return len(found.numbers) + _OF_STRUCTURE * len(found.structure)


def _is_one_robot(pair: Pair) -> bool:
    most = max(pair.ours.skeleton.n_links, pair.theirs.skeleton.n_links)
    return not most or _FAR * pair.matching.n_joints > most


def _structure(pair: Pair) -> Iterator[str]:
    ours, theirs, matching, alignment = pair
    one, other = ours.skeleton, theirs.skeleton
    if matching.only_ours or matching.only_theirs:
        yield _unmatched(pair)
    for body, its in pair.joints:
        kinds = one.joint_kinds[body - 1], other.joint_kinds[its - 1]
        if kinds[0] != kinds[1]:
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


def _unmatched(pair: Pair) -> str:
    matching, label = pair.matching, pair.theirs.label
    here, there = (counted(each.skeleton.n_links, "joint") for each in (pair.ours, pair.theirs))
    match = "1 joint matches" if matching.n_joints == 1 else f"{matching.n_joints} joints match"
    rest = [f"'{name}' only here" for name in matching.only_ours[:3]]
    rest += [f"'{name}' only there" for name in matching.only_theirs[:3]]
    return f"{match}: {here} here, {there} in {label}; {', '.join(rest)}"


def _numbers(pair: Pair, bounds: Tolerances) -> Iterator[NumberDifference]:
    for body in sorted(pair.matching.theirs):
        yield from _body_numbers(pair, bounds, body)
    yield from _frames(pair, bounds)


def _body_numbers(pair: Pair, bounds: Tolerances, body: int) -> Iterator[NumberDifference]:
    """Yield the differences of a body's mass, and of the joint that carries it."""
    ours, theirs = pair.ours, pair.theirs
    one, other, its = ours.skeleton, theirs.skeleton, pair.matching.theirs[body]
    joint = one.joint_names[body - 1] if body else ""
    if {one.body_names[body], joint} & (ours.unknown | theirs.unknown):
        return
    if body and one.joint_kinds[body - 1] == other.joint_kinds[its - 1]:
        yield from joint_differences(pair, body, bounds)
    is_heavy = any(ours.inertias) and any(theirs.inertias)
    if is_heavy and (body or (one.base_mass_counts and other.base_mass_counts)):
        yield from inertia_differences(pair, body, bounds)


def _frames(pair: Pair, bounds: Tolerances) -> Iterator[NumberDifference]:
    """Yield the differences of frames that both have; where links with a mass are is a convention.

    It is none where one side has the frame of that name alone, whose place it means.
    """
    ours, theirs = pair.ours, pair.theirs
    for frame, other in matching_frames(ours.skeleton, theirs.skeleton):
        is_heavy = frame.name in ours.heavy_frames and other.name in theirs.heavy_frames
        if is_heavy or pair.matching.theirs.get(frame.body) != other.body:
            continue
        written = ours.frames.get(frame.name) or written_frame(frame.name, frame.pose)
        pose = pair.alignment.frames[frame.body].then(other.pose)
        yield from frame_differences(written, theirs.frames.get(other.name), pose, bounds)
