"""Names and numbers that nothing has yet, in the manner of those that are there."""

import re
from collections.abc import Collection

from kindsl.analysis.analysis import Analysis
from kindsl.semantics.declarations import Link

_NUMBERED = re.compile(r"(.*?)(\d+)")


def fresh_link(analysis: Analysis) -> str:
    """Return a name for a new link: `link4` behind `link3`."""
    return _fresh([str(link.name) for link in analysis.model.links], "link", _taken(analysis))


def fresh_joint(analysis: Analysis, child: str = "") -> str:
    """Return a name for a new joint: `joint4` behind `joint3`, else told by the child it moves."""
    names = [str(joint.name) for joint in analysis.model.joints]
    names += [str(c.joint) for body in analysis.model.bodies for c in body.children]
    is_numbered = any(_NUMBERED.fullmatch(name) for name in names)
    stem = f"{child}_joint" if child and names and not is_numbered else "joint"
    return _fresh(names if is_numbered else [], stem, _taken(analysis))


def next_id(analysis: Analysis, own: Link | None = None) -> int:
    """Return the smallest id that no link has, a link of one's own left out."""
    taken = {link.id for link in analysis.model.links if link is not own}
    return next(number for number in range(1, len(taken) + 2) if number not in taken)


def _fresh(names: list[str], stem: str, taken: Collection[str]) -> str:
    """Return the next name of the last numbered ones, else the stem, with a number if need be."""
    matches = [match for name in names if (match := _NUMBERED.fullmatch(name))]
    if matches:
        stem = matches[-1][1]
        first = 1 + max(int(match[2]) for match in matches if match[1] == stem)
    elif stem not in ("link", "joint") and stem not in taken:
        return stem
    else:
        first = 1
    numbers = range(first, first + len(taken) + 1)
    return next(f"{stem}{number}" for number in numbers if f"{stem}{number}" not in taken)


def _taken(analysis: Analysis) -> set[str]:
    """Return every name that something has, or is called by."""
    model = analysis.model
    names = {str(body.name) for body in model.bodies} | {str(frame.name) for frame in model.frames}
    names |= {str(joint.name) for joint in model.joints}
    names |= {str(n) for body in model.bodies for child in body.children for n in child[:2]}
    return names | {model.name}
