"""The outcome of a run of the linter: findings and failures."""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.lines import LineIndex

if TYPE_CHECKING:
    from kindsl.judgement.config.errors import ConfigurationError


class Failure(NamedTuple):
    """A document or path that could not be linted.

    Attributes:
        path: The file or folder, as shown.
        message: Why not: one sentence without final period.
        line: From 1, as the column is; None where no place is known.
    """

    path: str
    message: str
    line: int | None = None
    column: int | None = None

    def __str__(self) -> str:
        place = "" if self.line is None else f":{self.line}:{self.column}"
        return f"{self.path}{place}: error: {self.message}"


class LintedFile:
    """A text and its findings.

    Attributes:
        path: As shown.
        text: The text that the findings' offsets refer to, after fixes if any were made.
        verdicts: Those of the generators, where they are asked for.
        n_known: How many findings are left out, since the baseline knows them.
        n_stale: How many findings the baseline knows that are no longer there.
        original: The text before fixes.
    """

    def __init__(
        self,
        path: str,
        text: str,
        findings: Sequence[Diagnostic],
        parameters: frozenset[str] = frozenset(),
        original: str | None = None,
        n_fixed: int = 0,
    ) -> None:
        self.path = path
        self.text = text
        self.findings = findings
        self.parameters = parameters
        self.joints: frozenset[str] = frozenset()
        self.verdicts: tuple[str, ...] = ()
        self.original = text if original is None else original
        self.n_fixed = n_fixed
        self.n_known = self.n_stale = 0

    @cached_property
    def lines(self) -> LineIndex:
        """Offsets at which its lines begin."""
        return LineIndex(self.text)

    def place(self, offset: int) -> tuple[int, int]:
        """Return line and column of an offset, both from 1."""
        return self.lines.place(offset)

    def with_all_known(self) -> "LintedFile":
        """Return the file with all its findings known."""
        from copy import copy

        file = copy(self)
        file.findings, file.n_known = (), self.n_known + len(self.findings)
        return file

    def count(self, severity: Severity) -> int:
        """Return the number of findings of a severity."""
        return sum(finding.severity is severity for finding in self.findings)


class RunOutcome(NamedTuple):
    """A whole run.

    Attributes:
        files: The linted files, in the order asked for.
        failures: Those that could not be.
        failing: The severities that make the run fail.
        remarks: Sentences about what the run rested on.
        is_verbose: Whether people are told each finding, however often it is repeated.
    """

    files: Sequence[LintedFile]
    failures: Sequence[Failure]
    failing: frozenset[Severity] = frozenset((Severity.ERROR,))
    remarks: Sequence[str] = ()
    is_verbose: bool = False

    def count(self, severity: Severity) -> int:
        """Return the number of findings of a severity."""
        return sum(file.count(severity) for file in self.files)


class UnknownRuleError(Exception):
    """No rule has a code or name that somebody asked about."""


def as_failures(error: "ConfigurationError") -> list[Failure]:
    """Return the errors of a configuration file as failures."""
    return [
        Failure(problem.path, problem.message, problem.place.line, problem.place.column)
        for problem in error.problems
    ]
