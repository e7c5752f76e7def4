"""All fixes of a document at once, as edits that an editor makes in one step."""

from collections.abc import Callable
from difflib import SequenceMatcher

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.fixing import fixed, is_safe
from kindsl.language.text.edits import TextEdit


def fix_all(
    analysis: Analysis, is_wanted: Callable[[Diagnostic], bool] = is_safe
) -> tuple[TextEdit, ...]:
    """Return the edits that fix what can be fixed."""
    better, _, rounds = fixed(analysis, is_wanted)
    return rounds[0] if len(rounds) == 1 else line_edits(analysis.text, better.text)


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
