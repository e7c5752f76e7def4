"""All fixes of a document at once, until none is left."""

from bisect import bisect_left, insort
from collections.abc import Iterable
from difflib import SequenceMatcher

from kindsl.analysis.analysis import Analysis
from kindsl.analysis.diagnostics import Diagnostic
from kindsl.text.edits import TextEdit

_ROUNDS = 10


def fix_all(
    analysis: Analysis, codes: Iterable[str] | None = None, *, with_unsafe: bool = False
) -> tuple[TextEdit, ...]:
    """Return the edits that mend what can be mended; fixes that meet others wait for a next round.

    Args:
        analysis: The document.
        codes: The rules to mend; all if None.
        with_unsafe: Whether to take fixes that may change what was meant.
    """
    wanted = None if codes is None else frozenset(codes)
    current = analysis
    first: tuple[TextEdit, ...] = ()
    for done in range(_ROUNDS):
        edits = disjoint_fixes(current, wanted, with_unsafe=with_unsafe)
        if not edits:
            return first if done < 2 else line_edits(analysis.text, current.text)
        first = first or edits
        current = current.edited(edits)
    return line_edits(analysis.text, current.text)


def disjoint_fixes(
    analysis: Analysis, codes: frozenset[str] | None, *, with_unsafe: bool
) -> tuple[TextEdit, ...]:
    """Return the edits of as many fixes as can be made at once, in the order of the text."""
    taken: list[TextEdit] = []
    for finding in sorted(analysis.findings, key=_first_edit):
        fix = finding.fix
        if fix is None or not (fix.is_safe or with_unsafe):
            continue
        if codes is not None and finding.code not in codes:
            continue
        new = [edit for edit in fix.edits if not _has(taken, edit)]
        if all(_is_apart(taken, edit) for edit in new):
            for edit in new:
                insort(taken, edit)
    return tuple(taken)


def _first_edit(finding: Diagnostic) -> tuple[int, int]:
    edits = finding.fix.edits if finding.fix is not None else ()
    return (min(edit.start for edit in edits) if edits else -1, finding.start)


def _has(taken: list[TextEdit], edit: TextEdit) -> bool:
    index = bisect_left(taken, edit)
    return taken[index : index + 1] == [edit]


def _is_apart(taken: list[TextEdit], edit: TextEdit) -> bool:
    """Return whether an edit neither overlaps nor touches sorted, disjoint ones."""
    index = bisect_left(taken, edit)
    before, behind = taken[max(index - 1, 0) : index], taken[index : index + 1]
    return all(t.end < edit.start for t in before) and all(edit.end < t.start for t in behind)


def line_edits(old: str, new: str) -> tuple[TextEdit, ...]:
    """Return the edits that turn one text into another, line by line."""
    before, after = old.splitlines(keepends=True), new.splitlines(keepends=True)
    starts = [0]
    for line in before:
        starts.append(starts[-1] + len(line))
    matcher = SequenceMatcher(None, before, after, autojunk=False)
    return tuple(
        TextEdit(starts[a], starts[b], "".join(after[c:d]))
        for tag, a, b, c, d in matcher.get_opcodes()
        if tag != "equal"
    )
