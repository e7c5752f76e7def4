"""The meaning of each word, for highlighting beyond the grammar's reach."""

import re
from typing import NamedTuple

from kindsl.frontends.features.symbol_at import EntityKind, Role, Symbol, named_places
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.syntax.tables import KEYWORDS
from kindsl.language.syntax.tree import Island, Token
from kindsl.language.syntax.vocabulary import NUMBERS, PIS
from kindsl.language.text.facts import kept

_TYPE_OF = {
    EntityKind.ROBOT: "namespace",
    EntityKind.LINK: "class",
    EntityKind.JOINT: "method",
    EntityKind.FRAME: "property",
    EntityKind.PARAMETER: "parameter",
    EntityKind.CONSTANT: "variable",
}
_OPERATORS = frozenset("+-*/=")
# Stands out of its comment by the editor's own grammar, which a token would cover.
_SUPPRESSION = re.compile(r"(?<=//)\s*kindsl:\s*ignore(?:-file)?\[[^\]]*\]")


class SemanticToken(NamedTuple):
    """A stretch of one line; type and modifiers are named as in the protocol."""

    start: int
    end: int
    type: str
    modifiers: tuple[str, ...] = ()


def semantic_tokens(
    analysis: Analysis, start: int = 0, end: int | None = None
) -> tuple[SemanticToken, ...]:
    """Return the tokens that touch a range, in the order of the text."""
    syntax = analysis.syntax
    end = syntax.length if end is None else end
    found: list[SemanticToken] = []
    for index in range(syntax.island_at(start).index, syntax.island_at(end).index + 1):
        place = syntax.island(index)
        found += [
            SemanticToken(place.start + t.start, place.start + t.end, t.type, t.modifiers)
            for t in island_tokens(place.island)
            if place.start + t.end >= start and place.start + t.start <= end
        ]
    return tuple(found)


@kept
def island_tokens(island: Island) -> tuple[SemanticToken, ...]:
    """Return the tokens of an island, offsets from its start; computed once in its life."""
    names = {symbol.start: symbol for symbol in named_places(island).symbols}
    found = [_token(token, names) for token in island.tokens if not token.is_missing]
    found += _comments(island)
    return tuple(sorted(token for token in found if token is not None))


def _token(token: Token, names: dict[int, Symbol]) -> SemanticToken | None:
    symbol = names.get(token.start)
    if symbol is not None:
        return _name(symbol)
    if token.kind in NUMBERS:
        return SemanticToken(token.start, token.end, "number")
    if token.kind in PIS:
        return SemanticToken(token.start, token.end, "number", ("readonly", "defaultLibrary"))
    if token.text in KEYWORDS:
        return SemanticToken(token.start, token.end, "keyword")
    if token.kind in _OPERATORS:
        return SemanticToken(token.start, token.end, "operator")
    return None


def _name(symbol: Symbol) -> SemanticToken:
    kind = symbol.entity.kind
    modifiers: tuple[str, ...] = ()
    if symbol.role is Role.DECLARATION:
        modifiers = ("declaration",)
    elif symbol.role is Role.WRITE:
        modifiers = ("modification",)
    if kind is EntityKind.CONSTANT:
        modifiers = (*modifiers, "readonly")
    return SemanticToken(symbol.start, symbol.end, _TYPE_OF[kind], modifiers)


def _comments(island: Island) -> list[SemanticToken]:
    found = []
    for start, end in island.comments:
        for line in island.text[start:end].splitlines(keepends=True):
            length = len(line.rstrip("\r\n"))
            hole = _SUPPRESSION.search(line)
            before, behind = hole.span() if hole is not None else (length, length)
            for first, last in ((0, before), (behind, length)):
                if first < last:
                    found.append(SemanticToken(start + first, start + last, "comment"))
            start += len(line)
    return found
