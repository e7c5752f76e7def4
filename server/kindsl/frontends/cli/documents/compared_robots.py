"""Reads what is compared: two robots of any formats, or two versions of a document."""

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from kindsl.frontends.cli.documents.choices import Choices
from kindsl.frontends.cli.documents.document_reading import (
    CommandError,
    analysed_text,
    defect,
    read_document,
    read_whole,
    refusals,
    require_parameters,
    require_syntax,
    shown_name,
    unbound,
)
from kindsl.frontends.cli.documents.sources import STDIN
from kindsl.frontends.cli.outcome import Failure
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.config.robots import is_robot
from kindsl.robots.comparison.side import ComparedSide
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.registry import format_of_suffix

if TYPE_CHECKING:
    from kindsl.robots.interchange.descriptions import ReadDescription

Versions = tuple[Analysis | None, Analysis | None]


class ComparedRobots(NamedTuple):
    """Two robots, notes on how they were read, and defects of documents that are cut short."""

    old: ComparedSide
    new: ComparedSide
    notes: list[str]
    failures: list[Failure]


def is_foreign(path: str) -> bool:
    """Return whether a path is no document of ours: another format's, or a folder."""
    is_other = format_of_suffix(Path(path).suffix) is not None and not is_robot(path)
    return is_other or (path != STDIN and Path(path).is_dir())


def read_robots(paths: Sequence[str], choices: Choices) -> ComparedRobots:
    """Return two robots; the base of the other format is taken as that of the document.

    Raises:
        CommandError: One cannot be read or built.
    """
    documents = {path: read_document(path, choices) for path in paths if not is_foreign(path)}
    if documents:
        require_parameters(next(iter(documents)), *documents.values())
    from kindsl.robots.interchange.descriptions import read_foreign

    labels = _labels([shown_name(path) for path in paths])
    label_of = dict(zip(paths, labels, strict=True))
    sides: dict[str, ComparedSide] = {}
    failures: list[Failure] = []
    for path, analysis in documents.items():
        sides[path], failed = _document(path, label_of[path], analysis)
        failures += failed
    others = [path for path in paths if path not in documents]

    def read(path: str, floating: bool | None) -> "ReadDescription":
        return _foreign(path, label_of[path], floating)

    foreign = read_foreign(others, sides.values(), read)
    sides |= {p: replace(read.robot, shown=shown_name(p)) for p, read in foreign.items()}
    notes = [note for read in foreign.values() for note in read.notes]
    old, new = (sides[path] for path in paths)
    return ComparedRobots(old, new, notes, failures)


def _labels(names: Sequence[str]) -> Sequence[str]:
    """Return names for two files in sentences: the ends of their paths that differ."""
    parts = [Path(name).parts for name in names]
    for n in range(1, max(map(len, parts))):
        ends = [str(Path(*each[-n:])) for each in parts]
        if len(set(ends)) == len(names):
            return ends
    return names


def _document(path: str, label: str, analysis: Analysis) -> tuple[ComparedSide, list[Failure]]:
    """Return the robot of a document, and its defects if only a part can be read."""
    from kindsl.judgement.analysis.compared_document import compared_document
    from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError
    from kindsl.robots.mechanism.reading import partial_linkage

    failures: list[Failure] = []
    values = analysis.context.values
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
        found = partial_linkage(analysis.model, values)
        if found is None:
            raise CommandError(failures) from None
        skeleton = found
    side = compared_document(label, analysis, values, skeleton)
    return replace(side, shown=shown_name(path)), failures


def _foreign(path: str, label: str, floating: bool | None) -> "ReadDescription":
    from kindsl.robots.interchange.descriptions import read_description

    with refusals(path, OSError, FormatError):
        return read_description(Path(path), label, floating)


def read_versions(paths: Sequence[str], choices: Choices) -> Versions:
    """Return two versions; /dev/null is a missing one, as in git.

    Raises:
        CommandError: A file or the configuration cannot be read, or no robot is in one.
    """
    texts = [None if path == os.devnull else read_whole(path) for path in paths]
    if texts == [None, None]:
        raise CommandError.about(os.devnull, "there is no document to compare")
    return analysed_versions(paths[0 if texts[1] is None else 1], texts, choices, paths)


def analysed_versions(
    path: str, texts: Sequence[str | None], choices: Choices, paths: Sequence[str] = ()
) -> Versions:
    """Return two versions of a document from its texts; None is a missing one.

    Errors name the path, unless the versions have paths of their own.

    Raises:
        CommandError: The configuration cannot be read, or no robot is in a text.
    """
    old, new = (
        None if text is None else analysed_text(own, text, choices)
        for text, own in zip(texts, paths or (path, path), strict=True)
    )
    require_parameters(path, *(version for version in (old, new) if version is not None))
    return old, new
