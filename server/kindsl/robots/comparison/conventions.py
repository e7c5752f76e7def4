"""Differences of two robots without any meaning for the mechanics, one sentence each."""

from collections.abc import Iterator
from math import degrees, hypot

from kindsl.language.text.phrases import counted, listed
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.comparison.alignment import Alignment
from kindsl.robots.comparison.limits import other_limits
from kindsl.robots.comparison.matching import MatchedJoints, writable
from kindsl.robots.comparison.written import Described

_NOTHING = 3e-4
_SHOWN = 5


def conventions(
    ours: Described, theirs: Described, matching: MatchedJoints, alignment: Alignment
) -> Iterator[str]:
    """Yield names, order, zeros, directions and limits of joints, link frames, other frames."""
    yield from _names(ours, theirs, matching)
    yield from _joints(ours, theirs, alignment)
    yield from _frames(ours, theirs, alignment)
    yield from other_limits(ours, theirs, matching, alignment)
    frames = ours.skeleton.frames, theirs.skeleton.frames
    one, other = ({writable(frame.name) for frame in each} for each in frames)
    for side, known, where in ((ours, other, "here"), (theirs, one, f"in {theirs.label}")):
        only = sorted(name for name in _own_frames(side) if writable(name) not in known)
        if only:
            yield f"{counted(len(only), 'frame')} only {where}: {_some(only)}"


def _own_frames(side: Described) -> set[str]:
    """Return the frames that are not their link's: nothing else than links is called so."""
    return {frame.name for frame in side.skeleton.frames if _is_elsewhere(frame.pose)}


def _names(ours: Described, theirs: Described, matching: MatchedJoints) -> Iterator[str]:
    one, other = ours.skeleton, theirs.skeleton
    pairs = [(body, its) for body, its in sorted(matching.theirs.items()) if body]
    for what, mine, its_names in (
        ("joint", one.joint_names, other.joint_names),
        ("link", one.link_names, other.link_names),
    ):
        named = [(mine[a - 1], its_names[b - 1]) for a, b in pairs]
        renamed = [f"'{a}' is '{b}'" for a, b in named if writable(a) != writable(b)]
        if renamed:
            number = counted(len(renamed), what)
            some = ", ".join(renamed[:_SHOWN]) + (", ..." if renamed[_SHOWN:] else "")
            yield f"{number} of another name in {theirs.label}: {some}"
    order = [its for _, its in pairs]
    if order != sorted(order):
        yield f"the joints of {theirs.label} are in another order"


def _joints(ours: Described, theirs: Described, alignment: Alignment) -> Iterator[str]:
    names, kinds = ours.skeleton.joint_names, ours.skeleton.joint_kinds
    flipped = [names[body - 1] for body, joint in alignment.joints.items() if joint.sign < 0.0]
    if flipped:
        number = counted(len(flipped), "joint")
        yield f"{number} of the other sign in {theirs.label}: {_some(flipped)}"
    for body, joint in alignment.joints.items():
        if joint.offset:
            slides = kinds[body - 1] == "prismatic"
            value = f"{joint.offset:.6g} m" if slides else f"{degrees(joint.offset):.6g}°"
            yield f"joint '{names[body - 1]}' is at {value} where it is zero in {theirs.label}"


def _frames(ours: Described, theirs: Described, alignment: Alignment) -> Iterator[str]:
    names = ours.skeleton.body_names
    moved = [names[body] for body, pose in alignment.frames.items() if _is_elsewhere(pose)]
    if moved:
        number = counted(len(moved), "link frame")
        yield f"{number} elsewhere in {theirs.label}: {_some(moved)}"


def _is_elsewhere(pose: RigidPose) -> bool:
    trace = pose.rotation[0][0] + pose.rotation[1][1] + pose.rotation[2][2]
    return trace < 3.0 - _NOTHING**2 or hypot(*pose.translation) > _NOTHING


def _some(names: list[str]) -> str:
    shown = [f"'{name}'" for name in names[:_SHOWN]]
    return ", ".join((*shown, "...")) if names[_SHOWN:] else listed(shown)
