"""Reads RobCoGen's transforms documents; `grammar/dtdsl.lark` defines them.

They are words and pairs without nesting, so one pass over the words is all it takes.
"""

import re
from typing import NamedTuple

_WORDS = re.compile(
    r"(?P<skip>\s+|//[^\n]*|/\*.*?\*/)|(?P<word>[A-Za-z_]\w*|[{}=,])|(?P<odd>.)", re.S
)
FRAME = "a frame"
ROBOT_NAME = "the robot's name"
SECTIONS = ("Frames", "Transforms", "Jacobians")


class Word(NamedTuple):
    """A name where it stands; offsets in code points."""

    text: str
    start: int
    end: int


class Pair(NamedTuple):
    """A transform or Jacobian that is wanted: of `target`, seen from `base`."""

    base: Word
    target: Word


class SyntaxDefect(NamedTuple):
    """What cannot stand where it stands, and what can."""

    message: str
    start: int
    end: int
    expected: str


class TransformsDocument(NamedTuple):
    """What a transforms document says, up to its first defect.

    Attributes:
        robot: The robot's name, None if it is missing.
        frames: The frames that it declares.
        transforms: The transforms wanted.
        jacobians: The Jacobians wanted.
        defect: The first thing that cannot stand where it stands, if any.
    """

    robot: Word | None
    frames: tuple[Word, ...]
    transforms: tuple[Pair, ...]
    jacobians: tuple[Pair, ...]
    defect: SyntaxDefect | None


class _Unexpected(Exception):  # noqa: N818
    """Ends the reading at a word."""

    def __init__(self, expected: str, word: Word) -> None:
        found = f"'{word.text}'" if word.text else "the end of the document"
        super().__init__(f"expected {expected} instead of {found}")
        self.expected = expected
        self.word = word


def read_transforms(text: str) -> TransformsDocument:
    """Return what a text says; never raises."""
    reader = _Reader(text)
    defect = None
    try:
        reader.read()
    except _Unexpected as error:
        defect = SyntaxDefect(str(error), error.word.start, error.word.end, error.expected)
    return TransformsDocument(
        reader.robot,
        tuple(reader.frames),
        tuple(reader.pairs["Transforms"]),
        tuple(reader.pairs["Jacobians"]),
        defect,
    )


class _Reader:
    """Takes words one after the other."""

    def __init__(self, text: str) -> None:
        found = [m for m in _WORDS.finditer(text) if m.lastgroup != "skip"]
        self._words = [Word(m[0], m.start(), m.end()) for m in found]
        self._words.append(Word("", len(text), len(text)))
        self._next = 0
        self.robot: Word | None = None
        self.frames: list[Word] = []
        self.pairs: dict[str, list[Pair]] = {"Transforms": [], "Jacobians": []}

    def read(self) -> None:
        self._take("Robot")
        self.robot = self._name(ROBOT_NAME)
        for section in SECTIONS:
            if self._words[self._next].text != section:
                continue
            self._next += 1
            self._take("{")
            if section == "Frames":
                self._frames()
            else:
                while self._words[self._next].text != "}":
                    self.pairs[section].append(self._pair())
            self._take("}")
        if self._words[self._next].text:
            raise _Unexpected("'Frames', 'Transforms' or 'Jacobians', in this order", self._word())

    def _frames(self) -> None:
        self.frames.append(self._name(FRAME))
        while self._words[self._next].text == ",":
            self._next += 1
            self.frames.append(self._name(FRAME))

    def _pair(self) -> Pair:
        self._take("base")
        self._take("=")
        base = self._name(FRAME)
        for word in (",", "target", "="):
            self._take(word)
        return Pair(base, self._name(FRAME))

    def _word(self) -> Word:
        return self._words[self._next]

    def _take(self, text: str) -> None:
        if self._word().text != text:
            raise _Unexpected(f"'{text}'", self._word())
        self._next += 1

    def _name(self, what: str) -> Word:
        word = self._word()
        if not word.text.isidentifier() or not word.text.isascii():
            raise _Unexpected(what, word)
        self._next += 1
        return word
