"""What the rest of the robot says of a link's inertia: its children's joints, and its twins."""

from collections.abc import Iterator, Sequence
from itertools import product
from math import hypot, log
from typing import NamedTuple

from kindsl.rigid.body import MassDistribution
from kindsl.rigid.pose import Vector3
from kindsl.rules.context import Context
from kindsl.rules.inertia.judgements import Judgement, is_impossible
from kindsl.rules.inertia.likelihood import Shape
from kindsl.rules.inertia.slips import Hypothesis, Slip
from kindsl.rules.inertia.twins import part_of, right_twin_of
from kindsl.semantics.declarations import Link
from kindsl.semantics.model import Model
from kindsl.semantics.numbers import mass_distribution, written_pose

_KEY = "parts"
_MOST_PARTS = 8
_NEAR = 0.02
_ELONGATED = 2.5
_ALONG = 0.85
_SAME = 0.02
_LOG_EQUAL, _LOG_MIRRORED = log(1500.0), log(30.0)
_LOG_ALONG, _LOG_ACROSS = log(2.5), log(0.6)
_LOG_TOWARDS, _LOG_AWAY = log(1.2), log(0.3)
_SIGNS: tuple[Vector3, ...] = tuple(product((1.0, -1.0), repeat=3))  # type: ignore[arg-type]
_PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


class Twin(NamedTuple):
    """A link of the same part whose inertia is possible."""

    name: str
    body: MassDistribution


class Surroundings(NamedTuple):
    """What is known of a link besides its inertia.

    Attributes:
        points: Origins of its frames and of its children's joints, in the link frame, m.
        twins: Links of the same part, on the other side or at another leg.
        mirror: Name of the mirrored twin, if there are twins and it may be one of them.
    """

    points: tuple[Vector3, ...]
    twins: tuple[Twin, ...]
    mirror: str | None

    def reach(self, com: Vector3) -> float:
        """Return how far the link goes from its origin, m."""
        return max([hypot(*com), *(hypot(*point) for point in self.points)])


class Evidence(NamedTuple):
    """What speaks for a hypothesis: a logarithm to add, and why in words."""

    log_weight: float
    reasons: tuple[str, ...] = ()


def surroundings(model: Model, context: Context, found: Judgement) -> Surroundings:
    """Return what is known of a link besides its inertia."""
    link = found.link
    points: list[Vector3] = []
    if found.inertia.frame is None:
        poses = [frame.pose for frame in link.frames]
        edges = model.tree.successor_edges(link)
        poses += [edge.joint.pose for edge in edges if edge.joint is not None]
        placed = (written_pose(pose, context.values) for pose in poses)
        points = [place.translation for place in placed if place is not None]
    twins = tuple(_twins(model, context, link, found.body.mass))
    return Surroundings(
        tuple(point for point in points if hypot(*point) > _NEAR),
        twins,
        _mirror(model, link) if twins else None,
    )


def evidence(h: Hypothesis, shape: Shape, around: Surroundings) -> Evidence:
    """Return what the surroundings say of a hypothesis."""
    parts = [_of_points(h, shape, around), _of_twins(h, around)]
    reasons = tuple(reason for part in parts for reason in part.reasons)
    return Evidence(sum(part.log_weight for part in parts), reasons)


def _of_points(h: Hypothesis, shape: Shape, around: Surroundings) -> Evidence:
    if not around.points:
        return Evidence(0.0)
    point = max(around.points, key=lambda p: hypot(*p))
    length, total, reasons = hypot(*point), 0.0, []
    _, middle, long = shape.pairs
    if long.value > _ELONGATED * max(middle.value, 0.0):
        along = abs(sum(a * p for a, p in zip(long.axis, point, strict=True))) / length
        total += _LOG_ALONG if along > _ALONG else _LOG_ACROSS
        reasons += ["long towards its next joint"] if along > _ALONG else []
    if Slip.COM_SIGN in h.slips:
        ahead = sum(c * p for c, p in zip(h.body.com, point, strict=True))
        total += _LOG_TOWARDS if ahead > 0.0 else _LOG_AWAY
        reasons += ["CoM on the side of its next joint"] if ahead > 0.0 else []
    return Evidence(total, tuple(reasons))


def _of_twins(h: Hypothesis, around: Surroundings) -> Evidence:
    alike = [twin for twin in around.twins if is_mirror_image(h.body, twin.body)]
    if not alike:
        return Evidence(0.0)
    name = next((twin.name for twin in alike if twin.name == around.mirror), alike[0].name)
    if any(is_same_body(h.body, twin.body) for twin in alike if twin.name == name):
        return Evidence(_LOG_EQUAL, (f"equal to '{name}'",))
    return Evidence(_LOG_MIRRORED, (f"mirror image of '{name}'",))


def is_mirror_image(one: MassDistribution, other: MassDistribution) -> bool:
    """Return whether axes turned round by some signs, or none, make one body the other."""
    return any(is_same_body(_reflected(one, signs), other) for signs in _SIGNS)


def is_same_body(one: MassDistribution, other: MassDistribution) -> bool:
    """Return whether all ten numbers agree but for a little of the greatest of their kind."""
    groups = (([one.mass], [other.mass]), (one.com, other.com), (one.moments, other.moments))
    return all(_are_near(a, b) for a, b in groups)


def _are_near(one: Sequence[float], other: Sequence[float]) -> bool:
    size = max(map(abs, (*one, *other)))
    return all(abs(a - b) <= _SAME * size for a, b in zip(one, other, strict=True))


def _reflected(body: MassDistribution, signs: Vector3) -> MassDistribution:
    x, y, z = (sign * c for sign, c in zip(signs, body.com, strict=True))
    moments = (signs[i] * signs[j] * m for (i, j), m in zip(_PAIRS, body.moments, strict=True))
    return MassDistribution(body.mass, (x, y, z), tuple(moments))  # type: ignore[arg-type]


def _twins(model: Model, context: Context, link: Link, mass: float) -> Iterator[Twin]:
    for other in _parts(model).get(part_of(link), ()):
        if other is not link and other.inertia is not None:
            body = mass_distribution(other.inertia, context.values)
            if body is None or abs(body.mass - mass) > _SAME * abs(mass) or body.mass <= 0.0:
                continue
            if not is_impossible(other, context):
                yield Twin(str(other.name), body)


def _mirror(model: Model, link: Link) -> str | None:
    name = right_twin_of(link)
    if name in model.body_named:
        return name
    others = _parts(model).get(part_of(link), ())
    return next((str(o.name) for o in others if right_twin_of(o) == link.name), None)


def _parts(model: Model) -> dict[str, list[Link]]:
    """Return the bodies that are the same part on another side or at another leg, by its name."""
    known = model.facts.get(_KEY)
    if isinstance(known, dict):
        return known
    parts: dict[str, list[Link]] = {}
    for body in model.bodies:
        part = part_of(body)
        if part and len(parts.setdefault(part, [])) < _MOST_PARTS:
            parts[part].append(body)
    model.facts[_KEY] = parts
    return parts
