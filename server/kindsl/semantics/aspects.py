"""Differences between versions of a document: who carries whom, where, how heavy, or less."""

from collections.abc import Sequence
from enum import Flag, auto

from kindsl.syntax.document import SyntaxDocument
from kindsl.syntax.tree import Island, Node, Token
from kindsl.syntax.value_forms import is_decimal
from kindsl.syntax.vocabulary import POSE, VALUE_HOLDERS
from kindsl.text.facts import Fact


class Aspect(Flag):
    """A part of a document that can be read by itself; an island that is broken is each of them.

    Attributes:
        STRUCTURE: Names, ids, kinds, who carries whom: all but values.
        PLACES: Translations and rotations, of joints and of frames.
        MASSES: All other values.
        SYMBOLS: Values that are more than a decimal, of either sort.
        TEXT: All that is written, blanks and comments too.
    """

    NOTHING = 0
    STRUCTURE = auto()
    PLACES = auto()
    MASSES = auto()
    SYMBOLS = auto()
    TEXT = auto()
    ALL = STRUCTURE | PLACES | MASSES | SYMBOLS | TEXT


class Edition:
    """A version of a document, as those see it who have looked at one before it.

    Attributes:
        islands: Its islands.
    """

    def __init__(self, islands: Sequence[Island], before: "Edition | None") -> None:
        self.islands = islands
        known = before._read if before is not None else {}
        differing = _difference(before.islands, islands) if before is not None else Aspect.ALL
        self._read: dict[Aspect, object] = {
            a: object() if a in differing else known[a] for a in Aspect.ALL
        }

    def reading(self, aspects: Aspect) -> tuple[object, ...]:
        """Return what is equal for two versions, surely only where all these aspects are equal."""
        return tuple([self._read[aspect] for aspect in aspects])


_LAST = Fact[Edition]("last edition")


def edition(document: SyntaxDocument) -> Edition:
    """Return a version of a document as it follows the one that was asked for last."""
    new = Edition(document.islands, document.versions.get(_LAST))
    return document.versions.keep(_LAST, new)


def _difference(before: Sequence[Island], after: Sequence[Island]) -> Aspect:
    if len(before) != len(after):
        return Aspect.ALL
    found = Aspect.NOTHING
    for old, new in zip(before, after, strict=True):
        if old is not new and found != Aspect.ALL:
            found |= _differing(old, new)
    return found


def _differing(old: Island, new: Island) -> Aspect:
    if old.text == new.text:
        return Aspect.NOTHING
    if old.problems or new.problems:
        return Aspect.ALL
    here, there = _words(old), _words(new)
    found = Aspect.TEXT
    for aspect, words in here.items():
        found |= Aspect.NOTHING if words == there[aspect] else aspect
    return found


def _words(island: Island) -> dict[Aspect, list[str]]:
    """Return the words of an island, each value as one, by what they belong to."""
    words: dict[Aspect, list[str]] = {aspect: [] for aspect in Aspect}
    pending: list[tuple[Node | Token, Node | None, Aspect]] = [
        (node, None, Aspect.MASSES) for node in island.nodes[::-1]
    ]
    while pending:
        part, parent, kind = pending.pop()
        if isinstance(part, Token):
            words[Aspect.STRUCTURE].append(part.text)
        elif parent is not None and parent.kind in VALUE_HOLDERS:
            text = " ".join(token.text for token in part.tokens())
            for aspect in (kind,) if is_decimal(part) else (kind, Aspect.SYMBOLS):
                words[aspect].append(text)
        else:
            kind = Aspect.PLACES if part.kind in POSE else kind
            pending += ((child, part, kind) for child in part.children[::-1])
    return words
