"""Names and numbers that nothing has yet, in the manner of those that are there."""

from collections.abc import Collection, Sequence
from itertools import count

from kindsl.frontends.features.names_taken import names_taken
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Link


def fresh_link(analysis: Analysis) -> str:
    """Return a name for a new link: `link4` behind `link3`."""
    return _fresh([link.name for link in analysis.model.links], "link", names_taken(analysis.model))


def fresh_joint(analysis: Analysis, child: str = "") -> str:
    """Return a name for a new joint: `joint4` behind `joint3`, else told by the child it moves."""
    names: list[str] = [joint.name for joint in analysis.model.joints]
    names += [child.joint for body in analysis.model.bodies for child in body.children]
    stem = f"{child}_joint" if child and names else "joint"
    return _fresh(names, stem, names_taken(analysis.model))


def next_id(analysis: Analysis, own: Collection[Link] = ()) -> int:
    """Return the smallest id that no link has, those of one's own left out."""
    taken = {link.id for link in analysis.model.links if link not in own}
    return next(number for number in count(1) if number not in taken)


def _fresh(names: Sequence[str], stem: str, taken: Collection[str]) -> str:
    """Return the next name of the last numbered ones, else the stem, with a number if need be."""
    first = 1
    last = next(filter(_is_numbered, reversed(names)), "")
    if last:
        stem = last
        while _is_numbered(stem):
            stem = stem[:-1]
        ends = [name[len(stem) :] for name in set(names) if name.startswith(stem)]
        first = 1 + max(map(int, filter(str.isdecimal, ends)))
    elif stem not in ("link", "joint") and stem not in taken:
        return stem
    numbered = (f"{stem}{number}" for number in count(first))
    return next(name for name in numbered if name not in taken)


def _is_numbered(name: str) -> bool:
    return name[-1:].isdecimal()
