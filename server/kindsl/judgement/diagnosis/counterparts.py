"""Links that may be images of one another: by their names, or by digits no two have by chance."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from itertools import chain, islice, permutations
from math import isclose, isfinite, log
from typing import NamedTuple

from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.text.decimals import significant_digits
from kindsl.language.text.facts import Fact, kept
from kindsl.language.text.groups import grouped
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.limbs.mounts import REFLECTIONS
from kindsl.robots.limbs.names import label_of
from kindsl.robots.limbs.weighing import seen_by

FEWEST_DIGITS = 7
# Numbers are copied with their digits rounded, too; sizes are told apart hardly more finely.
_ROUNDED, _NEXT = 5e-5, 1e-4
_MOST_PARTS = 8
SAME = 0.02
_PLACES = Fact[tuple[object, dict[str, tuple[int, ...]]]]("places of parts, by names")


def namesakes(model: Model, link: Link) -> list[Link]:
    """Return the same part on the other side or at other legs: with its numbers, else without."""
    return [other for other in _parts(model).get(str(link.name), ()) if other is not link]


def counterparts(model: Model, link: Link) -> list[Link]:
    """Return the namesakes of a link, and other links with the same moments or CoM."""
    return listed_but(link, may_be_counterparts(model, link))


def listed_but(link: Link, lists: Iterable[Iterable[Link]]) -> list[Link]:
    """Return the links of some lists, each once, but for one."""
    return [other for other in dict.fromkeys(chain.from_iterable(lists)) if other is not link]


def may_be_counterparts(model: Model, link: Link) -> tuple[Sequence[Link], Sequence[Link]]:
    """Return some links of a part, and some with the same moments or CoM; the link itself may be.

    Links of one part have the same list, which is cheaper than the counterparts of each.
    """
    telling = telling_numbers(link)
    shared = [other for each in telling for other in bodies_with(model, each)] if telling else ()
    return _parts(model).get(str(link.name), ()), shared


@kept
def _parts(model: Model) -> dict[str, list[Link]]:
    """Return some bodies of the same part as each name."""
    names = model.edition.facts(Aspect.STRUCTURE).made_of(_PLACES, (), partial(_places, model))
    bodies = model.bodies
    parts = {places: [bodies[place] for place in places] for places in set(names.values())}
    return {name: parts[places] for name, places in names.items()}


def _places(model: Model) -> dict[str, tuple[int, ...]]:
    """Return where some bodies of the same part as each name stand among all."""
    numbered: dict[tuple[str, ...], list[int]] = {}
    parts: dict[tuple[str, ...], list[int]] = {}
    labels = {name: label_of(name) for name in (str(body.name) for body in model.bodies)}
    for place, body in enumerate(model.bodies):
        label = labels[str(body.name)]
        for known, key in ((numbered, label.words), (parts, label.part)):
            if len(known.setdefault(key, [])) < _MOST_PARTS:
                known[key].append(place)
    return {
        name: tuple(numbered[words] if len(numbered[words]) > 1 else parts[part])
        for name, (_, _, words, part) in labels.items()
        if part
    }


class TellingNumbers(NamedTuple):
    """Numbers that no two bodies have by chance: the `moments` or the `CoM`."""

    what: str
    numbers: tuple[float, ...]

    @property
    def size(self) -> int:
        """The order of magnitude, finely: what is the same has this one, or one next to it."""
        return round(log(sum(map(abs, self.numbers))) / _NEXT)

    def is_as(self, other: "TellingNumbers", seen: Callable[[float], float] = float) -> bool:
        """Return whether others are the same, as far as copies with fewer digits are."""
        pairs = zip(map(seen, self.numbers), map(seen, other.numbers), strict=False)
        return self.what == other.what and all(isclose(a, b, rel_tol=_ROUNDED) for a, b in pairs)


def bodies_with(model: Model, telling: TellingNumbers) -> list[Link]:
    """Return some links that have these numbers."""
    near = (telling.size + step for step in (-1, 0, 1))
    known = _bodies_by_size(model)
    found = (each for size in near for each in known.get((telling.what, size), ()))
    return list(islice((body for body, own in found if telling.is_as(own)), _MOST_PARTS))


@kept
def _bodies_by_size(model: Model) -> dict[tuple[str, int], list[tuple[Link, TellingNumbers]]]:
    found = ((body, telling) for body in model.bodies for telling in telling_numbers(body))
    return grouped(((telling.what, telling.size), (body, telling)) for body, telling in found)


@kept
def telling_numbers(body: Link) -> list[TellingNumbers]:
    """Return the moments and the CoM of a body where no two bodies have them by chance."""
    inertia, found = body.inertia, []
    if inertia is None or inertia.com is None:
        return []
    moments = tuple(inertia.moments.values())
    for what, group in (("moments", moments), ("CoM", inertia.com.components)):
        digits = {abs(v.literal): significant_digits(v.text) for v in group if v.literal}
        is_told = len(digits) > 1 and sum(digits.values()) >= FEWEST_DIGITS
        numbers = tuple(value.literal or 0.0 for value in group)
        if is_told and isfinite(sum(map(abs, numbers))):
            found.append(TellingNumbers(what, numbers))
    return found


def is_mirror_image(one: MassDistribution, other: MassDistribution, within: float = SAME) -> bool:
    """Return whether flipping axis signs, or none, maps one body onto the other."""
    return all(_agreeing(one, other, within)) and any(
        is_same_body(image, other, within) for image in images(one)
    )


def is_turned_image(one: MassDistribution, other: MassDistribution, within: float) -> bool:
    """Return whether some order and signs of the axes map one body onto the other."""
    (a, b, c), (xx, yy, zz, xy, xz, yz) = one.com, one.moments
    com, moments = (a, b, c), ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    for i, j, k in permutations(range(3)):
        diagonal = moments[i][i], moments[j][j], moments[k][k]
        turned = (*diagonal, moments[i][j], moments[i][k], moments[j][k])
        if is_mirror_image(
            one._replace(com=(com[i], com[j], com[k]), moments=turned), other, within
        ):
            return True
    return False


def images(body: MassDistribution) -> Iterator[MassDistribution]:
    """Yield a body with some, or none, of its axes turned round."""
    return (seen_by(body, C) for C in REFLECTIONS)


def may_be_image(one: MassDistribution, other: MassDistribution, within: float = SAME) -> bool:
    """Return whether one mistake may keep one body from being the image of the other.

    It changes the mass, the CoM or the moments, so that the two others agree but for signs.
    """
    agreeing = _agreeing(one, other, within)
    n = next(agreeing) + next(agreeing)
    return n > 1 or (n == 1 and next(agreeing))


def _agreeing(one: MassDistribution, other: MassDistribution, within: float) -> Iterator[bool]:
    """Yield whether mass, CoM and moments agree but for signs."""
    yield abs(one.mass - other.mass) <= within * max(one.mass, other.mass)
    for here, there in ((one.com, other.com), (one.moments, other.moments)):
        yield here == there or are_near([*map(abs, here)], [*map(abs, there)], within)


def is_same_body(one: MassDistribution, other: MassDistribution, within: float = SAME) -> bool:
    """Return whether all ten numbers agree but for a share of the greatest of their kind."""
    return next(unlike_numbers(one, other, within), None) is None


def unlike_numbers(one: MassDistribution, other: MassDistribution, within: float) -> Iterator[str]:
    """Yield which of `mass`, `CoM` and `moments` do not agree."""
    pairs = ([one.mass], [other.mass]), (one.com, other.com), (one.moments, other.moments)
    named = zip(("mass", "CoM", "moments"), pairs, strict=True)
    return (name for name, (here, there) in named if not are_near(here, there, within))


def are_near(one: Sequence[float], other: Sequence[float], within: float = SAME) -> bool:
    """Return whether numbers of one kind agree but for a share of the greatest."""
    size = max(map(abs, (*one, *other)), default=0.0)
    return all(abs(a - b) <= within * size for a, b in zip(one, other, strict=True))
