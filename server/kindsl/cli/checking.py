"""Lints one document, mending it if that is wanted."""

import os
from collections.abc import Sequence
from enum import Enum

from kindsl.cli.outcome import Failure, LintedFile
from kindsl.cli.sources import STDIN, NotText, is_decodable, read_text
from kindsl.rules.analysis import Analysis, analyse
from kindsl.rules.diagnostics import Diagnostic
from kindsl.rules.settings import Settings
from kindsl.text.named_tuple import NamedTuple


class Mending(Enum):
    """What becomes of fixes."""

    NONE = "none"
    SHOWN = "shown"
    WRITTEN = "written"


class Task(NamedTuple):
    """One document to lint.

    Attributes:
        path: The file, or `-` for stdin.
        shown: What to call it.
        settings: What is decided for it.
        mending: What becomes of fixes.
        with_unsafe: Whether unsafe fixes are wanted too.
    """

    path: str
    shown: str
    settings: Settings
    mending: Mending = Mending.NONE
    with_unsafe: bool = False


class Checked(NamedTuple):
    """What became of a task: a linted file, a failure, or both if mending could not be written."""

    file: LintedFile | None
    failure: Failure | None


def check(task: Task) -> Checked:
    """Lint a document; whatever happens, the others can be linted after it."""
    text = read_text(task.path, task.shown)
    if isinstance(text, Failure):
        return Checked(None, text)
    if isinstance(text, NotText):
        from kindsl.cli.undecodable import no_document

        return Checked(no_document(task.shown, text), None)
    try:
        return _checked(task, text)
    except Exception as error:
        if os.environ.get("KINDSL_TRACEBACK"):
            raise
        what = f"{type(error).__name__}: {error}"
        return Checked(None, Failure(task.shown, f"a defect of kindsl itself: {what}"))


def _checked(task: Task, text: str) -> Checked:
    analysis = analyse(text, task.settings)
    if not is_decodable(text):
        from kindsl.cli.undecodable import with_undecodable

        return Checked(_file(task, analysis, with_undecodable(text, analysis.findings)), None)
    if task.mending is Mending.NONE:
        return Checked(_file(task, analysis, analysis.findings), None)
    from kindsl.cli.fixing import mended
    from kindsl.cli.writing import write_text

    better, n_fixed = mended(analysis, task.with_unsafe)
    if task.mending is Mending.WRITTEN and task.path != STDIN and better.text != text:
        failure = write_text(task.path, task.shown, text, better.text)
        if failure is not None:
            return Checked(_file(task, analysis, analysis.findings), failure)
    return Checked(_file(task, better, better.findings, text, n_fixed), None)


def _file(
    task: Task,
    analysis: Analysis,
    findings: Sequence[Diagnostic],
    original: str | None = None,
    n_fixed: int = 0,
) -> LintedFile:
    parameters = frozenset(str(parameter.name) for parameter in analysis.model.parameters)
    return LintedFile(task.shown, analysis.text, findings, parameters, original, n_fixed)
