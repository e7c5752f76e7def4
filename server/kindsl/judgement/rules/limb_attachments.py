"""Findings on links that hang on another body, or move by another joint, than their peers."""

from collections.abc import Callable, Iterable, Iterator

from kindsl.judgement.rules.base import Finding, Related
from kindsl.language.semantics.places import Located
from kindsl.robots.limbs.attachments import Attachment, LimbNames, Misplaced

_PlaceOf = Callable[[str], Located]
# A finding, and the links that would have to change places.
_Found = Iterator[tuple[Finding, list[Misplaced]]]


def elsewhere_findings(names: LimbNames, place_of: _PlaceOf) -> _Found:
    """Yield what is said of links that another body carries than their peers let expect.

    Args:
        names: Of the robot's links and joints.
        place_of: Returns where it is written what carries a link.
    """
    found = names.elsewhere
    if len(found) == 2 and found[1].attachment in found[0].peers:
        # Of a left and a right link alone either may be the wrong one.
        one, other = (each.attachment for each in found)
        message = f"link '{one.link}' is a child of '{one.parent}', '{other.link}' of "
        message += f"'{other.parent}': one of the two sides is attached wrongly"
        yield Finding(place_of(one.link), message, _carried([other], place_of)), found
        return
    for each in found:
        (name, parent, _), meant, peers = each
        twins = ("twins" if len(peers) > 1 else "twin") if peers else "name"
        by_peers = f"by its {twins} of '{meant}'" if meant else "unlike its twin"
        others = [other.attachment for other in found if other is not each]
        related = _carried((*others, *peers), place_of)
        message = f"link '{name}' is a child of '{parent}', {by_peers}"
        yield Finding(place_of(name), message, related), [each]


def crossed_findings(names: LimbNames, place_of: _PlaceOf) -> _Found:
    """Yield what is said of links that move by another joint than their peers let expect.

    Two that have each other's joints are told of once, and so are those of two sides.

    Args:
        names: Of the robot's links and joints.
        place_of: Returns where it is written by which joint a link moves.
    """
    told: list[Misplaced] = []
    for each in names.crossed:
        if each not in told:
            (name, _, joint), meant, peers = each
            partners = [other for other in names.crossed if _are_exchanged(other, each)][:1]
            own = [each.attachment, *(partner.attachment for partner in partners)]
            of_peers = [r for r in names.crossed if not {*own}.isdisjoint(r.peers)]
            rivals = of_peers if partners else []
            told += (*partners, *rivals)
            by = f"by its {'twins' if peers else 'name'} by '{meant}'" if meant else ""
            message = f"link '{name}' moves by joint '{joint}', {by or 'unlike its twin'}"
            if rivals:
                (link, _, other), *_ = rivals[0]
                message = f"link '{name}' moves by joint '{joint}', '{link}' by '{other}': the "
                message += "joints of one of the two sides are exchanged"
            others = (*own[1:], *peers)
            moved = ((place_of(a.link), f"'{a.link}' moves by '{a.joint}'") for a in others)
            related = tuple(Related(*other) for other in moved)
            yield Finding(place_of(name), message, related), [each, *partners, *rivals]


def _carried(links: Iterable[Attachment], place_of: _PlaceOf) -> tuple[Related, ...]:
    return tuple(Related(place_of(a.link), f"'{a.link}' is a child of '{a.parent}'") for a in links)


def _are_exchanged(one: Misplaced, other: Misplaced) -> bool:
    return one.meant == other.attachment.joint and other.meant == one.attachment.joint
