"""Converts between URDF and the Kinematics-DSL, told apart by their suffixes.

Reports on stderr what the other format cannot express. A .xacro file is expanded first.
"""

import argparse
import sys
from pathlib import Path

from kindsl.cli.console import write
from kindsl.cli.documents.choices import choices_of
from kindsl.cli.documents.reading import (
    CommandError,
    bodies_of_document,
    missing_module,
    read_document,
)
from kindsl.cli.documents.sources import STDIN, reason
from kindsl.cli.options import add_parameter_arguments
from kindsl.cli.outcome import Failure, as_failures
from kindsl.config.configuration import ConfigurationError
from kindsl.text.printable import printable

_DOCUMENT = ".kindsl"
_URDF = ".urdf"
_READ = (_URDF, ".xacro")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = parser.add_argument
    add("input", metavar="IN", help="a .urdf, .xacro or .kindsl file")
    add("output", metavar="OUT", help="the file to write, of the other suffix, or '-' for stdout")
    add("--floating-base", action="store_true", help="the URDF's root link floats")
    add("-q", "--quiet", action="store_true", help="do not report what was dropped")
    add_parameter_arguments(parser.add_argument_group("parameters and configuration"))


def run(args: argparse.Namespace) -> int:
    """Convert one file.

    Returns:
        0; 1 if the input does not describe a mechanism; 2 if a file cannot be read or written.
    """
    try:
        text, remarks = _converted(args)
        _write(args.output, text)
    except CommandError as error:
        return error.tell()
    except ConfigurationError as error:
        return CommandError(as_failures(error)).tell()
    if not args.quiet:
        write(sys.stderr, "".join(f"{args.input}: note: {printable(r)}\n" for r in remarks))
    return 0


def _converted(args: argparse.Namespace) -> tuple[str, tuple[str, ...]]:
    suffixes = Path(args.input).suffix.lower(), Path(args.output).suffix.lower()
    if suffixes[0] in _READ and suffixes[1] in (_DOCUMENT, ""):
        return _from_urdf(args)
    if suffixes[0] == _DOCUMENT and (suffixes[1] == _URDF or args.output == STDIN):
        return _to_urdf(args)
    message = "converts .urdf or .xacro to .kindsl, or .kindsl to .urdf"
    raise CommandError([Failure(f"{args.input} {args.output}", message)])


def _from_urdf(args: argparse.Namespace) -> tuple[str, tuple[str, ...]]:
    try:
        from kindsl.interchange.kindsl_writing import kindsl_text, renamed
        from kindsl.interchange.urdf.reading import UrdfError, read_urdf

        read = read_urdf(Path(args.input), floating=args.floating_base)
    except ModuleNotFoundError as error:
        raise missing_module(args.input, error, "convert") from None
    except OSError as error:
        raise CommandError([Failure(args.input, reason(args.input, error))]) from None
    except UrdfError as error:
        raise CommandError([Failure(args.input, str(error))], status=1) from None
    return kindsl_text(read.robot), (*read.remarks, *renamed(read.robot))


def _to_urdf(args: argparse.Namespace) -> tuple[str, tuple[str, ...]]:
    analysis = read_document(args.input, choices_of(args))
    bodies = bodies_of_document(args.input, analysis)
    try:
        from kindsl.interchange.urdf.writing import urdf_remarks, urdf_text

        return urdf_text(analysis.model.name or "robot", bodies), tuple(urdf_remarks(bodies))
    except ModuleNotFoundError as error:
        raise missing_module(args.input, error, "convert") from None


def _write(path: str, text: str) -> None:
    if path == STDIN:
        write(sys.stdout, text)
        return
    try:
        Path(path).write_text(text, encoding="utf-8", newline="\n")
    except OSError as error:
        message = f"cannot be written: {error.strerror or error}"
        raise CommandError([Failure(path, message)]) from None
