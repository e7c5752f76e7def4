"""A document as a robot to compare: its bodies, and where its numbers stand."""

from collections.abc import Iterable, Iterator

from kindsl.language.semantics.declarations import Link, Pose
from kindsl.language.semantics.expressions import Expression, Values, half_unit
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution, triple, written_pose
from kindsl.language.semantics.unknown import inertia_expressions
from kindsl.language.syntax.tree import Node
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.comparison.quantities import POSE
from kindsl.robots.comparison.side import ComparedSide, exactly_turned
from kindsl.robots.comparison.written import (
    Numbers,
    WrittenInertia,
    WrittenNumber,
    WrittenPose,
    written_frame,
)
from kindsl.robots.mechanism.link_inertia import NO_INERTIA
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.mechanism.reading import named_frames
from kindsl.robots.mechanism.total_mass import unknown_bodies


def described_document(label: str, model: Model, values: Values, skeleton: Linkage) -> ComparedSide:
    """Return a document's robot; what cannot be read is named in `unknown`.

    Args:
        label: Name of the document.
        values: Of parameters by name, and of constants by `<name>`.
        skeleton: Its bodies at these values.
    """
    bodies = {str(body.name): body for body in model.bodies}
    joints = {str(joint.name): joint for joint in model.joints}
    poses = zip(skeleton.joint_names, skeleton.placements, strict=True)
    frames = {
        name: _pose(name, frame.pose, values, IDENTITY)
        for name, _, frame in named_frames([bodies[name] for name in skeleton.body_names])
    }
    described = ComparedSide(
        label,
        skeleton,
        tuple(_inertias(bodies[name], values) for name in skeleton.body_names),
        tuple(_pose(name, joints[name].pose, values, pose) for name, pose in poses),
        frames=frames,
        unknown=frozenset(_unknown(model, values)),
    )
    return exactly_turned(described)


def _unknown(model: Model, values: Values) -> Iterator[str]:
    yield from (name for name, why in unknown_bodies(model, values).items() if why != NO_INERTIA)
    for joint in model.joints:
        if written_pose(joint.pose, values) is None:
            yield str(joint.name)


def _inertias(link: Link, values: Values) -> tuple[WrittenInertia, ...]:
    inertia = link.inertia
    body = None if inertia is None else mass_distribution(inertia, values)
    if inertia is None or body is None:
        return ()
    frame = next((f for f in link.frames if f.name == inertia.frame), None)
    pose = IDENTITY if frame is None else written_pose(frame.pose, values) or IDENTITY
    numbers = _numbers(inertia_expressions(inertia), values)
    return (WrittenInertia(str(link.name), body.numbers, numbers, pose),)


def _pose(owner: str, pose: Pose, values: Values, known: RigidPose) -> WrittenPose:
    vectors = [vector for vector in pose if vector is not None]
    written = tuple(each for vector in vectors for each in triple(vector, values) or ())
    if len(written) != len(POSE):
        return written_frame(owner, known)
    expressions = [component for vector in vectors for component in vector.components]
    return WrittenPose(owner, written, _numbers(expressions, values))


def _numbers(expressions: Iterable[Expression | None], values: Values) -> Numbers:
    return tuple(None if e is None else _number(e, values) for e in expressions)


def _number(expression: Expression, values: Values) -> WrittenNumber:
    value = expression.value(values) or 0.0
    half = expression.rounding(values) if _is_decimal(expression.node) else 0.0
    if not value and expression.node.kind == "number":
        half = half_unit(expression.text)
    return WrittenNumber(expression.text, value, half, expression)


def _is_decimal(node: Node) -> bool:
    """Return whether a value is made of decimal numbers alone: PI and parameters are exact."""
    return node.kind == "number" or (bool(node.parts) and all(map(_is_decimal, node.parts)))
