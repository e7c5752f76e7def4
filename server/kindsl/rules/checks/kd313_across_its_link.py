"""A rod lies across its link.

## What it does
Compares the shape of a moving link's mass with the way from its joint to the next one, or to its
only frame. Reports a body that is a slender rod about as long as that way, but lies at right angles
to it, with its centre of mass between the two ends.

## Why is this bad?
A link's mass lies along the link. Usually the moments are about other axes: the CAD program had
x where the link frame has z. Moments given about the wrong point often hide it (KD306); the
totals then look whole, and the joint torques are wrong.

## Example
```kindsl
link upper {
    id = 1
    inertia_params { mass = 2.0 CoM = (0.0, 0.0, 0.2)
        Ix=0.081 Iy=0.107 Iz=0.027 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children { lower via elbow }
}
```
with an elbow at 0.4 m along z: the rod is 0.4 m long, but along x.
"""

from collections.abc import Iterator
from math import hypot, sqrt

from kindsl.rigid.body import Symmetric, eigensystem, second_moments_about_com
from kindsl.rigid.pose import Vector3
from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import joint, link, robot
from kindsl.rules.inertia.judgements import is_moving, keyword
from kindsl.rules.inertia.plausibility import GREATEST_LENGTH
from kindsl.rules.memory import Memory
from kindsl.semantics.declarations import Link
from kindsl.semantics.model import Model
from kindsl.semantics.numbers import mass_distribution, written_pose
from kindsl.text.quantities import with_unit

_SHORTEST = 0.05
_SLENDER = 8.0
_SHORTER, _LONGER = 0.7, 1.5
_ACROSS = 0.2
_NEAR_END = 0.2
_NOISE = 0.01
_MESSAGES = Memory[str]("across")


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each link whose mass is a rod across the way to its only end."""
    for body in model.bodies:
        if body.inertia is not None and body.inertia.frame is None and is_moving(body):
            end = _only_end(model, body, context)
            message = _kept_message(body, end, context) if end is not None else ""
            if message:
                yield Finding(keyword(body.inertia), message)


def _only_end(model: Model, body: Link, context: Context) -> Vector3 | None:
    """Return where the link ends, in its frame; None where it goes to several places, or none."""
    poses = [e.joint.pose for e in model.tree.successor_edges(body) if e.joint is not None]
    poses = poses or [frame.pose for frame in body.frames]
    placed = [written_pose(pose, context.values) for pose in poses]
    known = [place.translation for place in placed if place is not None]
    return known[0] if len(known) == len(poses) == 1 else None


def _kept_message(body: Link, end: Vector3, context: Context) -> str:
    given = end, mass_distribution(body.inertia, context.values) if body.inertia else None
    return _MESSAGES.of(body, given, lambda: _message(body, end, context))


def _message(body: Link, end: Vector3, context: Context) -> str:
    length = hypot(*end)
    numbers = mass_distribution(body.inertia, context.values) if body.inertia else None
    if numbers is None or numbers.mass <= 0.0 or not _SHORTEST < length < GREATEST_LENGTH:
        return ""
    ahead = sum(c * e for c, e in zip(numbers.com, end, strict=True)) / (length * length)
    second_moments = second_moments_about_com(numbers)
    if not _NEAR_END < ahead < 1.0 - _NEAR_END or _is_plainly_along(second_moments, end):
        return ""
    small, middle, large = eigensystem(second_moments)
    if small.value < -_NOISE * large.value or large.value <= _SLENDER * middle.value:
        return ""
    rod = sqrt(12.0 * large.value / numbers.mass)
    along = abs(sum(a * e for a, e in zip(large.axis, end, strict=True))) / length
    if along > _ACROSS or not _SHORTER < rod / length < _LONGER:
        return ""
    told = f"inertia of '{body.name}' describes a rod {with_unit(rod, 'm')} long across the link"
    return f"{told}, which is {with_unit(length, 'm')} long"


def _is_plainly_along(second_moments: Symmetric, end: Vector3) -> bool:
    """Return whether the mass is too spread along the link for a rod across it."""
    xx, yy, zz, xy, xz, yz = second_moments
    x, y, z = end
    spread = xx * x * x + yy * y * y + zz * z * z + 2.0 * (xy * x * y + xz * x * z + yz * y * z)
    most = _ACROSS * _ACROSS + 1.0 / _SLENDER
    return spread > most * (xx + yy + zz) * (x * x + y * y + z * z)


_INERTIA = """inertia_params {
        mass = 2.0
        CoM = (0.0, 0.0, 0.2)
        Ix=%s Iy=%s Iz=%s Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""


def _arm(*moments: str) -> str:
    upper = link("upper", 1, "lower via elbow", _INERTIA % moments)
    joints = joint("shoulder"), joint("elbow", 0.4)
    return robot(upper, link("lower", 2), *joints, base="upper via shoulder")


RULE = Rule(
    "KD313",
    "across-its-link",
    Severity.WARNING,
    check_document=check_document,
    good=(_arm("0.107", "0.107", "0.001"), _arm("0.10", "0.11", "0.02")),
    bad=(_arm("0.081", "0.107", "0.027"),),
)
