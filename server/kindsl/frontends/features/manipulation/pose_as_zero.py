"""Make the pose that is shown the zero configuration: joint positions become joint frames.

A revolute joint turns about the z axis of its frame, as the last of the frame's three angles does,
so its position is added to that angle. A prismatic joint's is added along the z axis.
"""

from collections.abc import Iterator, Mapping
from math import isclose

from kindsl.frontends.features.manipulation.carrier import carrier_of
from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.frontends.features.manipulation.things import Missing, Thing, component
from kindsl.frontends.features.manipulation.written_value import exact_angle
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Joint
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.numbers import written_pose
from kindsl.language.text.decimals import rounded_decimal
from kindsl.language.text.edits import TextEdit

_AXES = ("x", "y", "z")


def pose_as_zero(analysis: Analysis, q: Mapping[str, float]) -> Gesture | Refusal:
    """Return the edits after which the robot at zero stands as it does now at `q`.

    Args:
        analysis: The document.
        q: Positions by the joints' names, radians and metres; joints left out are at zero.
    """
    edits: list[TextEdit] = []
    for name, position in q.items():
        joint = analysis.model.joint_named.get(name)
        if joint is None:
            return Refusal(f"there is no joint '{name}'")
        for expression, text in _texts(analysis, joint, position) if position else ():
            if isinstance(expression, Missing):
                return Refusal(expression.reason)
            if carrier_of(expression) is not None:
                return Refusal(f"'{expression.text}' of joint '{name}' is not a plain number")
            edits.append(TextEdit(*analysis.resolver.span(expression), text))
    return Gesture("Write this pose as the new zero", tuple(sorted(edits)))


def _texts(
    analysis: Analysis, joint: Joint, position: float
) -> Iterator[tuple[Expression | Missing, str]]:
    """Yield the components that a joint's position changes, with their new texts."""
    thing, values = Thing("joint", str(joint.name)), analysis.context.values
    if joint.kind == "revolute":
        angle = component(analysis, thing, "rz")
        now = angle.value(values) if isinstance(angle, Expression) else None
        yield angle, "" if now is None else exact_angle(now + position)
        return
    pose = written_pose(joint.pose, values)
    if pose is None:
        yield Missing(f"joint '{joint.name}' has no known frame"), ""
        return
    moved = pose.point((0.0, 0.0, position))
    for name, old, new in zip(_AXES, pose.translation, moved, strict=True):
        if not isclose(new, old, rel_tol=0.0, abs_tol=1e-16 * abs(position)):
            yield component(analysis, thing, name), rounded_decimal(new, abs(position))
