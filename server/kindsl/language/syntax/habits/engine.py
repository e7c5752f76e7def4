"""Putting habits right: patterns over the kinds of tokens, their meaning and their message.

A row of tokens is read as a string of one letter for each token, `LETTERS`, and a line end before
each token that begins a line. In a pattern a blank stands for a line end that may be there.
"""

import re
from bisect import bisect_left
from collections.abc import Callable, Iterable, Sequence
from functools import cache, cached_property
from typing import NamedTuple

from kindsl.language.syntax.tables import CLASSES, KEYWORDS
from kindsl.language.syntax.tree import Edit, Problem, Repair, Token
from kindsl.language.syntax.vocabulary import (
    NAMES,
    PIS,
    POSE,
    SCALARS,
    of_kind,
    token_kind,
    token_kinds,
)

LETTERS = {
    **dict.fromkeys(KEYWORDS.values(), "W"),
    **dict.fromkeys(NAMES, "u"), "NAME": "n", "PI_PREFIXED": "q", **dict.fromkeys(PIS, "P"),
    **dict(zip(CLASSES["_number"], "fiepm", strict=True)),
    **dict.fromkeys(token_kinds(SCALARS), "S"), **dict.fromkeys(token_kinds(of_kind("whole")), "D"),
    **dict.fromkeys(token_kinds(of_kind("vector")), "c"), **dict.fromkeys(token_kinds(POSE), "V"),
    **dict.fromkeys(token_kinds(of_kind("pose")), "R"), "via": "v",
    **dict(zip(map(token_kind, ("base", "link", "joint")), "BLJ", strict=True)),
    **dict(zip(map(token_kind, ("inertia", "children")), "IC", strict=True)),
}  # fmt: skip
_SIGNS = frozenset("#\"';")


class Rewrite(NamedTuple):
    """The meaning of some tokens.

    Attributes:
        first: The index of the first of them.
        behind: The index behind the last.
        tokens: What to read; of the tokens that are in none of these is left out.
        at: Where the problem is; None for no problem.
        words: Words that the habit's sentence and title quote.
        message: A sentence that fits better than the habit's.
    """

    first: int
    behind: int
    tokens: Sequence[Token]
    at: tuple[int, int] | None = None
    words: tuple[object, ...] = ()
    edits: tuple[Edit, ...] = ()
    message: str = ""


class Sighting:
    """The place where a pattern was found."""

    def __init__(self, row: "_Row", match: re.Match[str]) -> None:
        self._row = row
        self.match = match
        self.text, self.tokens, self.kinds = row.text, row.tokens, row.kinds

    def span(self, group: str | int = 0) -> tuple[int, int]:
        """Return the indices of the first token of a group, and behind its last."""
        start, end = self.match.span(group)
        return self.index(start), self.index(end)

    def index(self, place: int) -> int:
        """Return the index of the first token at or behind a letter."""
        return bisect_left(self._row.places, place)

    def of(self, group: str | int = 0) -> Sequence[Token]:
        """Return the tokens of a group, none where it is not there."""
        first, behind = self.span(group)
        return self.tokens[first:behind]

    def letters(self, group: str | int = 0) -> str:
        """Return the letters of a group without line ends."""
        return (self.match[group] or "").replace("\n", "")

    def block(self, index: int) -> tuple[str, int]:
        """Return what opens the block around a token, `L`, `J`, `I`, `F` or nothing; its depth."""
        return self._row.blocks[index]


class Habit(NamedTuple):
    """A habit of writing, its meaning and its message.

    Attributes:
        example: An instance, in a link or joint where it is one.
        pattern: Its tokens.
        message: The sentence; `{0}` and so on are what it quotes.
    """

    example: str
    pattern: str
    meaning: Callable[[Sighting], Iterable[Rewrite]]
    message: str = ""
    title: str = ""
    is_safe: bool = False
    code: str = "KD001"


class Adapted(NamedTuple):
    """Tokens put right.

    Attributes:
        problems: Problems to report; malformed numbers are reported later.
    """

    tokens: list[Token]
    skipped: list[Token]
    problems: list[Problem]


def put_right(text: str, tokens: Sequence[Token], habits: Iterable[Habit]) -> Adapted:
    """Return the tokens of an island with each habit put right, one after the other."""
    row = _Row(text, tokens)
    skipped: list[Token] = []
    problems: list[Problem] = []
    for habit in habits:
        new: list[Token] = []
        done = 0
        for match in _compiled(habit.pattern).finditer(row.kinds):
            for rewrite in habit.meaning(Sighting(row, match)):
                if rewrite.first < done:
                    continue
                new += [*row.tokens[done : rewrite.first], *rewrite.tokens]
                done = rewrite.behind
                skipped += _left_out(row.tokens[rewrite.first : done], rewrite.tokens)
                if rewrite.at is not None:
                    problems.append(_problem(habit, rewrite, *rewrite.at))
        if done:
            row = _Row(text, [*new, *row.tokens[done:]])
    return Adapted(list(row.tokens), skipped, problems)


class _Row:
    def __init__(self, text: str, tokens: Sequence[Token]) -> None:
        self.text = text
        self.tokens = tokens
        self.places: list[int] = []
        letters: list[str] = []
        length = end = 0
        for token in tokens:
            between = text[end : token.start]
            if end and ("\n" in between or "\r" in between):
                letters.append("\n")
                length += 1
            self.places.append(length)
            letters.append(_letter(token))
            length += 1
            end = token.end
        self.kinds = "".join(letters)

    @cached_property
    def blocks(self) -> list[tuple[str, int]]:
        """The opener of the block around each token, and its depth."""
        opened = [""]
        found = []
        letters = self.kinds.replace("\n", "")
        for index, letter in enumerate(letters):
            if letter == "}" and len(opened) > 1:
                opened.pop()
            found.append((opened[-1], len(opened) - 1))
            if letter == "{":
                opened.append(_opener(letters[max(index - 2, 0) : index]))
        return found


def _opener(before: str) -> str:
    if before[-1:] == "I":
        return "I"
    if before[:1] in ("L", "J"):
        return before[0]
    return "F" if before[-1:] in ("R", "n") else ""


def _letter(token: Token) -> str:
    if len(token.kind) == 1:
        return token.kind
    if token.kind == "BAD":
        return token.text if token.text in _SIGNS else "?"
    return LETTERS.get(token.kind, "u")


@cache
def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern.replace(" ", "\n?"))


def _left_out(old: Sequence[Token], new: Sequence[Token]) -> list[Token]:
    """Return the written tokens that none of the new ones covers."""
    solid = [token for token in new if not token.is_missing]
    starts = [token.start for token in solid]

    def is_left_out(token: Token) -> bool:
        index = bisect_left(starts, token.end)
        return index == 0 or solid[index - 1].end <= token.start

    return [token for token in old if not token.is_missing and is_left_out(token)]


def _problem(habit: Habit, rewrite: Rewrite, start: int, end: int) -> Problem:
    message = rewrite.message or habit.message.format(*rewrite.words)
    title = habit.title.format(*rewrite.words)
    repair = Repair(title, rewrite.edits, habit.is_safe) if rewrite.edits else None
    return Problem(habit.code, message, start, end, repair)
