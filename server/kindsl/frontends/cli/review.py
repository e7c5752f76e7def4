"""Writes a review of a change: pictures, tables, numbers, findings.

The folder gets review.md, review.html (one file that needs nothing else), comment.md (without
pictures) and the pictures before and after. Broken documents are shown as far as they go.

Where OLD or NEW is of another format (.urdf, .xacro, .xml, .mjcf, .sdf) or a folder of generated
code, the mechanics are compared, as kindsl diff does, and both robots are drawn in one frame.

examples:
  kindsl review old.kindsl new.kindsl -o review
  kindsl review --git main..HEAD arm.kindsl -o review
"""

import argparse
import os
import sys
from typing import TYPE_CHECKING

from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.documents.choices import Choices, choices_of
from kindsl.frontends.cli.documents.compared_robots import (
    analysed_versions,
    is_foreign,
    read_robots,
    read_versions,
)
from kindsl.frontends.cli.documents.document_reading import CommandError, shown_name
from kindsl.frontends.cli.documents.git_texts import commits_of, short, versions_of
from kindsl.frontends.cli.documents.writing import unwritable
from kindsl.frontends.cli.options import add_parameter_arguments
from kindsl.language.text.printable import printable
from kindsl.language.text.writing import write_folder

if TYPE_CHECKING:
    from kindsl.judgement.analysis.analysis import Analysis
    from kindsl.products.reports.page.blocks import Page

SUMMARY = "write a report on a change for its reviewer"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = parser.add_argument
    add("files", metavar="FILE", nargs="+", help="OLD and NEW, or one document with --git")
    add("-o", "--output", metavar="FOLDER", required=True, help="where to write; a new folder")
    add("--git", metavar="BASE..HEAD", help="compare the document at two commits")
    add("--force", action="store_true", help="replace the review in a folder that exists")
    add_parameter_arguments(parser.add_argument_group("parameters and configuration"))


def run(args: argparse.Namespace) -> int:
    """Write the review.

    Returns:
        0, or 2 if a document cannot be read or the folder cannot be written.
    """
    _check_folder(args)
    files = _files(args)
    try:
        write_folder(args.output, files)
    except OSError as error:
        raise CommandError.about(args.output, unwritable(args.output, error)) from None
    return 0


def _check_folder(args: argparse.Namespace) -> None:
    if os.path.lexists(args.output) and not (args.force and os.path.isdir(args.output)):
        hint = "; --force replaces the review in it" if os.path.isdir(args.output) else ""
        raise CommandError.about(args.output, f"already exists{hint}")


def _documents(
    args: argparse.Namespace, choices: Choices
) -> "tuple[Analysis | None, Analysis | None, tuple[str, str]]":
    if args.git is None:
        if len(args.files) != 2:
            raise CommandError.about("review", "needs OLD and NEW, or --git BASE..HEAD FILE")
        old, new = read_versions(args.files, choices)
        return old, new, (shown_name(args.files[0]), shown_name(args.files[1]))
    if len(args.files) != 1:
        raise CommandError.about("review", "needs one FILE with --git")
    path, commits = args.files[0], commits_of(args.git)
    versions = versions_of(path, commits)
    old, new = analysed_versions(path, (versions.old, versions.new), choices)
    base, head = map(short, commits)
    before = versions.old_name
    return old, new, (f"{base}:{before}" if before is not None else base, head)


def _files(args: argparse.Namespace) -> dict[str, str]:
    choices = choices_of(args)
    if args.git is None and len(args.files) == 2 and any(map(is_foreign, args.files)):
        page = _mechanics(args.files, choices)
    else:
        documents = _documents(args, choices)
        from kindsl.products.reports.review.page import review_page

        page = review_page(*documents)
    from kindsl.products.reports.review.files import review_files

    return review_files(page)


def _mechanics(files: list[str], choices: Choices) -> "Page":
    """Return a review of two robots of any formats."""
    from kindsl.products.reports.mechanics import report_of

    read = read_robots(files, choices)
    report = report_of(read.old, read.new)
    broken = dict.fromkeys(
        f"{failed.path} has errors: showing the rest" for failed in read.failures
    )
    write(sys.stderr, "".join(f"note: {printable(note)}\n" for note in read.notes))
    from kindsl.products.reports.review.mechanics_page import mechanics_page

    return mechanics_page(report, tuple(broken))
