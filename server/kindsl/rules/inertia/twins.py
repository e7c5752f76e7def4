"""Links that are the same part on another side, told by their names."""

import re
from collections.abc import Mapping

from kindsl.rules.memory import Memory
from kindsl.semantics.declarations import Link

_PART = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
_SIDES = {
    "l": "r", "lf": "rf", "lh": "rh", "lr": "rr", "lb": "rb", "lm": "rm",
    "fl": "fr", "hl": "hr", "rl": "rr", "bl": "br", "ml": "mr", "left": "right",
}  # fmt: skip
_LEFT_OF = {right: left for left, right in reversed(_SIDES.items())}
_EITHER = frozenset(_SIDES) | frozenset(_SIDES.values())
_ENDS = frozenset(("front", "hind", "rear", "back", "middle", "mid", "fore"))
_PARTS = Memory[str]("part")
_TWINS = Memory[str | None]("right twin")


def part_of(body: Link) -> str:
    """Return which part a body is, as `part_name` does; found once in its life."""
    return _PARTS.of(body, (), lambda: part_name(body.name))


def right_twin_of(body: Link) -> str | None:
    """Return the name of a left body's twin, as `mirrored_name` does; found once in its life."""
    return _TWINS.of(body, (), lambda: mirrored_name(body.name))


def part_name(name: str) -> str:
    """Return a name without sides and numbers: `LF_upper_leg2` and `rightUpperLeg` are one part."""
    parts = [part.lower() for part in _PART.findall(name)]
    return " ".join(part for part in parts if part not in _EITHER and part not in _ENDS)


def mirrored_name(name: str) -> str | None:
    """Return the name of the right twin of a left part, None for any other name.

    Only a whole word of the name can tell the side: `LF_hip`, `left_arm`, `armLeft`, `wheel_l`.
    """
    return _with_side(name, _SIDES)


def other_side(name: str) -> str | None:
    """Return the name of the twin of a left or a right part, None where no word tells a side."""
    return _with_side(name, _SIDES) or _with_side(name, _LEFT_OF)


def _with_side(name: str, sides: Mapping[str, str]) -> str | None:
    for match in _PART.finditer(name):
        other = sides.get(match[0].lower())
        if other is not None:
            if match[0].isupper():
                other = other.upper()
            elif match[0][0].isupper():
                other = other.capitalize()
            return name[: match.start()] + other + name[match.end() :]
    return None
