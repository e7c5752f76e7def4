"""Evidence from the rest of the robot on a link's inertia: its children's joints, its twins."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import islice
from math import hypot, isclose, isfinite, log, log10
from typing import NamedTuple

from kindsl.judgement.diagnosis.evidence import MassShape
from kindsl.judgement.diagnosis.fitted import EXPECTED, MIRRORED
from kindsl.judgement.diagnosis.judgements import Judgement, is_impossible, is_moving
from kindsl.judgement.diagnosis.slips import Hypothesis, Slip
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution, written_pose
from kindsl.language.text.decimals import significant_digits
from kindsl.language.text.facts import Fact, kept
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import Rotation, Vector3, dot, transposed
from kindsl.robots.limbs.mounts import REFLECTIONS
from kindsl.robots.limbs.names import label_of, other_side
from kindsl.robots.limbs.twin_frames import twin_frames
from kindsl.robots.limbs.weighing import seen_by
from kindsl.robots.mechanism.body_verdicts import GREATEST_LENGTH

_Inertia = tuple[Link, MassDistribution]
_FRAMES = Fact[tuple[object, dict[tuple[str, str], list[Rotation]]]]("frames of twins, by names")
_FEWEST_MASSES = 3
_FEWEST_DIGITS = 7
# Numbers are copied with their digits rounded, too.
_ROUNDED, _NEXT = 5e-5, 1e-3
_MOST_PARTS = 8
_NEAR = 0.02
_ELONGATED = 2.5
_ALONG = 0.85
_ACROSS = 0.2
_SAME = 0.02


class Twin(NamedTuple):
    """A link of the same part whose inertia is possible.

    Attributes:
        name: Its name.
        body: Its inertia.
        expected: The inertia that the link should have for its sake, None if that is not known.
    """

    name: str
    body: MassDistribution
    expected: MassDistribution | None


class LinkSurroundings(NamedTuple):
    """The known facts of a link besides its inertia.

    Attributes:
        points: Origins of its frames and of its children's joints, in the link frame, m.
        twins: Links of the same part whose mirror image it may be but for a mistake, the one on
            the other side first.
        share: How many of the links of the same part are possible, if there are twins.
        mass: The middle one of the robot's links, kg; zero if there are few.
        copies: Unlike links that have the same moments, or CoM, and which of these.
    """

    points: tuple[Vector3, ...]
    twins: tuple[Twin, ...]
    share: float
    mass: float = 0.0
    copies: tuple[tuple[str, str], ...] = ()

    @property
    def end(self) -> Vector3 | None:
        """The farthest of its points, None where none is known."""
        return max(self.points, key=lambda point: hypot(*point), default=None)


_SURROUNDINGS = Fact[tuple[object, LinkSurroundings]]("surroundings")


class Evidence(NamedTuple):
    """The evidence for a hypothesis.

    Attributes:
        log_weight: A logarithm to add.
        reasons: Why, in words.
        agreement: Of a body with its counterparts: 1 with one but for its signs, 2 with all.
    """

    log_weight: float
    reasons: tuple[str, ...] = ()
    agreement: int = 0


def surroundings(model: Model, values: Mapping[str, float], found: Judgement) -> LinkSurroundings:
    """Return what is known of a link besides its inertia; looked at again where that changes."""
    link, namesakes = found.link, _namesakes(model, found.link)
    made_of = (
        found,
        values,
        model.edition.facts(Aspect.STRUCTURE | Aspect.PLACES),
        model.tree.joints_on(link),
        namesakes,
        [_bodies_with(model, telling) for telling in _telling_numbers(link)],
        middle_mass(model),
    )
    look = partial(_surroundings, model, values, found, namesakes)
    return link.facts.made_of(_SURROUNDINGS, made_of, look)


def _surroundings(
    model: Model, values: Mapping[str, float], found: Judgement, namesakes: Iterable[Link]
) -> LinkSurroundings:
    link = found.link
    points = _points(model, values, link)
    alike = list(_with_inertia(namesakes, values))
    possible = [each for each in alike if not is_impossible(each[0], values)]
    twins = _twins(model, values, found, possible)
    return LinkSurroundings(
        points,
        twins,
        len(possible) / len(alike) if twins else 0.0,
        middle_mass(model),
        tuple(copies(model, values, link)),
    )


def _points(model: Model, values: Mapping[str, float], link: Link) -> tuple[Vector3, ...]:
    """Return where a link's frames and its children's joints are, none beside its origin."""
    if link.inertia is None or link.inertia.frame is not None:
        return ()
    poses = [frame.pose for frame in link.frames]
    edges = model.tree.successor_edges(link)
    poses += [edge.joint.pose for edge in edges if edge.joint is not None]
    placed = (written_pose(pose, values) for pose in poses)
    points = (place.translation for place in placed if place is not None)
    return tuple(point for point in points if _NEAR < hypot(*point) < GREATEST_LENGTH)


def farthest_end(model: Model, values: Mapping[str, float], link: Link) -> Vector3 | None:
    """Return the farthest of a link's frames and children's joints, None where none is known."""
    return LinkSurroundings(_points(model, values, link), (), 0.0).end


def reasons_of_end(h: Hypothesis, shape: MassShape, end: Vector3 | None) -> Iterator[str]:
    """Yield in words what the place of a link's end says of a hypothesis."""
    if end is None:
        return
    _, middle, long = shape.pairs
    if long.value > _ELONGATED * max(middle.value, 0.0):
        along = abs(dot(long.axis, end)) / hypot(*end)
        if along > _ALONG:
            yield "long towards its next joint"
        elif along < _ACROSS:
            yield "though then long across its link"
    if {Slip.COM_SIGN, Slip.COM_ORDER} & set(h.slips) and dot(h.body.com, end) > 0.0:
        yield "CoM on the side of its next joint"


def of_counterparts(body: MassDistribution, around: LinkSurroundings) -> Evidence:
    """Return what the counterpart that says most says of a body."""
    images = [twin for twin in around.twins if is_mirror_image(body, twin.body)]
    said = [_of_image(body, twin, around.share) for twin in images]
    return max(said, key=lambda each: each.log_weight, default=Evidence(0.0))


def _of_image(body: MassDistribution, twin: Twin, share: float) -> Evidence:
    """Return what a mirror image says: most where the body is as it expects it."""
    is_equal = is_same_body(body, twin.body)
    is_expected = twin.expected is not None and is_same_body(body, twin.expected)
    return Evidence(
        EXPECTED + log(share) if is_expected else MIRRORED,
        (f"{'equal to' if is_equal else 'mirror image of'} '{twin.name}'",),
        2 if is_expected else 1,
    )


def is_mirror_image(one: MassDistribution, other: MassDistribution) -> bool:
    """Return whether axes turned round by some signs, or none, make one body the other."""
    return (
        _is_near(one.mass, other.mass)
        and _are_near([*map(abs, one.com)], [*map(abs, other.com)])
        and _are_near([*map(abs, one.moments)], [*map(abs, other.moments)])
        and any(is_same_body(image, other) for image in images(one))
    )


def images(body: MassDistribution) -> Iterator[MassDistribution]:
    """Yield a body with some, or none, of its axes turned round."""
    return (seen_by(body, C) for C in REFLECTIONS)


def may_be_image(one: MassDistribution, other: MassDistribution) -> bool:
    """Return whether a mistake of the table may be all that keeps one body from being the other.

    It may change the order and the signs of a CoM, a mass by powers of ten, and any moment.
    """
    power = round(log10(one.mass / other.mass))
    return _is_near(one.mass, other.mass * 10.0**power) and _are_near(
        sorted(map(abs, one.com)), sorted(map(abs, other.com))
    )


def is_same_body(one: MassDistribution, other: MassDistribution) -> bool:
    """Return whether all ten numbers agree but for a little of the greatest of their kind."""
    return (
        _is_near(one.mass, other.mass)
        and _are_near(one.com, other.com)
        and _are_near(one.moments, other.moments)
    )


def _is_near(one: float, other: float) -> bool:
    return abs(one - other) <= _SAME * max(abs(one), abs(other))


def _are_near(one: Sequence[float], other: Sequence[float]) -> bool:
    size = max(map(abs, (*one, *other)))
    return all(abs(a - b) <= _SAME * size for a, b in zip(one, other, strict=True))


@kept
def middle_mass(model: Model) -> float:
    """Return the lower median of the masses that are written as numbers, zero of one or two."""
    moving = [b.inertia.mass for b in model.bodies if b.inertia is not None and is_moving(b)]
    masses = sorted(m.literal for m in moving if m is not None and m.literal)
    middle = masses[(len(masses) - 1) // 2] if len(masses) >= _FEWEST_MASSES else 0.0
    return max(middle, 0.0)


def copies(model: Model, values: Mapping[str, float], link: Link) -> Iterator[tuple[str, str]]:
    """Yield the possible links of other parts that have the moments, or the CoM, of a link.

    What a twin of the link has besides, but for signs, is their own.
    """
    owned = [numbers for twin in _namesakes(model, link) for numbers in _telling_numbers(twin)]
    part = label_of(str(link.name)).part
    for telling in _telling_numbers(link):
        if not any(telling.is_as(each, abs) for each in owned):
            for other in _bodies_with(model, telling):
                is_other = label_of(str(other.name)).part != part
                if is_other and not is_impossible(other, values):
                    yield str(other.name), telling.what


def same_moments(model: Model, link: Link) -> Iterator[str]:
    """Yield the names of links that have the moments of a link and are not its twins by name."""
    words = label_of(str(link.name)).words
    for telling in _telling_numbers(link)[:1]:
        names = map(str, (other.name for other in _bodies_with(model, telling)))
        if telling.what == "moments":
            yield from (name for name in names if label_of(name).words != words)


class _Telling(NamedTuple):
    """Numbers that no two bodies have by chance: the `moments` or the `CoM`."""

    what: str
    numbers: tuple[float, ...]

    @property
    def size(self) -> int:
        """The order of magnitude, finely: what is the same has this one, or one next to it."""
        return round(log(max(map(abs, self.numbers))) / _NEXT)

    def is_as(self, other: "_Telling", seen: Callable[[float], float] = float) -> bool:
        """Return whether others are the same, as far as copies with fewer digits are."""
        pairs = zip(map(seen, self.numbers), map(seen, other.numbers), strict=False)
        return self.what == other.what and all(isclose(a, b, rel_tol=_ROUNDED) for a, b in pairs)


def _bodies_with(model: Model, telling: _Telling) -> list[Link]:
    """Return some links that have these numbers."""
    near = (telling.size + step for step in (-1, 0, 1))
    known = _bodies_by_size(model)
    found = (each for size in near for each in known.get((telling.what, size), ()))
    return list(islice((body for body, own in found if telling.is_as(own)), _MOST_PARTS))


@kept
def _bodies_by_size(model: Model) -> dict[tuple[str, int], list[tuple[Link, _Telling]]]:
    found: dict[tuple[str, int], list[tuple[Link, _Telling]]] = {}
    for body in model.bodies:
        for telling in _telling_numbers(body):
            found.setdefault((telling.what, telling.size), []).append((body, telling))
    return found


@kept
def _telling_numbers(body: Link) -> list[_Telling]:
    """Return the moments and the CoM of a body where no two bodies have them by chance."""
    inertia, found = body.inertia, []
    if inertia is None or inertia.com is None:
        return []
    moments = tuple(inertia.moments.values())
    for what, group in (("moments", moments), ("CoM", inertia.com.components)):
        digits = {abs(v.literal): significant_digits(v.text) for v in group if v.literal}
        is_told = len(digits) > 1 and sum(digits.values()) >= _FEWEST_DIGITS
        if is_told and all(map(isfinite, digits)):
            found.append(_Telling(what, tuple(value.literal or 0.0 for value in group)))
    return found


def _with_inertia(links: Iterable[Link], values: Mapping[str, float]) -> Iterator[_Inertia]:
    """Yield the links that have a mass, with their inertias."""
    for other in links:
        if other.inertia is not None:
            body = mass_distribution(other.inertia, values)
            if body is not None and body.mass > 0.0:
                yield other, body


def _twins(
    model: Model, values: Mapping[str, float], found: Judgement, possible: Sequence[_Inertia]
) -> tuple[Twin, ...]:
    """Return those that may be images, and what all possible links let expect of this one."""
    twins = [each for each in possible if may_be_image(found.body, each[1])]
    expected = _expected(model, values, found.link, possible) if twins else None
    mirror = other_side(str(found.link.name)) if len(twins) > 1 else None
    nearest_first = sorted(twins, key=lambda twin: twin[0].name != mirror)
    return tuple(Twin(str(other.name), body, expected) for other, body in nearest_first)


def _expected(
    model: Model, values: Mapping[str, float], link: Link, twins: Sequence[_Inertia]
) -> MassDistribution | None:
    """Return the inertia that all twins let expect, None where they do not agree."""
    masses = [body.mass for _, body in twins]
    agreed: list[MassDistribution] | None = None
    for other, body in twins if all(_is_near(mass, masses[0]) for mass in masses) else ():
        seen = [seen_by(body, transposed(C)) for C in _frames(model, values, link, other)]
        if agreed is None:
            agreed = seen
        agreed = [each for each in agreed if any(is_same_body(each, own) for own in seen)]
        if not agreed:
            return None
    return agreed[0] if agreed else None


def _frames(model: Model, values: Mapping[str, float], link: Link, other: Link) -> list[Rotation]:
    """Return `twin_frames`, none where an inertia is given in a frame that is not the link's."""
    inertias = [body.inertia for body in (link, other) if body.inertia is not None]
    if any(inertia.frame is not None for inertia in inertias):
        return []
    places = model.edition.facts(Aspect.STRUCTURE | Aspect.PLACES)
    known = places.made_of(_FRAMES, values, dict)
    names = str(link.name), str(other.name)
    if names not in known:
        known[names] = twin_frames(model.tree, link, other, values)
    return known[names]


def _namesakes(model: Model, link: Link) -> list[Link]:
    """Return the same part on the other side or at other legs: with its numbers, else without."""
    label, parts = label_of(str(link.name)), _parts(model)
    numbered = [other for other in parts.get((True, label.words), ()) if other is not link]
    return numbered or [o for o in parts.get((False, label.part), ()) if o is not link]


@kept
def _parts(model: Model) -> dict[tuple[bool, tuple[str, ...]], list[Link]]:
    """Return some bodies of each name without sides, with their numbers and without."""
    parts: dict[tuple[bool, tuple[str, ...]], list[Link]] = {}
    for body in model.bodies:
        label = label_of(str(body.name))
        for key in ((True, label.words), (False, label.part)) if label.part else ():
            if len(parts.setdefault(key, [])) < _MOST_PARTS:
                parts[key].append(body)
    return parts
