"""Differences between versions of a document: who carries whom, where, how heavy, or less."""

from collections.abc import Sequence
from enum import Flag, auto

from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.value_forms import is_decimal
from kindsl.language.syntax.vocabulary import POSE, VALUE_HOLDERS
from kindsl.language.text.facts import Fact, Facts, kept


class Aspect(Flag):
    """A part of a document whose changes are noticed separately.

    Attributes:
        STRUCTURE: Names, ids, kinds, who carries whom: all but values.
        PLACES: Translations and rotations, of joints and of frames.
        MASSES: All other values.
        SYMBOLS: Values that are more than a decimal, of either sort.
        LAYOUT: Blanks and comments.
    """

    NOTHING = 0
    STRUCTURE = auto()
    PLACES = auto()
    MASSES = auto()
    SYMBOLS = auto()
    LAYOUT = auto()
    NUMBERS = PLACES | MASSES
    ALL = STRUCTURE | PLACES | MASSES | SYMBOLS | LAYOUT


class Edition:
    """A version of a document, compared with the one looked at before."""

    def __init__(self, islands: Sequence[Island], before: "Edition | None") -> None:
        self.islands = islands
        self._facts: dict[Aspect, Facts] = {}
        if before is not None:
            differing = _difference(before.islands, islands)
            self._facts = {r: facts for r, facts in before._facts.items() if not r & differing}

    def facts(self, read: Aspect) -> Facts:
        """Return the facts derived from these aspects alone, the same ones while these are equal.

        Nothing that is kept there may hold an island.
        """
        return self._facts.setdefault(read, Facts())


_LAST = Fact[Edition]("last edition")


def edition(document: SyntaxDocument) -> Edition:
    """Return a version of a document as it follows the one that was asked for last."""
    new = Edition(document.islands, document.versions.get(_LAST))
    return document.versions.keep(_LAST, new)


def _difference(before: Sequence[Island], after: Sequence[Island]) -> Aspect:
    if len(before) != len(after):
        return Aspect.ALL
    changed = [pair for pair in zip(before, after, strict=True) if pair[0] is not pair[1]]
    # What points to an island that stands elsewhere now must be derived again.
    if {id(old) for old, _ in changed} & {id(new) for _, new in changed}:
        return Aspect.ALL
    found = Aspect.NOTHING
    for old, new in changed:
        if found != Aspect.ALL:
            found |= _differing(old, new)
    return found


def _differing(old: Island, new: Island) -> Aspect:
    if old.text == new.text:
        return Aspect.NOTHING
    here, there = _words(old), _words(new)
    found = Aspect.LAYOUT if old.problems or new.problems else Aspect.NOTHING
    for aspect, words in here.items():
        found |= Aspect.NOTHING if words == there[aspect] else aspect
    return found


@kept
def _words(island: Island) -> dict[Aspect, list[str]]:
    """Return the words of an island, each value as one, by what they belong to.

    In broken text also where a problem is, for nothing is concluded there, and all that is written.
    """
    structure: list[str] = []
    places: list[str] = []
    masses: list[str] = []
    symbols: list[str] = []
    if island.problems:
        structure += ["!", *(token.text for token in island.tokens if _is_word(token))]
    pending: list[tuple[Node | Token, Node | None, list[str]]] = [
        (node, None, masses) for node in island.nodes[::-1]
    ]
    while pending:
        part, parent, own = pending.pop()
        doubt = _doubt(island, part) if island.problems else ""
        if isinstance(part, Token):
            structure.append("" if part.is_missing else part.text + doubt)
        elif parent is not None and parent.kind in VALUE_HOLDERS:
            text = " ".join(token.text for token in part.tokens()) + doubt
            own.append(text)
            if not is_decimal(part):
                symbols.append(text)
        else:
            own = places if part.kind in POSE else own
            if doubt:
                own.append(doubt)
            pending += [(child, part, own) for child in part.children[::-1]]
    return dict(zip(Aspect, (structure, places, masses, symbols, _gaps(island)), strict=True))


def _is_word(token: Token) -> bool:
    return token.text.removeprefix("^").isidentifier()


def _doubt(island: Island, part: Node | Token) -> str:
    """Return a mark if something in a part, or right beside it, is not in the language."""
    start, end = part.start, part.end
    is_doubtful = any(p.start <= end and p.end >= start for p in island.problems)
    return f"!{part.kind}" if is_doubtful else f"?{part.kind}"


def _gaps(island: Island) -> list[str]:
    """Return the blanks and comments around the tokens of an island."""
    text, tokens = island.text, island.tokens
    return [*(text[t.lead : t.start] for t in tokens), text[tokens[-1].end :] if tokens else text]
