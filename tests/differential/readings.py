"""What a generator read, held against what these tools read for that target."""

import math
import re
from collections.abc import Iterator, Mapping
from typing import Any

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.declarations import Pose, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.syntax.vocabulary import MOMENTS

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_FORM = re.compile(rf"(?:({_NUMBER})\*)?(-?)(?:({_NUMBER})\*)?(\S+?)(?:/({_NUMBER}))?")
# RobCoGen keeps single precision; robcogen2 takes for zero what is zero in five decimals.
_RELATIVE, _ZERO = 1e-6, 6e-6
_AXES = "XYZ"


def difference(text: str, reads: Mapping[str, Any], target: str) -> str:
    """Return the first thing that is read otherwise; empty where there is none.

    Args:
        text: The document.
        reads: What the generator read, as the shared cases have it.
        target: The generator.
    """
    analysis = analyse(text, Settings(frozenset([target])))
    values = {str(p.name): _bound(str(p.name)) for p in analysis.model.parameters}
    values = {**analysis.context.values, **values}
    pairs = _of_robcogen(analysis, reads) if target == "robcogen" else _of_rmt(analysis, reads)
    for where, ours, theirs in pairs:
        if isinstance(ours, Expression):
            number, expected = ours.value(values), _evaluated(str(theirs), values, target)
            if not _is_equal(number, expected):
                return f"{where}: {ours.text!r} is {number} here, {theirs!r} there"
        elif ours != theirs:
            return f"{where}: {ours!r} here, {theirs!r} there"
    return ""


def _bound(name: str) -> float:
    return 1.0 + sum(map(ord, name)) % 97 / 100


def _evaluated(written: str, values: Mapping[str, float], target: str) -> float | None:
    if re.fullmatch(_NUMBER, written):
        return float(written)
    match = _FORM.fullmatch(written)
    assert match is not None, written
    outer, sign, inner, symbol, divisor = match.groups()
    factor = float(outer or 1) * float(inner or 1)
    is_pi = symbol == ("%PI" if target == "robcogen" else "pi")
    value = values.get(f"<{symbol}>", math.pi if is_pi else values.get(symbol, math.nan))
    if symbol == "zoo" or (divisor and not float(divisor)):
        return None
    return (-1 if sign else 1) * factor * value / float(divisor or 1)


def _is_equal(ours: float | None, theirs: float | None) -> bool:
    if ours is None or theirs is None:
        return ours is theirs
    return math.isclose(ours, theirs, rel_tol=_RELATIVE, abs_tol=_ZERO)


def _of_robcogen(analysis: Analysis, reads: Mapping[str, Any]) -> Iterator[tuple[str, Any, Any]]:
    model = analysis.model
    yield "robot", model.name, reads["name"]
    yield "floating", model.floating, reads["floating"]
    yield "links", len(model.bodies), len(reads["links"])
    for body, read in zip(model.bodies, reads["links"], strict=True):
        yield "name", str(body.name), read["name"]
        yield f"id of {body.name}", body.id, read["id"]
        inertia = body.inertia
        assert inertia is not None
        yield f"mass of {body.name}", inertia.mass, read["mass"]
        yield from _vector(f"CoM of {body.name}", inertia.com, read["com"])
        for name, theirs in zip(MOMENTS, read["I"], strict=True):
            yield f"{name} of {body.name}", inertia.moments[name], theirs
        yield f"frame of {body.name}", inertia.frame and str(inertia.frame), read["fr"]
        children = [[str(child.link), str(child.joint)] for child in body.children]
        yield f"children of {body.name}", children, read["children"]
        for frame, theirs in zip(body.frames, read["frames"], strict=True):
            yield "frame", str(frame.name), theirs[0]
            yield from _pose(f"frame {frame.name}", frame.pose, *theirs[1:])
    for joint, theirs in zip(model.joints, reads["joints"], strict=True):
        yield "joint", [str(joint.name), joint.kind[0]], theirs[:2]
        yield from _pose(f"joint {joint.name}", joint.pose, *theirs[2:])


def _of_rmt(analysis: Analysis, reads: Mapping[str, Any]) -> Iterator[tuple[str, Any, Any]]:
    model = analysis.model
    yield "robot", model.name, reads["name"]
    yield "ids", {str(body.name): body.id for body in model.bodies}, reads["links"]
    poses = {str(joint.name): joint.pose for joint in model.joints}
    poses |= {str(frame.name): frame.pose for frame in model.frames}
    for name, (_, steps) in reads["joints"].items():
        if name in poses:
            theirs = {("Translation", axis): "0.0" for axis in _AXES}
            theirs |= {("Rotation", axis): "0.0" for axis in _AXES}
            theirs |= {(kind, axis): amount for kind, axis, amount in steps}
            numbers = list(theirs.values())
            yield from _pose(f"pose of {name}", poses[name], numbers[:3], numbers[3:])
    for name, (mass, com, moments) in (reads.get("I") or {}).items():
        inertia = model.body_named[name].inertia
        assert inertia is not None
        yield f"mass of {name}", inertia.mass, mass
        yield from _vector(f"CoM of {name}", inertia.com, com)
        for moment, theirs_moment in zip(MOMENTS, moments, strict=True):
            yield f"{moment} of {name}", inertia.moments[moment], theirs_moment


def _pose(
    where: str, pose: Pose, translation: list[str], rotation: list[str]
) -> Iterator[tuple[str, Any, Any]]:
    yield from _vector(where, pose.translation, translation)
    yield from _vector(where, pose.rotation, rotation)


def _vector(where: str, vector: Vector | None, theirs: list[str]) -> Iterator[tuple[str, Any, Any]]:
    assert vector is not None
    yield from ((where, *pair) for pair in zip(vector.components, theirs, strict=True))
