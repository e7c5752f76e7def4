"""Limits of joints that are others: no torque depends on them, but what a robot is let do."""

from collections.abc import Iterator

from kindsl.language.semantics.parameters import UNTOLD, JointProperties
from kindsl.robots.comparison.alignment import AlignedJoint, Alignment
from kindsl.robots.comparison.matching import MatchedJoints
from kindsl.robots.comparison.written import Described

# Relative: few digits are written of a limit.
_EQUAL = 1e-4
_SHOWN = 5


def other_limits(
    ours: Described, theirs: Described, matching: MatchedJoints, alignment: Alignment
) -> Iterator[str]:
    """Yield the limits that both tell, and otherwise; the first few."""
    found = list(_found(ours, theirs, matching, alignment))
    yield from found[:_SHOWN]
    if found[_SHOWN:]:
        yield f"{len(found) - _SHOWN} more limits are others in {theirs.label}"


def _found(
    ours: Described, theirs: Described, matching: MatchedJoints, alignment: Alignment
) -> Iterator[str]:
    for body, joint in alignment.joints.items():
        name = ours.skeleton.joint_names[body - 1]
        its_name = theirs.skeleton.joint_names[matching.theirs[body] - 1]
        own = ours.properties.get(name, UNTOLD)
        other = _counted_as_ours(theirs.properties.get(its_name, UNTOLD), joint)
        unit, force = ("m", "N") if _slides(ours, body) else ("rad", "N m")
        units = unit, unit, force, f"{unit}/s"
        kinds = "minimum", "maximum", "greatest effort", "greatest velocity"
        for kind, here, there, its_unit in zip(kinds, own[:4], other[:4], units, strict=True):
            if here is not None and there is not None and not _is_equal(here, there):
                values = f"{here:.6g} {its_unit} here and {there:.6g} {its_unit} in {theirs.label}"
                yield f"{kind} of joint '{name}' is {values}"


def _slides(robot: Described, body: int) -> bool:
    return robot.skeleton.joint_kinds[body - 1] == "prismatic"


def _counted_as_ours(told: JointProperties, joint: AlignedJoint) -> JointProperties:
    """Return limits for our zero and our direction."""
    ends = [None if end is None else joint.offset + joint.sign * end for end in told.limits]
    lower, upper = ends if joint.sign > 0.0 else reversed(ends)
    return told._replace(minimum=lower, maximum=upper)


def _is_equal(one: float, other: float) -> bool:
    return abs(one - other) <= _EQUAL * max(abs(one), abs(other))
