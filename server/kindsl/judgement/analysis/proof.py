"""The effect of edits on a document: on its numbers, its comments, its blocks.

Both texts are read as tolerantly as everywhere; of what is equal in both nothing is computed.
"""

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from kindsl.judgement.analysis.contents import Contents, Number, contents
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Island
from kindsl.language.text.edits import in_common

# Four units in the last place of a double: what writing a number in other words may cost.
_SAME = 1e-15


class Effect(NamedTuple):
    """The effect of edits on a document.

    Attributes:
        is_kept: Whether every number, reference and block is known to mean what it meant.
        is_whole: Whether no comment and no block is lost.
    """

    is_kept: bool
    is_whole: bool


def effect(before: SyntaxDocument, after: SyntaxDocument, *, within_digits: bool = False) -> Effect:
    """Return the effect of edits on a document.

    Args:
        within_digits: Whether a number keeps its value where the digits written are the new one's.
    """
    n_first, n_last = in_common(before.islands, after.islands)
    old = before.islands[n_first : len(before) - n_last]
    new = after.islands[n_first : len(after) - n_last]
    was, now = contents(old), contents(new)
    remarks = was.remarks - now.remarks
    unread = was.unread - now.unread - now.remarks
    is_kept = (
        not (remarks or unread)
        and was.references == now.references
        and was.blocks == now.blocks
        and _n_problems(after, new) <= _n_problems(before, old)
        and was.numbers.keys() == now.numbers.keys()
        and all(_is_kept(n, now.numbers[place], within_digits) for place, n in was.numbers.items())
    )
    return Effect(is_kept, not remarks and not _kinds(was) - _kinds(now))


def _kinds(found: Contents) -> Counter[str]:
    return Counter(str(block.place[-2]) for block in found.blocks)


def _n_problems(document: SyntaxDocument, islands: Sequence[Island]) -> int:
    return len(document.problems) + sum(len(island.problems) for island in islands)


def _is_kept(old: Number, new: Number, within_digits: bool) -> bool:
    if old.words == new.words:
        return True
    if old.value is None or new.value is None:
        return False
    is_same = abs(old.value - new.value) <= _SAME * abs(old.value) or old.value == new.value
    return is_same or (within_digits and _has_digits(new.value, old))


def _has_digits(value: float, written: Number) -> bool:
    """Return whether a value has the digits of a number, rounded or truncated."""
    assert written.value is not None
    is_rounded = abs(value - written.value) <= written.rounding
    rest = value - written.value if written.value > 0.0 else written.value - value
    return is_rounded or 0.0 <= rest < 2.0 * written.rounding
