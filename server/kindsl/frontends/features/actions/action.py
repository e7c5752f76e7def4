"""A change that an editor offers."""

from typing import NamedTuple

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.language.text.edits import TextEdit

REWRITE = "refactor.rewrite"


class OtherEdit(NamedTuple):
    """A change of another file: the old text from `start` to `end`, and the new text."""

    start: int
    end: int
    old: str
    new: str


class CodeAction(NamedTuple):
    """A change that an editor offers.

    Attributes:
        kind: `quickfix`, `refactor.extract`, `refactor.inline`, `refactor.rewrite`,
            `source.fixAll.kindsl`, `refactor.rewrite.suppress` and the like.
        diagnostics: The findings that it fixes.
        is_preferred: Whether an editor may do it unasked, by one key.
        bindings: Values to give to parameters in `kindsl.toml` along with the change; without
            them the document does not mean the same.
        other_file: The path of another file to change, empty for none.
    """

    title: str
    kind: str
    edits: tuple[TextEdit, ...]
    diagnostics: tuple[Diagnostic, ...] = ()
    is_preferred: bool = False
    bindings: tuple[tuple[str, float], ...] = ()
    other_file: str = ""
    other_edits: tuple[OtherEdit, ...] = ()
