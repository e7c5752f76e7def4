"""Make the pose that is shown the zero configuration: joint positions become joint frames.

A revolute joint turns about the z axis of its frame, as the last of the frame's three angles does,
so its position is added to that angle. A prismatic joint's is added along the z axis.
"""

from collections.abc import Mapping
from math import isclose

from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.frontends.features.manipulation.things import LENGTHS, Component, Thing, components
from kindsl.frontends.features.manipulation.value_text import exact_angle
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Joint
from kindsl.language.semantics.numbers import written_pose
from kindsl.language.text.decimals import rounded_decimal
from kindsl.language.text.edits import TextEdit


def pose_as_zero(analysis: Analysis, q: Mapping[str, float]) -> Gesture | Refusal:
    """Return the edits after which the robot at zero stands as it does now at `q`.

    Args:
        q: Positions by the joints' names, radians and metres; joints left out are at zero.
    """
    edits: list[TextEdit] = []
    for name, position in q.items():
        joint = analysis.model.joint_named.get(name)
        if joint is None:
            return Refusal(f"there is no joint '{name}'")
        moved = _edits(analysis, joint, position) if position else []
        if isinstance(moved, Refusal):
            return moved
        edits += moved
    return Gesture("Write this pose as the new zero", tuple(sorted(edits)))


def _edits(analysis: Analysis, joint: Joint, position: float) -> list[TextEdit] | Refusal:
    found = components(analysis.model, Thing("joint", str(joint.name)))
    texts = _texts(joint, position, found["rz"], analysis.context.values)
    if texts is None:
        return Refusal(f"joint '{joint.name}' has no known frame")
    edits: list[TextEdit] = []
    for axis, text in texts.items():
        own = found[axis]
        if isinstance(own, Refusal):
            return own
        if own.carrier is not None:
            return Refusal(f"'{own.expression.text}' of joint '{joint.name}' is not a plain number")
        edits.append(analysis.resolver.edit(own.expression, text))
    return edits


def _texts(
    joint: Joint, position: float, angle: Component | Refusal, values: Mapping[str, float]
) -> dict[str, str] | None:
    """Return the new texts of the components that a joint's position changes."""
    if joint.kind == "revolute":
        now = None if isinstance(angle, Refusal) else angle.expression.value(values)
        return {"rz": "" if now is None else exact_angle(now + position)}
    pose = written_pose(joint.pose, values)
    if pose is None:
        return None
    moved = pose.point((0.0, 0.0, position))
    return {
        name: rounded_decimal(new, abs(position))
        for name, old, new in zip(LENGTHS, pose.translation, moved, strict=True)
        if not isclose(new, old, rel_tol=0.0, abs_tol=1e-16 * abs(position))
    }
