"""Differences of two robots that do not affect the mechanics, one sentence each."""

from collections.abc import Iterator, Sequence
from math import degrees, hypot

from kindsl.language.semantics.parameters import UNTOLD, JointProperties
from kindsl.language.text.phrases import counted, listed
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.comparison.alignment import AlignedJoint
from kindsl.robots.comparison.matching import writable
from kindsl.robots.comparison.side import Pair

# Of a frame that is written with few digits, metres and radians.
_NOTHING = 3e-4
# Relative: few digits are written of a limit.
_SAME_LIMIT = 1e-4
_SHOWN = 5


def conventions(pair: Pair) -> Iterator[str]:
    """Yield names, order, zeros, directions and limits of joints, link frames, other frames."""
    ours, theirs = pair.ours, pair.theirs
    yield from _names(pair)
    yield from _joints(pair)
    yield from _link_frames(pair)
    yield from _limits(pair)
    frames = ours.skeleton.frames, theirs.skeleton.frames
    one, other = ({writable(frame.name) for frame in each} for each in frames)
    for side, known, where in ((ours, other, "here"), (theirs, one, f"in {theirs.label}")):
        own = {frame.name for frame in side.skeleton.frames if _is_elsewhere(frame.pose)}
        only = sorted(name for name in own if writable(name) not in known)
        yield from _count_of(only, "frame", f"only {where}")


def _names(pair: Pair) -> Iterator[str]:
    one, other, label = pair.ours.skeleton, pair.theirs.skeleton, pair.theirs.label
    for what, mine, its_names in (
        ("joint", one.joint_names, other.joint_names),
        ("link", one.link_names, other.link_names),
    ):
        named = [(mine[a - 1], its_names[b - 1]) for a, b in pair.joints]
        renamed = [f"'{a}' is '{b}'" for a, b in named if writable(a) != writable(b)]
        if renamed:
            number = counted(len(renamed), what)
            some = ", ".join(renamed[:_SHOWN]) + (", ..." if renamed[_SHOWN:] else "")
            yield f"{number} of another name in {label}: {some}"
    order = [its for _, its in pair.joints]
    if order != sorted(order):
        yield f"the joints of {label} are in another order"


def _joints(pair: Pair) -> Iterator[str]:
    names, kinds = pair.ours.skeleton.joint_names, pair.ours.skeleton.joint_kinds
    label, joints = pair.theirs.label, pair.alignment.joints
    flipped = [names[body - 1] for body, joint in joints.items() if joint.sign < 0.0]
    yield from _count_of(flipped, "joint", f"of the other sign in {label}")
    for body, joint in joints.items():
        if joint.offset:
            slides = kinds[body - 1] == "prismatic"
            value = f"{joint.offset:.6g} m" if slides else f"{degrees(joint.offset):.6g}°"
            yield f"joint '{names[body - 1]}' is at {value} where it is zero in {label}"


def _link_frames(pair: Pair) -> Iterator[str]:
    names, frames = pair.ours.skeleton.body_names, pair.alignment.frames
    moved = [names[body] for body, pose in frames.items() if _is_elsewhere(pose)]
    yield from _count_of(moved, "link frame", f"elsewhere in {pair.theirs.label}")


def rounded_numbers(names: Sequence[str], where: str = "") -> Iterator[str]:
    """Yield that numbers have more or fewer digits than the others, as one sentence, if any do."""
    if names:
        some = ", ".join(names[:_SHOWN]) + (", ..." if names[_SHOWN:] else "")
        yield f"{counted(len(names), 'number')} with other digits{where}: {some}"


def _limits(pair: Pair) -> Iterator[str]:
    found = list(_different_limits(pair))
    yield from found[:_SHOWN]
    if found[_SHOWN:]:
        yield f"{len(found) - _SHOWN} more limits differ in {pair.theirs.label}"


def _different_limits(pair: Pair) -> Iterator[str]:
    one, other = pair.ours.skeleton, pair.theirs.skeleton
    for body, joint in pair.alignment.joints.items():
        name = one.joint_names[body - 1]
        its_name = other.joint_names[pair.matching.theirs[body] - 1]
        own = pair.ours.properties.get(name, UNTOLD)
        its = _counted_as_ours(pair.theirs.properties.get(its_name, UNTOLD), joint)
        unit, force = ("m", "N") if one.joint_kinds[body - 1] == "prismatic" else ("rad", "N m")
        units = unit, unit, force, f"{unit}/s"
        kinds = "minimum", "maximum", "greatest effort", "greatest velocity"
        for kind, here, there, its_unit in zip(kinds, own[:4], its[:4], units, strict=True):
            if here is not None and there is not None and not _is_same_limit(here, there):
                values = f"{here:.6g} {its_unit} here and {there:.6g} {its_unit}"
                yield f"{kind} of joint '{name}' is {values} in {pair.theirs.label}"


def _counted_as_ours(limits: JointProperties, joint: AlignedJoint) -> JointProperties:
    ends = [None if end is None else joint.offset + joint.sign * end for end in limits.limits]
    lower, upper = ends if joint.sign > 0.0 else reversed(ends)
    return limits._replace(minimum=lower, maximum=upper)


def _is_same_limit(one: float, other: float) -> bool:
    return abs(one - other) <= _SAME_LIMIT * max(abs(one), abs(other))


def _is_elsewhere(pose: RigidPose) -> bool:
    trace = pose.rotation[0][0] + pose.rotation[1][1] + pose.rotation[2][2]
    return trace < 3.0 - _NOTHING**2 or hypot(*pose.translation) > _NOTHING


def _count_of(names: list[str], what: str, how: str) -> Iterator[str]:
    if names:
        shown = [f"'{name}'" for name in names[:_SHOWN]]
        some = ", ".join((*shown, "...")) if names[_SHOWN:] else listed(shown)
        yield f"{counted(len(names), what)} {how}: {some}"
