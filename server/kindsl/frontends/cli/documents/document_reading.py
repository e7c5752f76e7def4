"""Reads the one document that a command is about."""

import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.documents.choices import Choices, choices_of
from kindsl.frontends.cli.documents.sources import STDIN, UNNAMED, read_source, reason
from kindsl.frontends.cli.outcome import Failure, as_failures
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.translated_robot import (
    TranslatedRobot,
    UnreadableRobotError,
    analysed_robot,
)
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.robots import is_robot
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.places import Located
from kindsl.language.syntax.readings import two_readings
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.nearest import hint, nearest_name
from kindsl.language.text.printable import printable
from kindsl.robots.interchange.format import ReadingChoices
from kindsl.robots.interchange.syntaxes import other_format

if TYPE_CHECKING:
    from argparse import Namespace

    from kindsl.robots.mechanism.errors import UnboundParameterError
    from kindsl.robots.mechanism.linkage import Linkage

# The extra of kindsl that installs a library which not every command needs.
_EXTRAS = {
    "cattrs": "preview",
    "jinja2": "robcogen",
    "mujoco": "mjcf",
    "numpy": "numpy",
    "tornado": "preview",
    "umsgpack": "preview",
}
_SYNTAX = "KD0"
_SPACE = "\ufeff \t\r\n"


class CommandError(Exception):
    """A command cannot do its work.

    Attributes:
        failures: Sentences on its defects, with places.
        status: Exit status: 1 for a defect of the document, 2 for anything else.
    """

    def __init__(self, failures: list[Failure], status: int = 2) -> None:
        super().__init__("\n".join(map(str, failures)))
        self.failures = failures
        self.status = status

    @classmethod
    def about(cls, path: str, message: str, status: int = 2) -> "CommandError":
        """Return the error with one sentence about a file, `-` for stdin, or about an option."""
        return cls([Failure(shown_name(path), message)], status)

    def tell(self) -> int:
        """Report the failures on stderr and return the exit status."""
        write(sys.stderr, "".join(f"{printable(str(failure))}\n" for failure in self.failures))
        return self.status


def report_error(error: Exception) -> int:
    """Report what a command cannot do on stderr and return the exit status; raise other errors."""
    if isinstance(error, ConfigurationError):
        error = CommandError(as_failures(error))
    if isinstance(error, ModuleNotFoundError) and error.name in _EXTRAS:
        message = f"{error.name} is not installed: pip install 'kindsl[{_EXTRAS[error.name]}]'"
        error = CommandError.about("kindsl", message)
    if not isinstance(error, CommandError):
        raise error
    return error.tell()


def shown_name(path: str) -> str:
    """Return the name to report for a document."""
    return UNNAMED if path == STDIN else path


def read_whole(path: str) -> str:
    """Return the text of a file, or of stdin for `-`.

    Raises:
        CommandError: It cannot be read.
    """
    text = read_source(path, shown_name(path))
    if isinstance(text, Failure):
        raise CommandError([text])
    return text


def read_document(path: str, choices: Choices) -> Analysis:
    """Return the analysis of a robot's file of any format, or of stdin for `-`.

    Raises:
        CommandError: The file or the configuration cannot be read, or no robot is in it.
    """
    return analysed_text(path, read_whole(path), choices, None if path == STDIN else Path(path))


def read_named(args: "Namespace") -> Analysis:
    """Return the analysis of the robot that the arguments name, with the values that they give.

    Raises:
        CommandError: It cannot be read, or has no parameter of that name.
    """
    analysis = read_document(args.file, choices_of(args))
    require_parameters(args.file, analysis)
    return analysis


def analysed_text(path: str, text: str, choices: Choices, file: Path | None = None) -> Analysis:
    """Return the analysis of a robot's text, whatever its format.

    With a file, those that it names are read too.

    Raises:
        CommandError: The configuration cannot be read, or no robot is in the text.
    """
    name = shown_name(path)
    if is_robot(name) and text.lstrip(_SPACE).startswith("<"):
        message = "is XML, not a Kinematics-DSL document: name it after its format"
        raise CommandError.about(name, message)
    if choices.floating and other_format(name, text) is None:
        raise CommandError.about(name, "a document says itself whether its base floats")
    reading = ReadingChoices(floating=choices.floating)
    try:
        return analysed_robot(name, text, choices.settings_for(name), file, reading)
    except ConfigurationError as error:
        raise CommandError(as_failures(error)) from None
    except UnreadableRobotError as error:
        failures = _failures(name, text, error.defects)
        raise CommandError(failures or [Failure(name, str(error))], status=1) from None


def require_syntax(path: str, analysis: Analysis) -> None:
    """Raise CommandError if a document has errors of syntax, for what needs all of it.

    Of a robot in another format all that is needed was read.
    """
    if analysis.syntax.is_xml:
        return
    broken = [
        finding
        for finding in analysis.findings
        if finding.code.startswith(_SYNTAX) and finding.severity is Severity.ERROR
    ]
    if broken:
        raise CommandError(_failures(shown_name(path), analysis.text, broken), status=1)


def _failures(name: str, text: str, findings: Iterable[Diagnostic]) -> list[Failure]:
    lines = LineIndex(text)
    return [Failure(name, f"[{f.code}] {f.message}", *lines.place(f.start)) for f in findings]


def require_parameters(path: str, *documents: Analysis) -> None:
    """Raise CommandError for a value on the command line of an unknown parameter.

    Not where the syntax is broken: the parameter may stand in what cannot be read. Of two documents
    that are compared, either may have it.
    """
    models = [analysis.model for analysis in documents]
    if any(model.broken_islands for model in models):
        return
    known = [str(parameter.name) for model in models for parameter in model.parameters]
    for name, binding in documents[0].settings.bindings.items():
        if binding.origin == "--param" and name not in known:
            where = " in either document" if len(documents) > 1 else ""
            meant = hint(nearest_name(name, known), after=",")
            message = f"there is no parameter '{name}'{where}{meant}"
            raise CommandError.about(path, message)


def note_errors(path: str, analysis: Analysis) -> None:
    """Warn on stderr if a document has errors, or is not all of what its file describes."""
    if isinstance(analysis, TranslatedRobot) and analysis.refused:
        first, *others = analysis.refused
        more = f"; {len(others)} more" if others else ""
        write(sys.stderr, f"{shown_name(path)}: note: {printable(first)}{more}\n")
    n_errors = sum(finding.severity is Severity.ERROR for finding in analysis.findings)
    if n_errors:
        told = f"{n_errors} errors" if n_errors > 1 else "an error"
        write(sys.stderr, f"{shown_name(path)}: note: has {told}, see kindsl lint\n")


def note_readings(path: str, analysis: Analysis) -> None:
    """Warn on stderr about values that the generators read differently, and how to decide."""
    if len(analysis.settings.targets) == 1:
        return
    lines = LineIndex(analysis.text)
    for island, start in zip(analysis.syntax.islands, analysis.syntax.starts, strict=True):
        for found in two_readings(island):
            line, column = lines.place(start + found.start)
            place = f"{shown_name(path)}:{line}:{column}"
            taken = found.robcogen if found.kind == "product" else found.other
            message = f"'{found.text}' is taken for {taken}"
            if found.kind != "product":
                message += f"; robcogen takes it for {found.robcogen}: set 'target' in kindsl.toml"
            write(sys.stderr, f"{place}: note: {message}\n")


def defect(path: str, analysis: Analysis, message: str, at: Located | None) -> CommandError:
    """Return the error for a defect of the document."""
    if at is None:
        return CommandError.about(path, message, status=1)
    place = LineIndex(analysis.text).place(analysis.resolver.span(at)[0])
    return CommandError([Failure(shown_name(path), message, *place)], status=1)


def unbound(path: str, analysis: Analysis, error: "UnboundParameterError") -> CommandError:
    """Return the error for parameters without values, and how to give them."""
    how = " ".join(f"--param {name}=VALUE" for name in error.names)
    message = f"{error}; bind with {how}, or under [parameters] in kindsl.toml"
    return defect(path, analysis, message, error.at)


@contextmanager
def refusals(path: str, *kinds: type[Exception], status: int = 2) -> Iterator[None]:
    """Raise CommandError about a file for errors of some kinds, those of the system in words."""
    try:
        yield
    except kinds as error:
        message = reason(path, error) if isinstance(error, OSError) else str(error)
        raise CommandError.about(path, message, status) from None


@contextmanager
def model_errors(path: str, analysis: Analysis) -> Iterator[None]:
    """Raise CommandError for what is wrong with a document's model, or has no value."""
    from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError

    try:
        yield
    except UnboundParameterError as error:
        raise unbound(path, analysis, error) from None
    except ModelError as error:
        raise defect(path, analysis, str(error), error.at) from None


def skeleton_of_document(path: str, analysis: Analysis) -> "Linkage":
    """Return the bodies of a document in plain floats.

    Raises:
        CommandError: It does not describe a mechanism.
    """
    require_syntax(path, analysis)
    with model_errors(path, analysis):
        return analysis.skeleton()
