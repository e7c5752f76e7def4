"""Compares two descriptions of a robot mechanically.

Two documents are compared for reviews: names, frames and signs count; numbers that are the other's
with fewer digits are noted, not counted. Broken documents and parameters without values leave out
what depends on them, which is reported. /dev/null stands for a document that is not there, as git
has it for new and deleted files.

With --mechanics, and always where one of both is of another format (.urdf, .xacro, .xml, .mjcf,
.sdf) or a folder of generated code, only the mechanics count: what moves where and what weighs
what, within the digits written. Exit status 0: equal; 1: different; 2: one cannot be read.

examples:
  kindsl diff old.kindsl new.kindsl
  kindsl diff arm.kindsl arm.urdf
  kindsl diff --mechanics arm.kindsl generated/arm --output-format json
"""

import argparse
import sys
from collections.abc import Iterator
from dataclasses import asdict
from typing import TYPE_CHECKING

from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.documents.choices import choices_of
from kindsl.frontends.cli.documents.compared_robots import is_foreign, read_robots, read_versions
from kindsl.frontends.cli.documents.document_reading import (
    CommandError,
    shown_name,
    skeleton_of_document,
)
from kindsl.frontends.cli.options import add_parameter_arguments
from kindsl.frontends.cli.outcome import Failure
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.printable import printable

if TYPE_CHECKING:
    from kindsl.products.reports.difference_text import ChangeRow
    from kindsl.products.reports.mechanics import MechanicsReport
    from kindsl.robots.comparison.difference import Difference

SUMMARY = "report mechanical differences of two robots"
SAME = 0
CHANGED = 1


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = parser.add_argument
    add("old", metavar="OLD", help="the document before, or any description of a robot")
    add("new", metavar="NEW", help="the document after, or another description")
    add("--mechanics", action="store_true", help="compare mechanics only, not conventions")
    add(
        "--joint",
        action="append",
        default=[],
        type=_joint_pair,
        metavar="OLD=NEW",
        help="which joint of NEW is which of OLD, where neither names nor axes show it",
    )
    add("--output-format", choices=("text", "json", "markdown"), default="text")
    add("--exit-zero", action="store_true", help="exit with 0 despite changes")
    add_parameter_arguments(parser.add_argument_group("parameters and configuration"))


def run(args: argparse.Namespace) -> int:
    """Compare two documents.

    Returns:
        0 if nothing changed, 1 if something did, 2 if one cannot be read or built.
    """
    try:
        if args.mechanics or is_foreign(args.old) or is_foreign(args.new):
            return _mechanics(args)
        found, notes = _difference(args)
    except CommandError as error:
        error.tell()
        return 2
    names = shown_name(args.old), shown_name(args.new)
    write(sys.stdout, _rendered(found, names, notes, args.output_format))
    write(sys.stderr, "".join(f"note: {printable(note)}\n" for note in notes))
    return SAME if found.is_empty or args.exit_zero else CHANGED


def _joint_pair(text: str) -> tuple[str, str]:
    ours, equals, theirs = text.partition("=")
    if not (ours and equals and theirs):
        raise argparse.ArgumentTypeError(f"'{text}' is not OLD=NEW")
    return ours, theirs


def _mechanics(args: argparse.Namespace) -> int:
    from kindsl.products.reports.mechanics import report_of
    from kindsl.robots.comparison.mechanical import unknown_joints

    read = read_robots((args.old, args.new), choices_of(args))
    joints = dict(args.joint)
    unknown = [Failure("--joint", each) for each in unknown_joints(read.old, read.new, joints)]
    if unknown:
        raise CommandError(unknown)
    report = report_of(read.old, read.new, joints)
    write(sys.stdout, _rendered_mechanics(report, args.output_format))
    write(sys.stderr, "".join(f"note: {printable(note)}\n" for note in read.notes))
    if read.failures:
        return CommandError(read.failures).tell()
    return SAME if report.found.is_equal or args.exit_zero else CHANGED


def _rendered_mechanics(report: "MechanicsReport", output_format: str) -> str:
    from kindsl.products.reports.mechanics import facts, lines, markdown

    if output_format == "json":
        import json

        return json.dumps(facts(report), indent=2) + "\n"
    if output_format == "markdown":
        return "".join(markdown(report))
    return "".join(f"{printable(line)}\n" for line in lines(report))


def _difference(args: argparse.Namespace) -> "tuple[Difference, tuple[str, ...]]":
    old, new = read_versions((args.old, args.new), choices_of(args))
    both = ((args.old, old), (args.new, new))
    from kindsl.products.reports.comparison import compared

    found = compared(old, new)
    if found.difference is None:
        path, analysis = both[found.treeless or 0]
        assert analysis is not None, "what is not there lacks no tree"
        skeleton_of_document(path, analysis)
        raise CommandError.about(path, "does not describe a tree of links")
    if found.is_of_whole:
        return found.difference, found.notes
    broken = [
        path
        for path, analysis in both
        if analysis is not None and any(f.severity is Severity.ERROR for f in analysis.findings)
    ]
    notes = [f"{shown_name(path)} has errors: showing the rest" for path in broken]
    return found.difference, (*notes, *found.notes)


def _rendered(
    found: "Difference", names: tuple[str, str], notes: tuple[str, ...], output_format: str
) -> str:
    if output_format == "json":
        import json

        facts = {"old": names[0], "new": names[1], "changed": not found.is_empty, **asdict(found)}
        return json.dumps({**facts, "left_out": notes}, indent=2) + "\n"
    from kindsl.products.reports.difference_text import change_rows

    rows = list(change_rows(found))
    if output_format == "markdown":
        return "".join((*_markdown(rows, names), *(f"\nLeft out: {note}\n" for note in notes)))
    if not rows:
        return "nothing changed mechanically\n"
    from kindsl.products.reports.columns import aligned

    return aligned([(row.kind, row.name, row.change) for row in rows])


def _markdown(rows: "list[ChangeRow]", names: tuple[str, str]) -> Iterator[str]:
    yield f"### Mechanical changes from `{names[0]}` to `{names[1]}`\n\n"
    if not rows:
        yield "None.\n"
        return
    yield "| what | name | change |\n|---|---|---|\n"
    for row in rows:
        yield f"| {row.kind} | `{row.name}` | {row.change} |\n"
