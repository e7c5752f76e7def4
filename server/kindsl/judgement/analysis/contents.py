"""The contents of islands: numbers by owner and component, blocks, references, comments."""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from math import isnan
from typing import NamedTuple, TypeAlias
from zlib import crc32

from kindsl.language.semantics.blocks import Block, NameReference, Whole
from kindsl.language.semantics.declarations import Joint, Link
from kindsl.language.semantics.expressions import ConstantUse, Expression, symbols
from kindsl.language.semantics.lowering import declarations
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.text.facts import kept

Place: TypeAlias = tuple[object, ...]

# What the generators read in two ways.
_AMBIGUOUS = frozenset({"POWER_FLOAT", "LOWER_PI"})
# What keeps numbers apart is no part of one.
_SEPARATORS = frozenset("(){}[]<>,;='\"")
_DIRECTIVE = re.compile(r"kindsl:\s*ignore[^\s\[\]]*(?:\[[^\]]*\])?")
_WORD = re.compile(r"\w+")


class Number(NamedTuple):
    """A number where it stands.

    Attributes:
        words: Its tokens, and what stands among them that nothing reads.
        value: Its value, each parameter having a value of its own; None if that is not
            known, or if it is read in two ways.
        rounding: How far the true value may be from the written one.
    """

    words: tuple[str, ...]
    value: float | None
    rounding: float


class FoundBlock(NamedTuple):
    """A block: where it is, the last being its kind and name, and `p_joint` or `floating`."""

    place: Place
    detail: str


class Contents(NamedTuple):
    """The contents of islands.

    Attributes:
        numbers: Each number by owner and component.
        references: Who carries whom by which joint, and frames of inertias.
        blocks: The links in their order, which may be that of the joint variables, and the other
            blocks; those of one name in their order.
        remarks: The words of comments, without what silences findings.
    """

    numbers: dict[Place, Number]
    references: frozenset[Place]
    blocks: tuple[FoundBlock, ...]
    remarks: Counter[str]
    unread: Counter[str]


def contents(islands: Sequence[Island]) -> Contents:
    """Return the contents of some neighbouring islands."""
    pieces = list(map(_piece, islands))
    numbers: dict[Place, Number] = {}
    seen: Counter[Place] = Counter()
    remarks: Counter[str] = Counter()
    unread: Counter[str] = Counter()
    for piece in pieces:
        for place, number in piece.numbers:
            seen[place] += 1
            numbers[(*place, seen[place])] = number
        remarks.update(piece.remarks)
        unread.update(piece.unread)
    references = frozenset(each for piece in pieces for each in piece.references)
    blocks = sorted((block for piece in pieces for block in piece.blocks), key=_order)
    return Contents(numbers, references, tuple(blocks), remarks, unread)


def _order(block: FoundBlock) -> Place:
    is_link = len(block.place) == 2 and block.place[0] == "link"
    return ("link",) if is_link else block.place


class _Piece:
    """The contents of one island; what occurs again is numbered only beyond it."""

    def __init__(self, island: Island) -> None:
        self.island = island
        self.numbers: list[tuple[Place, Number]] = []
        self.references: list[Place] = []
        self.blocks: list[FoundBlock] = []
        comments = (island.text[start:end] for start, end in island.comments)
        self.remarks = _words(_DIRECTIVE.sub(" ", comment) for comment in comments)
        self.unread = _words(token.text for token in island.skipped)
        self._skipped = sorted((token.start, token.end, token.text) for token in island.skipped)
        for block in declarations(island).blocks:
            self._walk(block, ())

    def _walk(self, block: Block, around: Place) -> None:
        owner = (*around, block.node.kind, str(block.name))
        self.blocks.append(FoundBlock(owner, _detail(block)))
        for part in block.parts:
            if isinstance(part, Block):
                self._walk(part, owner)
            elif isinstance(part, NameReference):
                self.references.append((*owner, part.section, *map(str, part.names)))
            elif isinstance(part, Whole):
                self._add((*owner, part.section), part.token)
            else:
                self._add((*owner, part.meaning.section, part.meaning.component), part.node)

    def _add(self, place: Place, at: Node | Token) -> None:
        self.numbers.append((place, self._number(at)))
        if isinstance(at, Node):
            for symbol in symbols(Expression(at, self.island)):
                given = symbol.value if isinstance(symbol, ConstantUse) else symbol.default
                if given is not None:
                    self.numbers.append(((*place, str(symbol.name)), self._number(given.node)))

    def _number(self, at: Node | Token) -> Number:
        tokens = list(at.tokens()) if isinstance(at, Node) else [at]
        strange = list(self._unread_among(tokens))
        words = (*(token.text for token in tokens if not token.is_missing), *strange)
        if strange or any(t.is_missing or t.kind in _AMBIGUOUS for t in tokens):
            return Number(words, None, 0.0)
        if isinstance(at, Token):
            return Number(words, _whole(at.text), 0.0)
        expression = Expression(at, self.island)
        stand_ins = _stand_ins(expression)
        value = expression.value(stand_ins)
        if value is None or isnan(value):
            return Number(words, None, 0.0)
        return Number(words, value, expression.rounding(stand_ins))

    def _unread_among(self, tokens: Sequence[Token]) -> Iterator[str]:
        """Yield what nothing reads between tokens, and what is visible right beside them."""
        first, last, text = tokens[0], tokens[-1], self.island.text
        for start, end, unread in self._skipped:
            is_between = first.start <= start < last.end
            is_before = end <= first.start and not text[end : first.start].strip()
            is_behind = last.end <= start and not text[last.end : start].strip()
            if is_between or ((is_before or is_behind) and _is_visible(unread)):
                yield unread


@kept
def _piece(island: Island) -> _Piece:
    return _Piece(island)


def _is_visible(text: str) -> bool:
    return any(c.isprintable() and not c.isspace() and c not in _SEPARATORS for c in text)


def _whole(text: str) -> float | None:
    try:
        return float(int(text))
    except ValueError:
        return None


def _stand_ins(expression: Expression) -> dict[str, float]:
    """Return a value for each name: what is equal for such values is equal for all."""
    found = {}
    for symbol in symbols(expression):
        is_constant = isinstance(symbol, ConstantUse)
        name = f"<{symbol.name}>" if is_constant else str(symbol.name)
        found[name] = 1.0 + crc32(name.encode()) / 2.0**32
    return found


def _detail(block: Block) -> str:
    if isinstance(block, Joint):
        return block.kind
    return "floating" if isinstance(block, Link) and block.is_floating else ""


def _words(texts: Iterable[str]) -> Counter[str]:
    return Counter(word for text in texts for word in _WORD.findall(text))
