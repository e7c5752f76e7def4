"""Lints one document, and fixes it if requested."""

import os
from collections.abc import Sequence
from enum import Enum
from typing import NamedTuple

from kindsl.frontends.cli.documents.sources import STDIN, NotText, is_decodable, read_text
from kindsl.frontends.cli.outcome import Failure, LintedFile
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.known_findings import Apart, lines_of, set_apart
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.config.file_names import TRANSFORMS_SUFFIX
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.model import Model
from kindsl.robots.interchange.syntaxes import XACRO_SUFFIX, syntax_of

_CODE = "KD004"
_NAME = "invalid-character"


class FixMode(Enum):
    """The way fixes are applied."""

    NONE = "none"
    SHOWN = "shown"
    WRITTEN = "written"


class Task(NamedTuple):
    """One document to lint.

    Attributes:
        path: The file, or `-` for stdin.
        shown: Its name in messages.
        settings: Decisions for it.
        fix_mode: How fixes are applied.
        with_unsafe: Whether unsafe fixes are wanted too.
        with_verdicts: Whether the verdicts of the generators are wanted.
    """

    path: str
    shown: str
    settings: Settings
    fix_mode: FixMode = FixMode.NONE
    with_unsafe: bool = False
    with_verdicts: bool = False


class Checked(NamedTuple):
    """The result of a task: a linted file, a failure, or both if a fixed file is not writable.

    Attributes:
        failure: Why it could not be linted, or not be written.
        others: Files that it is made of, in which something was found.
    """

    file: LintedFile | None
    failure: Failure | None
    others: tuple[LintedFile, ...] = ()


def check(task: Task) -> Checked:
    """Lint a document; never raises, so that the others are linted too."""
    text = read_text(task.path, task.shown)
    if isinstance(text, Failure):
        return Checked(None, text)
    if isinstance(text, NotText):
        return Checked(no_document(task.shown, text), None)
    try:
        return _checked(task, text)
    except Exception as error:
        return Checked(None, _defect(task, error, f"{type(error).__name__}: {error}"))


def _checked(task: Task, text: str) -> Checked:
    if task.shown.endswith(TRANSFORMS_SUFFIX):
        return Checked(_transforms(task, text), None)
    if task.shown.endswith(XACRO_SUFFIX) and task.path != STDIN:
        from kindsl.frontends.cli.linter.expanded import expanded_files

        files = expanded_files(task.path, task.shown, text, task.settings)
        if isinstance(files, Failure):
            return Checked(None, files)
        return Checked(files[0], None, files[1:])
    analysis, n_fixed, failure = _fixed(task, text)
    found: Sequence[Diagnostic] = analysis.findings
    if any(finding.fix is not None for finding in found):
        from kindsl.judgement.analysis.fixing import announced

        found = announced(analysis)
    parameters = frozenset(str(parameter.name) for parameter in analysis.model.parameters)
    file = LintedFile(task.shown, analysis.text, found, parameters, text, n_fixed)
    file.joints = frozenset(str(joint.name) for joint in analysis.model.joints)
    if task.with_verdicts:
        from kindsl.judgement.analysis.verdicts import verdicts

        file.verdicts = tuple(map(str, verdicts(analysis)))
    faults = (_defect(task, fault.error, fault.message) for fault in analysis.faults)
    return Checked(_counting(file, analysis.apart), failure or next(faults, None))


def _fixed(task: Task, text: str) -> tuple[Analysis, int, Failure | None]:
    """Return the document as the task wants it fixed, and the failure of writing it."""
    analysis = Analysis(syntax_of(task.shown, text), task.settings)
    if task.fix_mode is FixMode.NONE or not is_decodable(text):
        return analysis, 0, None
    from kindsl.frontends.cli.documents.writing import write_text
    from kindsl.judgement.analysis.fixing import fixed, is_fixable, is_safe

    better, n_fixed, _ = fixed(analysis, is_fixable if task.with_unsafe else is_safe)
    if task.fix_mode is FixMode.WRITTEN and task.path != STDIN and better.text != text:
        failure = write_text(task.path, task.shown, text, better.text)
        if failure is not None:
            return analysis, 0, failure
    return better, n_fixed, None


def _transforms(task: Task, text: str) -> LintedFile:
    from kindsl.judgement.analysis.transforms_findings import transforms_findings
    from kindsl.judgement.config.robots import robot_beside
    from kindsl.language.syntax.transforms_text import read_transforms

    def name_of(path: str) -> str | None:
        model = _model_in(path)
        return str(model.name) if model is not None else None

    model = None
    if task.path != STDIN:
        robot = read_transforms(text).robot
        path = robot_beside(task.path, robot.text if robot is not None else None, name_of)
        model = _model_in(path) if path is not None else None
    apart = set_apart(
        transforms_findings(text, model, task.settings), lines_of(text), task.settings
    )
    return _counting(LintedFile(task.shown, text, apart.reported), apart)


def _model_in(path: str) -> Model | None:
    text = read_text(path, path)
    return analyse(text).model if isinstance(text, str) else None


def _defect(task: Task, error: Exception, what: str) -> Failure:
    if os.environ.get("KINDSL_TRACEBACK"):
        raise error
    return Failure(task.shown, f"internal error: {what}")


def _counting(file: LintedFile, apart: Apart) -> LintedFile:
    file.n_known, file.n_stale = len(apart.known), len(apart.stale)
    return file


def no_document(shown: str, content: NotText) -> LintedFile:
    """Return a file whose content is not text, with the one finding that says so."""
    end = min(content.offset + 1, len(content.text))
    message = f"the document {content.message}"
    finding = Diagnostic(_CODE, _NAME, Severity.ERROR, message, content.offset, end)
    return LintedFile(shown, content.text, [finding])
