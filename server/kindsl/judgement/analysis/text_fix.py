"""A fix as edits of the text, safe only if it is proven to be."""

from bisect import bisect_left, insort
from collections.abc import Iterable, Sequence

from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.text.edits import TextEdit


class TextFix:
    """A change of the document's text.

    Attributes:
        edits: Disjoint, in the order of the text.
        is_within_digits: Whether it may give a number a value that has the digits written.
    """

    __slots__ = ("_claim", "_document", "_is_proven", "edits", "is_within_digits", "title")

    def __init__(
        self,
        title: str,
        is_safe: bool,
        edits: tuple[TextEdit, ...],
        is_within_digits: bool = False,
        document: SyntaxDocument | None = None,
    ) -> None:
        """Make a fix; that it is safe is believed only without the document."""
        self.title = title
        self.edits = edits
        self.is_within_digits = is_within_digits
        self._claim = is_safe
        self._document = document
        self._is_proven = document is None or not is_safe

    @property
    def is_safe(self) -> bool:
        """True if it keeps the document's meaning; tried out when that is asked for."""
        if not self._is_proven:
            self._claim, self._is_proven = _is_kept([self]), True
        return self._claim

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TextFix) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)

    def __reduce__(self) -> tuple[object, ...]:
        return TextFix, (self.title, self.is_safe, self.edits, self.is_within_digits)

    def __repr__(self) -> str:
        return f"TextFix({self.title!r}, {self.edits!r})"

    @property
    def _key(self) -> tuple[object, ...]:
        return self.title, self.edits, self.is_within_digits


def prove(fixes: Iterable[TextFix]) -> None:
    """Find out which fixes of one document are safe, those that do not touch at once.

    What is kept by many together is kept by each; otherwise halves of them are tried.
    """
    claimed = [fix for fix in fixes if not fix._is_proven]
    pending = [
        disjoint(fix for fix in claimed if fix.is_within_digits is within_digits)
        for within_digits in (False, True)
    ]
    while pending:
        some = pending.pop()
        if len(some) > 1 and _is_kept(some):
            for fix in some:
                fix._is_proven = True
        elif len(some) > 1:
            pending += [some[: len(some) // 2], some[len(some) // 2 :]]


def _is_kept(fixes: Sequence[TextFix]) -> bool:
    from kindsl.judgement.analysis.proof import effect

    document, within_digits = fixes[0]._document, fixes[0].is_within_digits
    assert document is not None
    after = document.edited(edits_of(fixes))
    return effect(document, after, within_digits=within_digits).is_kept


def edits_of(fixes: Iterable[TextFix]) -> list[TextEdit]:
    """Return the edits of disjoint fixes in their order, shared ones once."""
    return sorted({edit for fix in fixes for edit in fix.edits})


def disjoint(fixes: Iterable[TextFix]) -> list[TextFix]:
    """Return the fixes that do not touch one before them; fixes may share edits."""
    taken: list[TextEdit] = []
    chosen = []
    for fix in fixes:
        new = [edit for edit in fix.edits if not _is_among(taken, edit)]
        if fix.edits and all(_is_apart(taken, edit) for edit in new):
            for edit in new:
                insort(taken, edit)
            chosen.append(fix)
    return chosen


def _is_among(taken: list[TextEdit], edit: TextEdit) -> bool:
    index = bisect_left(taken, edit)
    return taken[index : index + 1] == [edit]


def _is_apart(taken: list[TextEdit], edit: TextEdit) -> bool:
    """Return whether an edit neither overlaps nor touches sorted, disjoint ones."""
    index = bisect_left(taken, edit)
    before, behind = taken[max(index - 1, 0) : index], taken[index : index + 1]
    return all(t.end < edit.start for t in before) and all(edit.end < t.start for t in behind)
