"""Doubts about the bodies of a robot, as the rules report them.

`body_verdicts` takes numbers as they are. What is reported of a density leaves room for the digits
written besides.
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.body_verdicts import (
    GREATEST_LENGTH,
    OF_LENGTH,
    BodyVerdict,
    body_verdicts,
)
from kindsl.judgement.diagnosis.judgements import (
    Verdict,
    is_impossible,
    is_moving,
    judgements,
    keyword,
)
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.declarations import Joint, Link, Pose
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import frame_of_com, written_pose
from kindsl.language.semantics.places import Located
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.text.facts import Fact
from kindsl.mechanics.rigid.pose import Vector3
from kindsl.robots.mechanism.link_inertia import link_inertia

_VERDICTS = Fact[tuple[object, list[BodyVerdict]]]("shape")
_OF_DENSITY, _OF_COM = "KD311", ("KD309", "KD511")


def shape_doubts(
    body: Link, joints: tuple[Joint, ...], context: Context, code: str = ""
) -> Iterator[tuple[Located, BodyVerdict]]:
    """Yield what one rule reports of a body's shape, or all; it is judged once for all of them."""
    inertia = body.inertia
    verdicts = body.facts.made_of(
        _VERDICTS, (joints, context.values), lambda: list(shape_verdicts(body, joints, context))
    )
    for verdict in verdicts:
        if inertia is not None and verdict.code.startswith(code):
            com = inertia.com if verdict.code in _OF_COM else None
            yield com or keyword(inertia), verdict


def is_told_of(body: Link, model: Model, context: Context) -> bool:
    """Return whether a body is reported as impossible, too far away, or behind its joint."""
    com = body.inertia.com if body.inertia is not None else None
    if com is not None and any(abs(c.literal or 0.0) > GREATEST_LENGTH for c in com.components):
        return True
    if is_impossible(body, context.values) or frame_of_com(body) is not None:
        return is_impossible(body, context.values)
    return any(shape_doubts(body, model.tree.joints_on(body), context, "KD511"))


def shape_verdicts(
    body: Link, joints: tuple[Joint, ...], context: Context
) -> Iterator[BodyVerdict]:
    """Yield what is reported of one body's shape, nothing of a fixed base."""
    if body.inertia is None or not is_moving(body):
        return
    numbers = link_inertia(body, context.values)
    is_rail = any(joint.kind == "prismatic" for joint in joints)
    if not isinstance(numbers, Unknown):
        for verdict in body_verdicts(str(body.name), numbers, *link_ends(body, joints, context)):
            is_told = not (is_rail and verdict.kind in OF_LENGTH)
            if is_told and (verdict.code != _OF_DENSITY or _is_of_no_material(body, context)):
                yield verdict


def link_ends(
    body: Link, joints: tuple[Joint, ...], context: Context
) -> tuple[tuple[Vector3, ...], tuple[Vector3, ...]]:
    """Return the known origins of the children's joints and of the frames, in the link frame."""
    children = _places([joint.pose for joint in joints], context)
    return children, _places([frame.pose for frame in body.frames], context)


def _places(poses: list[Pose], context: Context) -> tuple[Vector3, ...]:
    placed = (written_pose(pose, context.values) for pose in poses)
    return tuple(place.translation for place in placed if place is not None)


def _is_of_no_material(body: Link, context: Context) -> bool:
    judged = judgements(declarations(body.island), context.values)
    return any(j.link is body and j.verdict is Verdict.IMPLAUSIBLE for j in judged)
