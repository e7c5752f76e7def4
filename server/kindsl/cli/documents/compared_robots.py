"""Reads two robots of any formats, to compare their mechanics."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from kindsl.cli.documents.document_reading import (
    CommandError,
    defect,
    missing_module,
    read_document,
    require_parameters,
    require_syntax,
    shown_name,
    unbound,
)
from kindsl.cli.documents.sources import STDIN, reason
from kindsl.cli.documents.versions import require_own
from kindsl.cli.outcome import Failure
from kindsl.comparison.compared_robot import ComparedRobot
from kindsl.config.robots import is_robot
from kindsl.interchange.format import FormatError
from kindsl.interchange.registry import format_of_suffix
from kindsl.text.lines import LineIndex

if TYPE_CHECKING:
    from kindsl.analysis.analysis import Analysis
    from kindsl.cli.documents.choices import Choices
    from kindsl.interchange.descriptions import ReadDescription
    from kindsl.semantics.places import Located


class ComparedRobots(NamedTuple):
    """Two robots.

    Attributes:
        old: A robot.
        new: Another.
        notes: On how they were read.
        failures: Defects of a document of which the rest is compared.
    """

    old: ComparedRobot
    new: ComparedRobot
    notes: tuple[str, ...]
    failures: tuple[Failure, ...]


def is_foreign(path: str) -> bool:
    """Return whether a path is no document of ours: another format's, or a folder."""
    is_other = format_of_suffix(Path(path).suffix) is not None and not is_robot(path)
    return is_other or (path != STDIN and Path(path).is_dir())


def read_robots(paths: Sequence[str], choices: "Choices") -> ComparedRobots:
    """Return two robots; the base of the other format is taken as that of the document.

    Raises:
        CommandError: One cannot be read or built.
    """
    documents = {path: read_document(path, choices) for path in paths if not is_foreign(path)}
    for path, analysis in documents.items():
        require_own(path, analysis.text)
    if documents:
        require_parameters(next(iter(documents)), *documents.values())
    bases = [a.model.base.is_floating for a in documents.values() if a.model.base is not None]
    reads = {} if documents else {path: _foreign(path, None) for path in paths}
    bases += [each.robot.skeleton.is_floating for each in reads.values() if each.tells_base]
    sides: list[ComparedRobot] = []
    notes: list[str] = []
    failures: list[Failure] = []
    for path in paths:
        if path in documents:
            side, failed = _document(path, documents[path])
            failures += failed
        else:
            read = reads.get(path)
            if read is None or (bases and not read.tells_base):
                read = _foreign(path, bases[0] if bases else None)
            side = ComparedRobot(shown_name(path), read.robot)
            notes += read.notes
        sides.append(side)
    return ComparedRobots(sides[0], sides[1], tuple(notes), tuple(failures))


def _document(path: str, analysis: "Analysis") -> tuple[ComparedRobot, list[Failure]]:
    """Return the robot of a document, and what is wrong with it where only a part can be read."""
    from kindsl.comparison.document_side import described_document
    from kindsl.mechanism.errors import ModelError, UnboundParameterError
    from kindsl.mechanism.fragments import skeleton_as_far_as_known

    failures: list[Failure] = []
    model, values = analysis.model, analysis.context.values
    try:
        require_syntax(path, analysis)
        skeleton = analysis.skeleton()
    except UnboundParameterError as error:
        raise unbound(path, analysis, error) from None
    except (CommandError, ModelError) as error:
        told = (
            error
            if isinstance(error, CommandError)
            else defect(path, analysis, str(error), error.at)
        )
        failures = told.failures
        found = skeleton_as_far_as_known(model, values)
        if found is None:
            raise CommandError(failures) from None
        skeleton = found
    lines = LineIndex(analysis.text)

    def line_of(at: "Located") -> int:
        return lines.position(analysis.resolver.span(at)[0])[0] + 1

    name = shown_name(path)
    robot = described_document(name, model, values, skeleton)
    robot = replace(robot, properties=analysis.settings.joints)
    return ComparedRobot(name, robot, line_of), failures


def _foreign(path: str, floating: bool | None) -> "ReadDescription":
    from kindsl.interchange.descriptions import read_description

    try:
        return read_description(Path(path), path, floating)
    except ModuleNotFoundError as error:
        format = format_of_suffix(Path(path).suffix)
        raise missing_module(path, error, format.extra if format else "") from None
    except OSError as error:
        raise CommandError([Failure(path, reason(path, error))]) from None
    except FormatError as error:
        raise CommandError([Failure(path, str(error))]) from None
