"""The words that a repair writes: the nearest spelling, and each moment of inertia but once."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from kindsl.language.syntax.automaton import ROWS, Stack
from kindsl.language.syntax.recovery.repair import RepairStep
from kindsl.language.syntax.token_names import SPELLINGS, spelled
from kindsl.language.syntax.tree import Token
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.nearest import nearest_words


class Word(NamedTuple):
    """The word that a change writes.

    Attributes:
        text: The word or sign; empty where it may be anything, or where something is taken away.
        near: The keywords that are nearest to what it takes the place of, if any is near.
    """

    text: str
    near: tuple[str, ...] = ()


def repair_words(
    changes: Iterable[RepairStep], tokens: Sequence[Token], present: Iterable[str]
) -> tuple[Word, ...]:
    """Return what each change of a repair writes."""
    lacking = [moment for moment in MOMENTS if moment not in present] or list(MOMENTS)
    words = []
    for change in changes:
        word = _word(change, tokens, lacking)
        if change.kind == "MOMENT" and word.text in lacking and len(lacking) > 1:
            lacking.remove(word.text)
        words.append(word)
    return tuple(words)


def is_alike(token: Token, kind: str) -> bool:
    """Return whether a written token may stand in the tree for one of another kind."""
    if kind in SPELLINGS or kind == "NAME":
        return token.text[:1].isidentifier()
    if kind in ("FLOAT", "INT"):
        return False
    return len(token.text) == 1 and not token.text.isidentifier()


def fitting_words(stack: Stack) -> tuple[str, ...]:
    """Return the keywords that could be read next."""
    kinds = (kind for kind in ROWS[stack.state] if kind in SPELLINGS)
    return tuple(word for kind in kinds if stack.after(kind) for word in SPELLINGS[kind])


def _word(change: RepairStep, tokens: Sequence[Token], lacking: Sequence[str]) -> Word:
    if change.action == "delete":
        return Word("")
    is_moment = change.kind == "MOMENT"
    usual = lacking[0] if is_moment else spelled(change.kind)
    if change.action == "insert":
        return Word(usual)
    known = lacking if is_moment else SPELLINGS.get(change.kind, ())
    written = tokens[change.at].text
    if change.kind == "INT":
        return Word(_whole(tokens[change.at]))
    near = nearest_words(written, known) if written[:1].isidentifier() else ()
    return Word(near[0] if near else usual, near)


def _whole(token: Token) -> str:
    whole, _, fraction = token.text.partition(".")
    is_whole = token.kind == "FLOAT" and whole.isdigit() and not fraction.strip("0")
    return whole if is_whole and int(whole) > 0 else ""
