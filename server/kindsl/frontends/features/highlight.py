"""Highlights in the document for the name or value at the cursor."""

from typing import NamedTuple

from kindsl.frontends.features.symbol_at import Role, occurrences, symbol_at
from kindsl.frontends.features.tree_path import TokenAt, token_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.syntax.tree import Token

_PAIRS = {"{": "}", "(": ")", "[": "]", "<": ">"}
_CLOSING = {close: opening for opening, close in _PAIRS.items()}


class Highlight(NamedTuple):
    """A stretch to light up: `text`, or `read` or `write` for a name."""

    start: int
    end: int
    kind: str


def highlights(analysis: Analysis, offset: int) -> tuple[Highlight, ...]:
    """Return all places of the name at an offset, or the bracket there and its partner."""
    symbol = symbol_at(analysis, offset)
    if symbol is not None:
        places = occurrences(analysis, symbol.entity)
        return tuple(Highlight(p.start, p.end, _kind(p.role)) for p in places)
    found = token_at(analysis.syntax, offset)
    return () if found is None else _brackets(found)


def _kind(role: Role) -> str:
    return "read" if role is Role.READ else "write"


def _brackets(found: TokenAt) -> tuple[Highlight, ...]:
    if not found.path:
        return ()
    signs = [t for t in found.path[-1].children if isinstance(t, Token) and not t.is_missing]
    partner_kind = _PAIRS.get(found.token.kind) or _CLOSING.get(found.token.kind)
    partner = next((t for t in signs if t.kind == partner_kind), None)
    if partner is None:
        return ()
    pair = sorted((found.token, partner), key=lambda token: token.start)
    return tuple(Highlight(found.origin + t.start, found.origin + t.end, "text") for t in pair)
