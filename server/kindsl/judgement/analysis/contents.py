"""The contents of islands: numbers by owner and component, blocks, references, comments."""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from math import isnan
from typing import NamedTuple, TypeAlias
from zlib import crc32

from kindsl.language.semantics.expressions import ConstantUse, Expression, symbols
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.vocabulary import BLOCKS, SCALARS, of_kind
from kindsl.language.text.facts import kept

Place: TypeAlias = tuple[object, ...]

_VALUES = SCALARS
_REFERENCES = frozenset({"child", "inertia_frame"})
# What may be written once or in several pieces, and means the same.
_PIECES = of_kind("list", "groups", "group")
_NAMED = frozenset(("head", *BLOCKS, "frame"))
_BLOCKS = _NAMED | {"inertia", "joint_frame"}
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
        unread: The words that nothing reads.
    """

    numbers: dict[Place, Number]
    references: frozenset[Place]
    blocks: tuple[FoundBlock, ...]
    remarks: Counter[str]
    unread: Counter[str]


class _Piece(NamedTuple):
    """The contents of one island; what occurs again is told apart only beyond it."""

    numbers: tuple[tuple[Place, Number], ...]
    references: tuple[Place, ...]
    blocks: tuple[FoundBlock, ...]
    remarks: Counter[str]
    unread: Counter[str]


def contents(islands: Sequence[Island]) -> Contents:
    """Return what some neighbouring islands say."""
    pieces = [_piece(island) for island in islands]
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


@kept
def _piece(island: Island) -> _Piece:
    return _Walk(island).piece()


class _Walk:
    """Walks the blocks of one island."""

    def __init__(self, island: Island) -> None:
        self.island = island
        self.unread = sorted((token.start, token.end, token.text) for token in island.skipped)
        self.numbers: list[tuple[Place, Number]] = []
        self.references: list[Place] = []
        self.blocks: list[FoundBlock] = []

    def piece(self) -> _Piece:
        for node in self.island.nodes:
            self._walk(node, ())
        numbers, references = tuple(self.numbers), tuple(self.references)
        remarks, unread = _remarks(self.island), (token.text for token in self.island.skipped)
        words = _words(remarks), _words(unread)
        return _Piece(numbers, references, tuple(self.blocks), *words)

    def _walk(self, node: Node, owner: Place) -> None:
        kind = node.kind
        if kind in _BLOCKS:
            owner = (*owner, kind, _name(node) if kind in _NAMED else "")
            self.blocks.append(FoundBlock(owner, _detail(node)))
        elif kind in _REFERENCES:
            self.references.append((*owner, kind, *_names(node)))
            return
        elif kind == "id":
            self._add((*owner, kind), node.children[-1])
            return
        elif kind not in _PIECES:
            first = next(node.tokens())
            owner = (*owner, first.text if kind == "moment" else kind)
        self._walk_below(node, owner)

    def _walk_below(self, node: Node, owner: Place) -> None:
        for index, child in enumerate(node.children):
            if isinstance(child, Node):
                if node.kind == "vector":
                    self._add((*owner, index), child)
                elif node.kind in _VALUES:
                    self._add(owner, child)
                else:
                    self._walk(child, owner)

    def _add(self, place: Place, at: Node | Token) -> None:
        self.numbers.append((place, self._number(at)))
        if isinstance(at, Node):
            for symbol in symbols(Expression(at, self.island)):
                given = symbol.value if isinstance(symbol, ConstantUse) else symbol.default
                if given is not None:
                    self._add((*place, str(symbol.name)), given.node)

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
        for start, end, unread in self.unread:
            is_between = first.start <= start < last.end
            is_before = end <= first.start and not text[end : first.start].strip()
            is_behind = last.end <= start and not text[last.end : start].strip()
            if is_between or ((is_before or is_behind) and _is_visible(unread)):
                yield unread


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


def _names(node: Node) -> Iterator[str]:
    for child in node.children:
        if isinstance(child, Token) and child.kind == "NAME":
            yield child.text.removeprefix("^")


def _name(node: Node) -> str:
    return next(_names(node), "")


def _detail(node: Node) -> str:
    first = node.children[0]
    word = first.text if node.kind == "joint" and isinstance(first, Token) else ""
    is_floating = any(child.kind == "FLOATING" for child in node.children)
    return "floating" if is_floating else word


def _remarks(island: Island) -> Iterator[str]:
    """Yield the comments without suppressions."""
    for start, end in island.comments:
        yield _DIRECTIVE.sub(" ", island.text[start:end])


def _words(texts: Iterable[str]) -> Counter[str]:
    return Counter(word for text in texts for word in _WORD.findall(text))
