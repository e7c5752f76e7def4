"""Text as robcogen2 reads it, character by character: nothing is supplied, nothing skipped.

robcogen2 has no tokens. Its grammar (textX, robot-model-tools 0.3.0) takes at each place what may
stand there, the first alternative that fits: so a keyword is a name where a name stands, a word may
begin right behind a keyword or a number, and digits are those of any alphabet.
"""

import re
from collections.abc import Callable
from functools import cache
from typing import NamedTuple

from kindsl.language.syntax.portability import ROBCOGEN2
from kindsl.language.syntax.tables import IGNORED, KEYWORDS, ORDERS, PATTERNS, WORDS
from kindsl.language.syntax.tree import Token
from kindsl.language.syntax.value_forms import targets_of
from kindsl.language.syntax.vocabulary import LETTERS, MOMENTS, SECTIONS

_TRIVIA = re.compile(
    f"(?:{'|'.join(PATTERNS[kind] for kind in IGNORED if ROBCOGEN2 in targets_of(kind))})*+"
)
_NAME = re.compile(r"[^\d\W]\w*")
_PI = re.compile(r"[Pp|][Ii|]")
_INT = re.compile(r"[-+]?[0-9]+")
_STRICT_FLOAT = re.compile(
    r"[+-]?(?:(?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)(?<=[\w.])(?![\w.])"
)
_NUMBER_KINDS = [
    (kind, re.compile(pattern))
    for kind, pattern in PATTERNS.items()
    if kind in ("POWER_FLOAT", "SCIENTIFIC", "FLOAT")
]


class StrictReading(NamedTuple):
    """A piece of text as robcogen2 reads it.

    Attributes:
        blocks: A letter for each block that it reads, of `LETTERS`.
        failure: Where it stops, code points from the start; None where it reads all.
    """

    blocks: str
    tokens: tuple[Token, ...]
    failure: int | None


def strict_reading(text: str) -> StrictReading:
    """Return how far robcogen2 reads a row of blocks, in whatever order they stand."""
    reader = _CharacterReader(text)
    blocks = ""
    while not reader.is_at_end():
        block = next((kind for kind, forms in _BLOCKS.items() if reader.any_of(*forms)), None)
        if block is None:
            break
        blocks += LETTERS[block]
    failure = None if reader.is_at_end() else reader.furthest
    return StrictReading(blocks, tuple(reader.tokens), failure)


class _CharacterReader:
    """A place in a text, and what was read up to there.

    Every method that reads returns whether it could, and reads nothing if not.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.place = 0
        self.furthest = 0
        self.tokens: list[Token] = []

    def is_at_end(self) -> bool:
        return self._next() == len(self.text)

    def words(self, sequence: str) -> bool:
        """Read keywords, signs, and whatever stands for `NAME`, `FRAMES?`, `CHILD*`, ..."""
        place, count = self.place, len(self.tokens)
        for word, part, number in _steps(sequence):
            is_read = part(self) if part is not None else self._word(word)
            while is_read and number == "*" and part is not None:
                is_read = part(self)
            if not (is_read or number):
                self.place = place
                del self.tokens[count:]
                return False
        return True

    def any_of(self, *sequences: str) -> bool:
        return any(map(self.words, sequences))

    def _next(self) -> int:
        match = _TRIVIA.match(self.text, self.place)
        return match.end() if match is not None else self.place

    def _word(self, word: str) -> bool:
        start = self._next()
        if not self.text.startswith(word, start):
            self.furthest = max(self.furthest, start)
            return False
        return self._take(KEYWORDS.get(word, word), start, start + len(word))

    def matching(self, kind: str, pattern: re.Pattern[str]) -> bool:
        start = self._next()
        match = pattern.match(self.text, start)
        if match is None:
            self.furthest = max(self.furthest, start)
            return False
        return self._take(kind or _number_kind(match[0]), start, match.end())

    def name(self) -> bool:
        return self.matching("NAME", _NAME)

    def number(self) -> bool:
        return self.matching("", _STRICT_FLOAT) or self.matching("INT", _INT)

    def pi(self) -> bool:
        start = self._next()
        if not self.matching("PI", _PI):
            return False
        word = self.text[start : self.place]
        if word != "PI":
            self.tokens[-1].kind = "LOWER_PI" if word.isalpha() else "PIPE_PI"
        return True

    def parameter(self) -> bool:
        if _PI.match(self.text, self._next()) or not self.name():
            return False
        return self.words("[ NUMBER ]") or True

    def value(self) -> bool:
        return self.parameter() or self.any_of("NUMBER", "PI", "< NAME = NUMBER >", "< NAME >")

    def expression(self) -> bool:
        return self._lone_number() or self.any_of(
            "NUMBER * VALUE", "- VALUE / NUMBER", "VALUE / NUMBER", "- VALUE", "VALUE"
        )

    def _lone_number(self) -> bool:
        """Read a number without sign or operation, as most values are."""
        place, start = self.place, self._next()
        if self.text.startswith("-", start) or not self.number():
            return False
        end = self._next()
        if self.text.startswith(("*", "/"), end):
            self.place = place
            self.tokens.pop()
            return False
        self.furthest = max(self.furthest, end)
        return True

    def moments(self) -> bool:
        left = list(MOMENTS)
        while left:
            found = next((name for name in left if self.words(f"{name} = EXPRESSION")), None)
            if found is None:
                return False
            left.remove(found)
        return True

    def _take(self, kind: str, start: int, end: int) -> bool:
        done = self.tokens[-1].end if self.tokens else 0
        self.tokens.append(Token(kind, self.text[start:end], done, start, end))
        self.place = end
        self.furthest = max(self.furthest, end)
        return True


@cache
def _steps(sequence: str) -> list[tuple[str, "Callable[[_CharacterReader], bool] | None", str]]:
    """Return the words of a sequence, what reads each, and `?` or `*` behind it."""
    steps = []
    for written in sequence.split():
        word = written.rstrip("?*+") if written[0].isalpha() else written
        steps.append((word, _PARTS.get(word), written.removeprefix(word).strip("+")))
    return steps


def _number_kind(text: str) -> str:
    plain = text
    if not text.isascii():
        plain = "".join(str(int(c)) if c.isdigit() else c for c in text)
    return next(kind for kind, pattern in _NUMBER_KINDS if pattern.fullmatch(plain))


def _body(block: str) -> str:
    """Return the parts of a block: its sections in their order, without those that it refuses."""
    parts = [part for part in ORDERS[block] if ROBCOGEN2 in targets_of(part.rstrip("?+"))]
    return " ".join(part.upper() for part in parts)


def _section(name: str, kind: str) -> Callable[[_CharacterReader], bool]:
    value = _VALUES.get(kind)
    body = f"= {value}" if value else f"{{ {_body(name)} }}"
    return lambda reader: reader.any_of(*(f"{word} {body}" for word in WORDS[name]))


_VALUES = {"vector": "VECTOR", "scalar": "EXPRESSION", "whole": "INT", "name": "NAME"}
_READ_AS_SUCH = {
    "moments": _CharacterReader.moments,
    "list": lambda reader: reader.words("children { CHILD* }"),
    "groups": lambda reader: reader.words("frames GROUP GROUP*"),
}
_PARTS: dict[str, Callable[[_CharacterReader], bool]] = {
    "NAME": _CharacterReader.name,
    "NUMBER": _CharacterReader.number,
    "PI": _CharacterReader.pi,
    "VALUE": _CharacterReader.value,
    "EXPRESSION": _CharacterReader.expression,
    "VECTOR": lambda reader: reader.any_of("( EXPRESSION , EXPRESSION , EXPRESSION )"),
    "FRAME": lambda reader: reader.any_of(f"NAME {{ {_body('frame')} }}"),
    "CHILD": lambda reader: reader.words("NAME via NAME"),
    "GROUP": lambda reader: reader.words("{ FRAME FRAME* }"),
    "INT": lambda reader: reader.matching("INT", _INT),
    "JOINT_KEYWORD": lambda reader: reader.any_of(*WORDS["joint"]),
    **{
        name.upper(): _READ_AS_SUCH.get(kind) or _section(name, kind)
        for name, kind in SECTIONS.items()
    },
}
_BASE, _LINK, _JOINT = (f"{{ {_body(block)} }}" for block in ("base", "link", "joint"))
_BLOCKS = {
    "base": (f"RobotBase NAME {_BASE}", f"RobotBase NAME floating {_BASE}"),
    "head": ("Robot NAME {",),
    "link": (f"link NAME {_LINK}",),
    "joint": (f"JOINT_KEYWORD NAME {_JOINT}",),
    "end": ("}",),
}
