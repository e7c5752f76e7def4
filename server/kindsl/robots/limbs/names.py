"""Sides and rows in names: `LF_upper_leg`, `rightArm`, `leg3_coxa`."""

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import chain, product
from typing import NamedTuple

# What a letter of a side is written before without a break: `lfoot`, `Rarm`.
_OF_BODY = (
    "ankle|arm|clavicle|elbow|eye|femur|finger|foot|forearm|hand|hip|humerus|knee|leg|radius|shin"
    "|shoulder|thigh|thumb|tibia|toe|wheel|wrist"
)
_TOKEN = re.compile(
    rf"(?<![A-Za-z])[lrLR](?=(?:{_OF_BODY})s?(?![a-z]))|[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+"
)
_SIDES = {
    "l": "r", "lf": "rf", "lh": "rh", "lr": "rr", "lb": "rb", "lm": "rm",
    "fl": "fr", "hl": "hr", "rl": "rr", "bl": "br", "ml": "mr", "left": "right",
    # German, with vorne and hinten; Italian, Spanish, French; of ships.
    "vl": "vr", "links": "rechts", "linke": "rechte", "linker": "rechter", "linkes": "rechtes",
    "sx": "dx", "sinistra": "destra", "sinistro": "destro",
    "izq": "der", "izquierda": "derecha", "izquierdo": "derecho", "gauche": "droite",
    "port": "starboard",
}  # fmt: skip
_PAIRS = (*_SIDES.items(), ("port", "stbd"))
_EITHER = frozenset(chain.from_iterable(_PAIRS))
_ROWS = {
    "front": "F", "fore": "F", "hind": "H", "rear": "H", "back": "H", "middle": "M", "mid": "M",
    "vorne": "F", "vorn": "F", "hinten": "H", "mitte": "M", "fwd": "F", "aft": "H",
    "anteriore": "F", "posteriore": "H", "ant": "F", "med": "M", "post": "H",
    "delantera": "F", "delantero": "F", "trasera": "H", "trasero": "H", "avant": "F",
    "arriere": "H",
}  # fmt: skip
_ROW_LETTERS = {"f": "F", "v": "F", "h": "H", "r": "H", "b": "H", "m": "M"}
# What a limb holds is mounted in any way, often as like copies on both sides.
_HELD = frozenset((
    "gripper", "tool", "hand", "finger", "fingertip", "thumb", "index", "middle", "ring", "pinky",
    "palm", "claw", "flange", "ee", "mf", "th", "ff", "greifer", "werkzeug", "daumen", "pinza",
    "mano", "dito", "pince", "doigt", "dedo",
))  # fmt: skip

# Of a hand, whose ring and little fingers are `rf` and `lf`.
_BONES = frozenset((
    "prox", "proximal", "medial", "dist", "distal", "meta", "metacarpal", "phalanx", "mcp", "pip",
    "dip",
))  # fmt: skip
# What anything may be called.
_SAYING_NOTHING = frozenset(("link", "body", "part", "frame", "mount"))


class LimbLabel(NamedTuple):
    """The place of a part, as its name has it.

    Attributes:
        side: `L`, `R` or nothing.
        row: `F`, `M`, `H` or nothing.
        words: The other words and numbers, in lower case.
        part: The words without numbers, which all parts of a kind share.
    """

    side: str
    row: str
    words: tuple[str, ...]
    part: tuple[str, ...]


# As many as the largest documents have names: all are asked for at each key.
@lru_cache(maxsize=32_768)
def label_of(name: str) -> LimbLabel:
    """Return what a name says; only whole words tell a side or a row, the first of each.

    A further side is one of the words, as the same one or the other one.
    """
    side = row = ""
    words = []
    marks = {mark.start() for mark in _marks(name)}
    for match in _TOKEN.finditer(name):
        word = match[0].lower()
        if match.start() in marks and not side:
            side, row = _side_and_row(word, row)
        elif match.start() in marks:
            words.append("same" if _side_and_row(word, "")[0] == side else "other")
        elif word in _ROWS and not row:
            row = _ROWS[word]
        else:
            words.append(word)
    return LimbLabel(side, row, tuple(words), tuple(w for w in words if not w.isdigit()))


@lru_cache(maxsize=4096)
def tokens(name: str) -> tuple[str, ...]:
    """Return the words and numbers of a name, in lower case."""
    return tuple([token.lower() for token in _TOKEN.findall(name)])


def is_held(*names: str) -> bool:
    """Return whether names are those of something that a limb holds: a hand, a tool."""
    return any(token in _HELD for name in names for token in tokens(name))


def are_named_alike(names: Sequence[str]) -> bool:
    """Return whether names share what they end with, but for a letter, and differ by one word.

    `index_knuckle` and `ring_knuckle` do, and `wheel_x` and `wheel_y`.
    """
    words = [[w for w in label_of(name).part if w not in _SAYING_NOTHING] for name in names]
    shared = set(words[0]).intersection(*words[1:])
    own = [[word for word in each if word not in shared] for each in words]
    are_letters = all(len(word) == 1 for word in chain.from_iterable(own))
    is_thing = bool(shared) and all(each[-1] in shared or are_letters for each in words)
    return is_thing and all(len(each) <= 1 for each in own)


def other_side(name: str) -> str | None:
    """Return the name of the peer of a left or a right part, None where no word tells a side.

    Only a whole word of the name can: `LF_hip`, `left_arm`, `armLeft`, `wheel_l`.
    """
    return next(other_sides(name), None)


def other_sides(name: str) -> Iterator[str]:
    """Yield all names that the peer of a left or a right part may have, the likeliest first."""
    marks = _marks(name)
    for others in product(*(_opposites(mark[0]) for mark in marks)) if marks else ():
        peer = name
        for mark, other in zip(reversed(marks), reversed(others), strict=True):
            peer = peer[: mark.start()] + other + peer[mark.end() :]
        yield peer


def _marks(name: str) -> list[re.Match[str]]:
    """Return the words of a name that tell a side.

    After the first one a letter does only in what a limb holds, `l_gripper_r_finger`: elsewhere it
    is for roll, `L_ANKLE_R`, and before a number for link, `right_l3`. Beside a finger's bone `rf`
    is the ring finger.
    """
    fingers = ("rf", "lf") if not _BONES.isdisjoint(tokens(name)) else ()
    words = _EITHER.difference(fingers)
    found = [match for match in _TOKEN.finditer(name) if match[0].lower() in words]
    return found[:1] + [
        mark
        for mark in found[1:]
        if len(mark[0]) > 1 or (is_held(name) and not name[mark.end() :][:1].isdigit())
    ]


def _opposites(word: str) -> list[str]:
    """Return what the words of the other side are, in the letters' case."""
    found = [y if x == word.lower() else x for x, y in _PAIRS if word.lower() in (x, y)]
    if word.isupper():
        return [other.upper() for other in found]
    return [other.capitalize() for other in found] if word[0].isupper() else found


def _side_and_row(word: str, row: str) -> tuple[str, str]:
    """Return what a word of a side tells: `lf`, `rh`, `fl`, `left`."""
    side = "L" if word in _SIDES else "R"
    first, last = word[0], word[-1]
    letter = last if first == side.lower() else first
    return side, _ROW_LETTERS[letter] if len(word) == 2 and last != "x" else row
