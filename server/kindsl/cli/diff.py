"""Tells what changed mechanically between two documents, for reviews."""

import argparse
import sys
from collections.abc import Iterator
from dataclasses import asdict
from typing import TYPE_CHECKING

from kindsl.cli.console import write
from kindsl.cli.documents.choices import choices_of
from kindsl.cli.documents.reading import CommandError, bodies_of_document, read_document, shown_name
from kindsl.cli.options import add_parameter_arguments
from kindsl.cli.outcome import as_failures
from kindsl.config.configuration import ConfigurationError

if TYPE_CHECKING:
    from kindsl.mechanism.difference import Difference

SAME = 0
CHANGED = 1


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = parser.add_argument
    add("old", metavar="OLD", help="the document before")
    add("new", metavar="NEW", help="the document after")
    add("--output-format", choices=("text", "json", "markdown"), default="text")
    add("--exit-zero", action="store_true", help="exit with 0 when something changed, too")
    add_parameter_arguments(parser.add_argument_group("parameters and configuration"))


def run(args: argparse.Namespace) -> int:
    """Compare two documents.

    Returns:
        0 if nothing changed, 1 if something did, 2 if a document gives no mechanism.
    """
    try:
        found = _difference(args)
    except CommandError as error:
        error.tell()
        return 2
    except ConfigurationError as error:
        return CommandError(as_failures(error)).tell()
    names = shown_name(args.old), shown_name(args.new)
    write(sys.stdout, _rendered(found, names, args.output_format))
    return SAME if found.is_empty or args.exit_zero else CHANGED


def _difference(args: argparse.Namespace) -> "Difference":
    choices = choices_of(args)
    documents = [(path, read_document(path, choices)) for path in (args.old, args.new)]
    old, new = (bodies_of_document(path, analysis) for path, analysis in documents)
    from kindsl.mechanism.difference import difference

    return difference(old, new)


def _rendered(found: "Difference", names: tuple[str, str], output_format: str) -> str:
    if output_format == "json":
        import json

        facts = {"old": names[0], "new": names[1], "changed": not found.is_empty, **asdict(found)}
        return json.dumps(facts, indent=2) + "\n"
    from kindsl.reports.difference_text import change_rows

    rows = list(change_rows(found))
    if output_format == "markdown":
        return "".join(_markdown(rows, names))
    if not rows:
        return "nothing changed mechanically\n"
    from kindsl.reports.columns import aligned

    return aligned([(row.kind, row.name, row.change) for row in rows])


def _markdown(rows: "list[ChangeRow]", names: tuple[str, str]) -> Iterator[str]:
    yield f"### Mechanical changes from `{names[0]}` to `{names[1]}`\n\n"
    if not rows:
        yield "None.\n"
        return
    yield "| what | name | change |\n|---|---|---|\n"
    for row in rows:
        yield f"| {row.kind} | `{row.name}` | {row.change} |\n"


if TYPE_CHECKING:
    from kindsl.reports.difference_text import ChangeRow
