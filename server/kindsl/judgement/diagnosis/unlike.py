"""Links that agree with others of the robot in two of mass, CoM and moments, not in the third."""

from collections.abc import Callable, Iterable
from functools import partial
from typing import NamedTuple

from kindsl.judgement.diagnosis.counterparts import (
    FEWEST_DIGITS,
    is_mirror_image,
    is_turned_image,
    listed_but,
    may_be_counterparts,
    may_be_image,
)
from kindsl.judgement.diagnosis.judgements import is_impossible, is_moving, is_plain
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.text.decimals import significant_digits
from kindsl.language.text.facts import Fact, kept
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.limbs.names import label_of, other_sides

# Numbers that were made alike agree in their digits, a left and a right part of a CAD program
# nearly: then only a slip that takes them from far apart to as near as the rest is told. Half and
# twice of these change nothing in 122 robots as they are, nor in 250 planted slips.
EXACTLY, NEARLY, APART = 1e-3, 0.01, 0.05
# Digits that agree between links of one name, which may be typed by hand.
_OF_NAMESAKES = 4

_Compared = tuple[bool, "Unlike | None"]
_COMPARED = Fact[tuple[object, _Compared]]("counterparts compared")


class Unlike(NamedTuple):
    """A link that no other one of its part is the image of.

    Attributes:
        body: Its numbers.
        peers: Links that are images of one another, and nearly of it, with their numbers.
        within: How near they are, as a share of the greatest number of a kind.
        is_usual: Whether more pairs of the robot differ than agree.
    """

    link: Link
    body: MassDistribution
    peers: tuple[tuple[Link, MassDistribution], ...]
    within: float
    is_usual: bool = False

    @property
    def is_outvoted(self) -> bool:
        """Whether there are two of them or more; of a pair either may be wrong."""
        return len(self.peers) > 1


@kept
def unlike_links(model: Model) -> list[Unlike]:
    """Return the links whose numbers are plain and differ from those of their counterparts."""
    return unlike_among(model, _body)


def unlike_among(model: Model, body_of: Callable[[Link], MassDistribution | None]) -> list[Unlike]:
    """Return the links whose numbers differ from those of their counterparts.

    Of a pair the first one is returned. Frames that lie otherwise explain a difference.

    Args:
        body_of: Returns the numbers of a link as they are written, None of one that is left out.
    """
    found: dict[Link, Unlike] = {}
    n_alike = 0
    for link in model.bodies:
        near = may_be_counterparts(model, link)
        compared = partial(_compared, link, near, body_of)
        is_alike, unlike = link.facts.made_of(_COMPARED, (body_of, near), compared)
        n_alike += is_alike
        if unlike is not None and (unlike.is_outvoted or unlike.peers[0][0] not in found):
            found[link] = unlike
    n_pairs = sum(not each.is_outvoted for each in found.values())
    is_usual = n_pairs > max(1, n_alike // 2)
    return [u._replace(is_usual=is_usual and not u.is_outvoted) for u in found.values()]


def _compared(
    link: Link, near: Iterable[Iterable[Link]], body_of: Callable[[Link], MassDistribution | None]
) -> _Compared:
    """Return whether a link is the image of another one, and of which it is nearly."""
    body = body_of(link)
    if body is None:
        return False, None
    others = [(o, b) for o in listed_but(link, near) if (b := body_of(o)) is not None]
    names = tuple(other_sides(str(link.name)))
    named = [(o, b) for o, b in others if str(o.name) in names]
    is_alike, unlike = _unlike(link, body, others, EXACTLY, EXACTLY)
    if is_alike or unlike is not None or not named:
        return is_alike, unlike
    return _unlike(link, body, named, NEARLY, APART)


def _unlike(
    link: Link,
    body: MassDistribution,
    others: list[tuple[Link, MassDistribution]],
    within: float,
    apart: float,
) -> _Compared:
    """Return the same of links that agree within a share, and differ by another one."""
    near = [each for each in others if may_be_image(body, each[1], within)]
    if not near or any(is_mirror_image(body, each, apart) for _, each in near):
        return bool(near), None
    other, first = near[0]
    are_named = label_of(str(link.name)).words == label_of(str(other.name)).words
    if (
        all(is_mirror_image(first, each, within) for _, each in near[1:])
        and not is_turned_image(body, first, apart)
        and _n_digits_shared(body, first, within) >= (_OF_NAMESAKES if are_named else FEWEST_DIGITS)
        and not any(is_impossible(each, {}) for each in (link, *(peer for peer, _ in near)))
    ):
        return False, Unlike(link, body, tuple(near), within)
    return False, None


def _n_digits_shared(one: MassDistribution, other: MassDistribution, within: float) -> int:
    """Return how many digits of different numbers two bodies have alike."""
    pairs = zip(one.numbers, other.numbers, strict=True)
    same = {f"{abs(a):.6g}" for a, b in pairs if a and abs(abs(a) - abs(b)) <= within * abs(a)}
    return sum(map(significant_digits, same))


@kept
def _body(link: Link) -> MassDistribution | None:
    inertia = link.inertia
    if inertia is None or inertia.frame is not None or not is_moving(link) or not is_plain(inertia):
        return None
    body = mass_distribution(inertia, {})
    return body if body is not None and body.mass > 0.0 else None
