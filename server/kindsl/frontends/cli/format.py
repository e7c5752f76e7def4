"""Formats Kinematics-DSL documents; changes whitespace only.

examples:
  kindsl format arm.kindsl
  kindsl format --check .
"""

import argparse
import sys
from typing import NamedTuple

from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.documents.sources import STDIN, is_decodable, read_source
from kindsl.frontends.cli.documents.walking import documents
from kindsl.frontends.cli.documents.writing import write_text
from kindsl.frontends.cli.options import add_exclusion_argument
from kindsl.frontends.cli.outcome import Failure
from kindsl.judgement.analysis.syntax_findings import all_problems
from kindsl.judgement.config.robots import TOOLS_FOLDERS
from kindsl.language.formatting import FormattingRefusedError, format_document
from kindsl.language.syntax.document import SyntaxDocument, parse
from kindsl.language.text.edits import apply_edits
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.phrases import counted
from kindsl.language.text.printable import printable
from kindsl.language.text.unified_diff import unified_diff

SUMMARY = "format documents; changes whitespace only"
OK = 0
WOULD_CHANGE = 1
UNUSABLE = 2


class Formatted(NamedTuple):
    """A document before and after."""

    path: str
    shown: str
    old: str
    new: str


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument(
        "paths", nargs="*", metavar="PATH", help="documents, folders, or '-' for stdin to stdout"
    )
    parser.add_argument("--check", action="store_true", help="write nothing, exit with 1 if needed")
    parser.add_argument("--diff", action="store_true", help="write nothing, show what would change")
    parser.add_argument("--stdin-filename", metavar="NAME", default="<stdin>")
    add_exclusion_argument(parser)
    parser.add_argument("-q", "--quiet", action="store_true", help="no summary")


def run(args: argparse.Namespace) -> int:
    """Format the documents below the paths.

    Returns:
        0; with `--check` or `--diff` 1 if something would change; 2 if a document cannot be read,
        does not parse, or cannot be written.
    """
    excluded = frozenset[str]() if args.no_default_exclude else TOOLS_FOLDERS
    paths = documents(args.paths or ["."], excluded)
    found = [_formatted(path, args.stdin_filename) for path in paths]
    failures = [one for one in found if isinstance(one, Failure)]
    whole = [one for one in found if isinstance(one, Formatted)]
    changed = [one for one in whole if one.new != one.old]
    if args.diff:
        write(sys.stdout, "".join(unified_diff(one.shown, one.old, one.new) for one in changed))
    elif not args.check:
        unwritten = _write_all(whole)
        failures += unwritten
        names = {failure.path for failure in unwritten}
        whole = [one for one in whole if one.shown not in names]
        changed = [one for one in changed if one.shown not in names]
    write(sys.stderr, "".join(f"{printable(str(failure))}\n" for failure in failures))
    if not args.quiet:
        write(sys.stderr, _summary(whole, changed, args))
    if failures:
        return UNUSABLE
    return WOULD_CHANGE if changed and (args.check or args.diff) else OK


def _formatted(path: str | Failure, stdin_name: str) -> Formatted | Failure:
    if isinstance(path, Failure):
        return path
    shown = stdin_name if path == STDIN else path
    text = read_source(path, shown)
    if isinstance(text, Failure):
        return text
    if not is_decodable(text):
        return Failure(shown, "is not UTF-8, not formatted")
    document = parse(text)
    try:
        return Formatted(path, shown, text, apply_edits(text, format_document(document)))
    except FormattingRefusedError as error:
        return Failure(shown, f"not formatted: {error}", *_first_problem(document))


def _first_problem(document: SyntaxDocument) -> tuple[int, int]:
    starts = {id(i): start for i, start in zip(document.islands, document.starts, strict=True)}
    first = min(
        (starts[id(island)] + problem.start for island, problem in all_problems(document)),
        default=0,
    )
    return LineIndex(document.text).place(first)


def _write_all(whole: list[Formatted]) -> list[Failure]:
    failures = []
    for one in whole:
        if one.path == STDIN:
            write(sys.stdout, one.new)
        elif one.new != one.old:
            failure = write_text(one.path, one.shown, one.old, one.new)
            failures += [failure] if failure is not None else []
    return failures


def _summary(whole: list[Formatted], changed: list[Formatted], args: argparse.Namespace) -> str:
    if not whole:
        return ""
    would = "would be formatted" if args.check or args.diff else "formatted"
    listed = "".join(f"{one.shown}: {would}\n" for one in changed if one.path != STDIN)
    n_same = len(whole) - len(changed)
    return f"{listed}{counted(len(changed), 'document')} {would}, {n_same} as it should be\n"
