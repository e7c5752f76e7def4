"""Converts between the Kinematics-DSL and other formats, told apart by their suffixes.

Reports on stderr what the other format cannot express. A .xacro file is expanded first, which
evaluates Python expressions in it: convert only files that you trust.

examples:
  kindsl convert arm.urdf arm.kindsl
  kindsl convert arm.kindsl arm.xml
  kindsl convert --floating-base dog.urdf dog.kindsl
  kindsl convert --package-path ~/ws/src ur5e.urdf.xacro ur5e.kindsl name:=ur5e
"""

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.documents.choices import choices_of
from kindsl.frontends.cli.documents.document_reading import (
    CommandError,
    note_errors,
    note_readings,
    read_document,
    refusals,
    require_parameters,
    shown_name,
    skeleton_of_document,
)
from kindsl.frontends.cli.documents.sources import STDIN
from kindsl.frontends.cli.documents.writing import write_output
from kindsl.frontends.cli.options import add_parameter_arguments
from kindsl.frontends.cli.output.notes import rendered_notes
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.language.text.phrases import counted
from kindsl.language.text.regular import require_regular
from kindsl.robots.interchange.format import (
    Format,
    FormatError,
    ReadingChoices,
    WritingChoices,
    WrittenRobot,
    joints_dropped,
    repaired,
    suffix_unknown,
)
from kindsl.robots.interchange.registry import all_formats, format_named, format_of_suffix
from kindsl.robots.mechanism.total_mass import fixed_base_mass

if TYPE_CHECKING:
    from kindsl.robots.interchange.format import Joints

SUMMARY = "convert from and to URDF, MJCF and SDF"
_DOCUMENT = Format("kindsl", "Kinematics-DSL", (".kindsl",))


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = parser.add_argument
    others = tuple(all_formats())
    readable = (_DOCUMENT, *(format for format in others if format.read))
    *suffixes, last = (suffix for format in readable for suffix in format.suffixes)
    add("input", metavar="IN", help=f"a {', '.join(suffixes)} or {last} file")
    add("output", metavar="OUT", help="the file to write, of another suffix, or '-' for stdout")
    read = tuple(format.name for format in readable)
    written = (_DOCUMENT.name, *(format.name for format in others if format.write))
    untold = "the format of {}, if not determined by its suffix"
    add(
        "arguments",
        metavar="NAME:=VALUE",
        nargs="*",
        type=_argument,
        help="arguments of a xacro file",
    )
    add(
        "--package-path",
        metavar="DIR",
        type=Path,
        action="append",
        default=[],
        help="a folder of packages, for $(find PACKAGE) in a xacro file (repeatable)",
    )
    add(
        "--model-path",
        metavar="DIR",
        type=Path,
        action="append",
        default=[],
        help="a folder of models that an SDF includes (repeatable)",
    )
    add("--from", dest="source", choices=read, help=untold.format("IN"))
    add("--to", dest="target", choices=written, help=untold.format("OUT"))
    add(
        "--floating-base",
        action="store_true",
        help="make the root link a floating base, whatever IN says",
    )
    add(
        "--continuous",
        action="store_true",
        help="write revolute joints without limits as continuous",
    )
    add(
        "--repair-inertia",
        action="store_true",
        help="write the nearest possible inertia where one is impossible",
    )
    add("--no-config", action="store_true", help="write no kindsl.toml with limits of joints")
    add("-v", "--verbose", action="store_true", help="report each thing that was dropped")
    add("-q", "--quiet", action="store_true", help="do not report what was dropped")
    add_parameter_arguments(parser.add_argument_group("parameters and configuration"))


def run(args: argparse.Namespace) -> int:
    """Convert one file.

    Returns:
        0; 1 if the input does not describe a mechanism; 2 if a file cannot be read or written.
    """
    text, remarks, joints, _ = _converted(args)
    beside, told = _told_of_joints(args, joints)
    write_output(args.output, text, beside)
    if not args.quiet:
        notes = (*remarks, *told)
        shown = rendered_notes(shown_name(args.input), notes, is_verbose=args.verbose)
        write(sys.stderr, shown)
    return 0


def _converted(args: argparse.Namespace) -> WrittenRobot:
    source, target = _formats(args)
    if target is _DOCUMENT:
        return _document(args, source)
    if source is _DOCUMENT:
        analysis = read_document(args.input, choices_of(args))
        require_parameters(args.input, analysis)
        converted = _in_format(args, target, analysis)
        note_readings(args.input, analysis)
        note_errors(args.input, analysis)
        return converted
    read = _document(args, source)
    from kindsl.judgement.analysis.settings import Settings

    written = _in_format(args, target, analyse(read.text, Settings(joints=read.joints)))
    return written._replace(remarks=(*read.remarks, *written.remarks))


def _told_of_joints(
    args: argparse.Namespace, joints: "Joints"
) -> tuple[dict[str, str], tuple[str, ...]]:
    """Return the configuration that tells of a document's joints, by its path, and a note."""
    if not joints:
        return {}, ()
    if args.output == STDIN or args.no_config or args.isolated:
        return {}, (joints_dropped(joints),)
    from kindsl.judgement.config.configuration_reading import text_of
    from kindsl.judgement.config.discovery import nearest_configuration
    from kindsl.judgement.config.document_tables import with_joints
    from kindsl.judgement.config.file_names import OWN_FILE

    folder = os.path.dirname(os.path.abspath(args.output))
    file = args.config or nearest_configuration(folder)
    old = text_of(file) if file else ""
    file = file or os.path.join(os.path.dirname(args.output), OWN_FILE)
    new = with_joints(file, old, args.output, joints)
    if new is None:
        return {}, (joints_dropped(joints),)
    number = counted(len(joints), "joint")
    told = "tells" if new == old else "now tells"
    note = f"{file} {told} limits, friction and armature of {number}: --no-config leaves it alone"
    return ({} if new == old else {file: new}), (note,)


def _formats(args: argparse.Namespace) -> tuple[Format, Format]:
    """Return the formats of input and output; stdout takes what the input is not."""
    source = _format(args.input, args.source, "--from")
    if args.output == STDIN and args.target is None:
        target = _known(format_named("urdf")) if source is _DOCUMENT else _DOCUMENT
    else:
        target = _format(args.output, args.target, "--to")
    if source is target:
        message = f"input and output are both {source.title}"
        raise CommandError.about(f"{args.input} {args.output}", message)
    for format, path, does, verb in (
        (source, args.input, source is _DOCUMENT or source.read, "read"),
        (target, args.output, target is _DOCUMENT or target.write, "written"),
    ):
        if not does:
            raise CommandError.about(path, f"{format.title} cannot be {verb}")
    return source, target


def _format(path: str, named: str | None, option: str) -> Format:
    if named is not None:
        return _DOCUMENT if named == _DOCUMENT.name else _known(format_named(named))
    suffix = Path(path).suffix
    if suffix.lower() in _DOCUMENT.suffixes:
        return _DOCUMENT
    format = format_of_suffix(suffix)
    if format is None:
        every = (suffix for f in (_DOCUMENT, *all_formats()) for suffix in f.suffixes)
        message = suffix_unknown(suffix, every, f", or {option} FORMAT")
        raise CommandError.about(path, message)
    return format


def _known(format: Format | None) -> Format:
    assert format is not None, "the option takes names of formats only"
    return format


def _document(args: argparse.Namespace, source: Format) -> WrittenRobot:
    assert source.read is not None
    from kindsl.robots.interchange.kindsl_writing import written_kindsl

    with refusals(args.input, OSError), refusals(args.input, FormatError, status=1):
        require_regular(args.input)
        return written_kindsl(source.read(Path(args.input), _choices(args, source)))


def _choices(args: argparse.Namespace, source: Format) -> ReadingChoices:
    for given, what, wanted in (
        (args.arguments, "arguments are", "xacro"),
        (args.package_path, "--package-path is", "xacro"),
        (args.model_path, "--model-path is", "sdf"),
    ):
        if given and source.name != wanted:
            raise CommandError.about(args.input, f"{what} for {wanted} files")
    packages, models = tuple(args.package_path), tuple(args.model_path)
    return ReadingChoices(args.floating_base, packages, dict(args.arguments), models)


def _argument(text: str) -> tuple[str, str]:
    name, sign, value = text.partition(":=")
    if not sign or not name:
        raise argparse.ArgumentTypeError(f"'{text}' is not NAME:=VALUE")
    return name, value


def _in_format(args: argparse.Namespace, target: Format, analysis: Analysis) -> WrittenRobot:
    assert target.write is not None
    skeleton = skeleton_of_document(args.input, analysis)
    mass = fixed_base_mass(analysis.model, analysis.context.values)
    choices = WritingChoices(args.continuous, analysis.settings.joints, mass)
    skeleton, notes = repaired(skeleton) if args.repair_inertia else (skeleton, ())
    with refusals(args.input, FormatError, status=1):
        written = target.write(analysis.model.name or "robot", skeleton, choices)
    return written._replace(remarks=(*written.remarks, *notes))
