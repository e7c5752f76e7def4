"""The remarks of the grammar, behind `//:`; its head explains them. An unread one is an error."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

TARGETS = ("robcogen", "robcogen2")

_ORDER = re.compile(r"order ((?:\w+[?+]? ?)+)")
_BEHIND = re.compile(
    rf"(only) ({'|'.join(TARGETS)})|(neither) (KD\d{{3}})|(value) ([a-z]+(?: \S+)?)|"
    r"(declares) ([a-z]+)|(refers) ([a-z]+(?: [a-z]+)*)"
)
_DEFINED = re.compile(r"[?!]?(\w+)(?:\.\d+)?\s*:(?!:)")
_ALIAS = re.compile(r"->\s*(\w+)")


class AnnotationError(ValueError):
    """A remark in the grammar that nobody reads."""


class Annotation(NamedTuple):
    """A remark: the rule, alias or terminal that it is about, its word, its value, its line."""

    about: str
    word: str
    value: str
    line: int


def annotations(grammar: str) -> Iterator[Annotation]:
    """Yield the remarks of a grammar.

    Raises:
        AnnotationError: A remark is none of those that there are, or is about nothing.
    """
    lines = grammar.split("\n")
    for number, line in enumerate(lines, 1):
        code, sign, remark = line.partition("//:")
        if not sign or code.startswith("//"):
            continue
        order = _ORDER.fullmatch(remark.strip())
        below = _DEFINED.match(lines[number]) if number < len(lines) else None
        if order and not code and below:
            yield Annotation(below[1], "order", order[1], number)
            continue
        about = _ALIAS.search(code) or _DEFINED.match(code)
        for part in remark.split(";"):
            behind = _BEHIND.fullmatch(part.strip())
            if not behind or not about:
                raise AnnotationError(f"line {number}: nobody reads '//:{remark}'")
            word, value = (group for group in behind.groups() if group)
            yield Annotation(about[1], word, value, number)


def orders(found: Sequence[Annotation]) -> dict[str, tuple[str, ...]]:
    """Return the sections of each block in their order, with `?` and `+`."""
    return {note.about: tuple(note.value.split()) for note in found if note.word == "order"}


def check_read(
    found: Sequence[Annotation],
    holds: Mapping[str, Sequence[str]],
    readers: Mapping[str, Collection[str]],
) -> None:
    """Raise where nobody reads a remark.

    Args:
        found: The remarks.
        holds: Contents of each construct.
        readers: The names whose remarks are read, by the word of the remark.

    Raises:
        AnnotationError: A remark is about something whose remarks nobody reads, or an order lacks
            a section or names one that its block does not hold.
    """
    for note in found:
        if note.word != "order":
            is_read = note.about in readers[note.word]
        else:
            named = [part.rstrip("?+") for part in note.value.split()]
            is_read = set(named) <= set(holds.get(note.about, ()))
        if not is_read:
            remark = f"//: {note.word} {note.value}"
            raise AnnotationError(f"line {note.line}: nobody reads '{remark}' of '{note.about}'")
