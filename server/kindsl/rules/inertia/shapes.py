"""Doubts about the bodies of a robot, as the rules report them.

`body_verdicts` takes numbers as they are. What is reported of a density leaves room for the digits
written besides.
"""

from collections.abc import Iterator

from kindsl.mechanism.body_verdicts import BodyVerdict, body_verdicts
from kindsl.mechanism.link_inertia import link_inertia
from kindsl.rigid.pose import Vector3
from kindsl.rules.context import Context
from kindsl.rules.inertia.judgements import Verdict, is_moving, judgements
from kindsl.semantics.declarations import Link, Pose
from kindsl.semantics.lowering import declarations
from kindsl.semantics.model import Model
from kindsl.semantics.numbers import written_pose
from kindsl.semantics.unknown import Unknown
from kindsl.text.facts import Fact

_VERDICTS = Fact[tuple[Context, Link, list[BodyVerdict]]]("shape of the last body")
_OF_DENSITY = "KD311"


def shape_doubts(model: Model, context: Context, body: Link, code: str) -> Iterator[BodyVerdict]:
    """Yield what one rule reports of a body's shape; all rules ask of one body after the other."""
    known = model.facts.get(_VERDICTS)
    if known is None or known[0] is not context or known[1] is not body:
        verdicts = list(shape_verdicts(model, context, body))
        known = model.facts.keep(_VERDICTS, (context, body, verdicts))
    yield from (verdict for verdict in known[2] if verdict.code == code)


def shape_verdicts(model: Model, context: Context, body: Link) -> Iterator[BodyVerdict]:
    """Yield what is reported of one body's shape, nothing of a fixed base."""
    if body.inertia is None or not is_moving(body):
        return
    numbers = link_inertia(body, context.values)
    if not isinstance(numbers, Unknown):
        for verdict in body_verdicts(str(body.name), numbers, *link_ends(model, context, body)):
            if verdict.code != _OF_DENSITY or _is_of_no_material(body, context):
                yield verdict


def link_ends(
    model: Model, context: Context, body: Link
) -> tuple[tuple[Vector3, ...], tuple[Vector3, ...]]:
    """Return the known origins of the children's joints and of the frames, in the link frame."""
    edges = model.tree.successor_edges(body)
    children = _places([e.joint.pose for e in edges if e.joint is not None], context)
    return children, _places([frame.pose for frame in body.frames], context)


def _places(poses: list[Pose], context: Context) -> tuple[Vector3, ...]:
    placed = (written_pose(pose, context.values) for pose in poses)
    return tuple(place.translation for place in placed if place is not None)


def _is_of_no_material(body: Link, context: Context) -> bool:
    judged = judgements(declarations(body.island), context)
    return any(j.link is body and j.verdict is Verdict.IMPLAUSIBLE for j in judged)
