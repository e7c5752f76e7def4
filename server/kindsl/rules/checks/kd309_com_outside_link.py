"""The centre of mass is far away from the link.

## What it does
Compares a moving link's centre of mass with what is known of the link's place: its own joint, the
joints of its children, its frames. Reports a distance of more than three times the link's length
and its radius of gyration together, and a radius of gyration of more than ten times the length.

## Why is this bad?
A body's mass is where the body is. Mostly a digit is lost, a unit is wrong, or the numbers are
those of another frame.

## Example
```kindsl
link forearm {
    id = 2
    inertia_params { mass = 1.2 CoM = (0.0, 0.0, 1.5)
        Ix=2.71 Iy=2.71 Iz=0.001 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children { hand via wrist }
}
```
with a wrist at 0.3 m.
"""

from collections.abc import Iterator
from math import dist, hypot, sqrt

from kindsl.rigid.body import MassDistribution, second_moments_about_com
from kindsl.rigid.pose import Vector3
from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import joint, link, robot
from kindsl.rules.inertia.judgements import is_moving
from kindsl.rules.inertia.plausibility import GREATEST_LENGTH
from kindsl.semantics.declarations import Inertia, Link
from kindsl.semantics.model import Model
from kindsl.semantics.numbers import mass_distribution, written_pose
from kindsl.text.quantities import with_unit

_FAR = 3.0
_WIDE = 10.0
_SHORTEST = 0.02
_NEGLIGIBLE = 1e-9


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each link whose mass is not where the link is."""
    for body in model.bodies:
        inertia = body.inertia
        if inertia is not None and inertia.com is not None and is_moving(body):
            points = _known_points(model, body, context)
            message = _message(body, inertia, points, context) if points else ""
            if message:
                yield Finding(inertia.com, message)


def _known_points(model: Model, body: Link, context: Context) -> list[Vector3]:
    """Return the origins of the children's joints and of the frames, in the link frame."""
    poses = [frame.pose for frame in body.frames]
    poses += [e.joint.pose for e in model.tree.successor_edges(body) if e.joint is not None]
    placed = (written_pose(pose, context.values) for pose in poses)
    return [place.translation for place in placed if place is not None]


def _message(body: Link, inertia: Inertia, points: list[Vector3], context: Context) -> str:
    numbers = mass_distribution(inertia, context.values)
    length = max([hypot(*point) for point in points])
    if numbers is None or numbers.mass <= 0.0 or not _SHORTEST < length < GREATEST_LENGTH:
        return ""
    if _is_plainly_inside(numbers, length):
        return ""
    spread = sum(second_moments_about_com(numbers)[:3])
    com = _in_link_frame(body, inertia, numbers.com, context)
    is_negative = spread < -_NEGLIGIBLE * max(numbers.moments)
    if com is None or is_negative or max(map(abs, com)) > GREATEST_LENGTH:
        return ""
    radius = sqrt(max(spread, 0.0) / numbers.mass)
    distance = min(_distance_to_segment(com, point) for point in points if any(point))
    if distance > _FAR * (length + radius):
        return (
            f"CoM of '{body.name}' lies {with_unit(distance, 'm')} from "
            f"a link {with_unit(length, 'm')} long"
        )
    if radius > _WIDE * (length + hypot(*com)):
        return (
            f"radius of gyration of '{body.name}' is {with_unit(radius, 'm')}, "
            f"the link is {with_unit(length, 'm')} long"
        )
    return ""


def _is_plainly_inside(body: MassDistribution, length: float) -> bool:
    """Return whether neither distance nor radius can be too great, from the numbers as given.

    Those of a frame say as much, since its origin is no further away than the link is long.
    """
    ix, iy, iz = body.moments[:3]
    is_narrow = ix + iy + iz <= 2.0 * body.mass * (_WIDE * length) ** 2
    return is_narrow and hypot(*body.com) <= _FAR * length


def _in_link_frame(body: Link, inertia: Inertia, com: Vector3, context: Context) -> Vector3 | None:
    if inertia.frame is None:
        return com
    frame = next((frame for frame in body.frames if frame.name == inertia.frame), None)
    place = written_pose(frame.pose, context.values) if frame is not None else None
    return place.point(com) if place is not None else None


def _distance_to_segment(point: Vector3, end: Vector3) -> float:
    """Return the distance of a point from the segment between the origin and `end`, elsewhere."""
    x, y, z = end
    along = sum(p * e for p, e in zip(point, end, strict=True))
    share = min(max(along / (x * x + y * y + z * z), 0.0), 1.0)
    return dist(point, (share * x, share * y, share * z))


_INERTIA = """inertia_params {
        mass = 1.2
        CoM = (0.0, 0.0, %s)
        Ix=%s Iy=%s Iz=0.001 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""


def _arm(com: str, moment: str) -> str:
    forearm = link("forearm", 1, "hand via wrist", _INERTIA % (com, moment, moment))
    joints = joint("elbow"), joint("wrist", 0.3)
    return robot(forearm, link("hand", 2), *joints, base="forearm via elbow")


RULE = Rule(
    "KD309",
    "com-outside-link",
    Severity.WARNING,
    check_document=check_document,
    good=(_arm("0.15", "0.037"), _arm("150.0", "27100.0")),
    bad=(_arm("1.5", "2.71"),),
)
