"""Shows a robot in the browser while its document is edited.

examples:
  kindsl preview arm.kindsl
  kindsl preview arm.kindsl --edit --compare arm.urdf
  kindsl preview arm.kindsl --export arm.html
  kindsl preview --floating-base dog.urdf
"""

import argparse
import os
import sys
from collections.abc import Callable
from functools import partial
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.frontends.cli.documents.choices import choices_of
from kindsl.frontends.cli.documents.document_reading import CommandError, read_document, read_whole
from kindsl.frontends.cli.documents.sources import STDIN, read_source
from kindsl.frontends.cli.documents.writing import write_output, write_text
from kindsl.frontends.cli.options import add_floating_argument, add_parameter_arguments
from kindsl.frontends.cli.outcome import Failure
from kindsl.judgement.config.configuration import ConfigurationError
from kindsl.language.text.edits import apply_edits

if TYPE_CHECKING:
    from kindsl.frontends.preview.comparing import OtherRobot
    from kindsl.frontends.preview.document_preview import DocumentPreview
    from kindsl.frontends.preview.meshes import MeshSource
    from kindsl.frontends.preview.requests import KeepPose, WriteParameters
    from kindsl.frontends.preview.steps import Writing
    from kindsl.judgement.analysis.analysis import Analysis

SUMMARY = "show the robot in 3D while its document is edited"
RUNS_LONG = True


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = parser.add_argument
    add("file", metavar="FILE", help="the document, URDF, SDF or MJCF to show")
    add("--port", metavar="N", type=_port, default=0, help="listen here (default: a free port)")
    add("--no-open", action="store_true", help="do not open a browser")
    add("--compare", metavar="OTHER", help="compare with a document, URDF, MJCF, SDF or folder")
    add("--meshes", metavar="FILE.urdf", type=Path, help="draw the meshes of a URDF on the links")
    add("--mesh-folder", metavar="DIR", type=Path, help="where they are (default: its package)")
    add("--pose", metavar="NAME", help="begin with a pose of kindsl.toml: [poses.NAME]")
    add("--trajectory", metavar="FILE", help="play a motion: CSV or JSON with time and joints")
    add("--export", metavar="FILE.html", help="write a self-contained page and exit")
    add("--screenshot", metavar="FILE.png", type=Path, help="write a picture and exit")
    add(
        "--edit",
        action="store_true",
        help="write what is dragged in the page to FILE, and poses that are kept to kindsl.toml",
    )
    add_floating_argument(parser)
    add_parameter_arguments(parser.add_argument_group("parameters and configuration"))


def run(args: argparse.Namespace) -> int:
    """Serve until interrupted, or write the page or picture.

    Returns:
        0, or 2 when a file cannot be read or written, or something needed is missing.
    """
    from kindsl.frontends.preview.assets import PreviewUnavailableError
    from kindsl.judgement.analysis.settings import PoseError

    try:
        other = _other(args) if args.compare else None
        if args.export or args.screenshot:
            _write(args, other)
        elif args.file == STDIN:
            message = "a document on stdin cannot be followed; name a file, or use --export"
            raise CommandError.about("kindsl preview", message)
        else:
            _serve(args, other)
    except PreviewUnavailableError as error:
        raise CommandError.about("kindsl preview", str(error)) from None
    except PoseError as error:
        raise CommandError.about(args.file, str(error)) from None
    except OSError as error:
        path, what = error.filename or args.file, error.strerror or error
        raise CommandError.about(str(path), str(what)) from None
    except KeyboardInterrupt:
        pass  # which is how it ends
    return 0


def _reread(args: argparse.Namespace, file: str) -> "Analysis | str":
    try:
        return read_document(file, choices_of(args))
    except (CommandError, ConfigurationError) as error:
        return str(error)


def _other(args: argparse.Namespace) -> "OtherRobot":
    from kindsl.frontends.cli.documents.compared_robots import is_foreign
    from kindsl.frontends.preview.comparing import document_robot, file_robot

    name = args.compare
    if is_foreign(name):
        other = file_robot(name, name)
    else:
        read_document(name, choices_of(args))
        other = document_robot(name, partial(_reread, args, name))
    problem = other.read(True)
    if isinstance(problem, str):
        raise CommandError.about(name, problem)
    return other


def _write(args: argparse.Namespace, other: "OtherRobot | None") -> None:
    from kindsl.frontends.preview.document_preview import DocumentPreview
    from kindsl.frontends.preview.export import exported_page
    from kindsl.frontends.preview.meshes import mesh_data
    from kindsl.robots.scene.formulas import formula_messages
    from kindsl.robots.scene.messages import MeshesMessage

    analysis = read_document(args.file, choices_of(args))
    document = DocumentPreview(args.file)
    document.show(analysis, analysis.findings)
    _extras(args, other)(document)
    state = document.channel.state
    lost = (each.problems for each in state if isinstance(each, MeshesMessage))
    for problem in chain.from_iterable(lost):
        print(f"{args.meshes}: {problem}", file=sys.stderr)
    formulas = formula_messages(analysis.model, analysis.context.values)
    page = exported_page([*state, *formulas, *mesh_data(document.mesh_files)])
    if args.export:
        write_output(args.export, page)
    if args.screenshot:
        from kindsl.frontends.preview.screenshot import take_screenshot

        take_screenshot(page, args.screenshot)


def _meshes(args: argparse.Namespace) -> "MeshSource | None":
    if args.meshes is None:
        return None
    from kindsl.frontends.preview.meshes import MeshSource

    missing = [path for path in (args.meshes, args.mesh_folder) if path and not path.exists()]
    if missing:
        raise CommandError.about(str(missing[0]), "no such file or folder")
    return MeshSource(args.meshes.name, args.meshes, args.mesh_folder)


def _motion(args: argparse.Namespace) -> tuple[str, str] | None:
    if args.trajectory is None:
        return None
    return os.path.basename(args.trajectory), read_whole(args.trajectory)


def _extras(
    args: argparse.Namespace, other: "OtherRobot | None"
) -> "Callable[[DocumentPreview], None]":
    """Return what lets a preview show all that the options ask for beside the document."""
    meshes, motion = _meshes(args), _motion(args)

    def add(shown: "DocumentPreview") -> None:
        if other is not None:
            shown.compare(other)
        if meshes is not None:
            shown.draw_meshes(meshes)
        if args.pose is not None:
            shown.take_pose(args.pose)
        if motion is not None:
            shown.play(*motion)

    return add


def _serve(args: argparse.Namespace, other: "OtherRobot | None") -> None:
    import asyncio

    from kindsl.frontends.preview.command import Command, serve
    from kindsl.frontends.preview.watch import fingerprint
    from kindsl.judgement.analysis.twins import watched_files

    configuration = choices_of(args).configuration_for(args.file)
    first = read_document(args.file, choices_of(args))
    if args.edit and first.syntax.is_xml:
        message = "only a .kindsl document is edited in the page: 'kindsl convert' makes one"
        raise CommandError.about(args.file, message)
    others = [str(path) for path in (args.compare, args.meshes) if path]
    others += [configuration.path] if configuration else []
    paths = (args.file, *others, *watched_files(first.settings.twins))
    read = partial(_reread, args, args.file)
    write = partial(_write_dragged, args) if args.edit else None
    shown = args.file, read, first, _extras(args, other)
    served = args.port, not args.no_open, paths, fingerprint(paths)
    asyncio.run(serve(Command(*shown, *served, partial(_keep, args), write)))


def _write_dragged(args: argparse.Namespace, writing: "Writing") -> str:
    """Write a dragged number into the document; return an error message, empty if written."""
    file = args.file
    if os.path.islink(file):
        return f"'{file}' is a link: open its target"
    if writing.bindings:
        try:
            return _bind(args, writing)
        except ConfigurationError as error:
            return str(error)
    failure = write_text(file, file, writing.text, apply_edits(writing.text, writing.edits))
    return failure.message if failure is not None else ""


def _keep(args: argparse.Namespace, wanted: "WriteParameters | KeepPose") -> str:
    """Keep a pose where the page may write; return the lines to be written by hand elsewhere."""
    from kindsl.frontends.preview.requests import KeepPose
    from kindsl.judgement.config.parameter_lines import parameter_table, pose_table

    if not isinstance(wanted, KeepPose):
        return parameter_table(wanted.values)
    if not args.edit:
        return pose_table(*wanted)
    try:
        problem = _keep_pose(args, wanted)
    except (CommandError, ConfigurationError) as error:
        problem = str(error)
    if problem:
        print(problem, file=sys.stderr, flush=True)
    return pose_table(*wanted) if problem else ""


def _keep_pose(args: argparse.Namespace, pose: "KeepPose") -> str:
    """Write a pose into the configuration file, maybe a new one; return why not, or nothing."""
    from kindsl.judgement.config.document_tables import with_pose
    from kindsl.judgement.config.file_names import OWN_FILE

    if args.isolated:
        return "with --isolated there is no configuration file"
    configuration = choices_of(args).configuration_for(args.file)
    beside = os.path.join(os.path.dirname(args.file), OWN_FILE)
    file = configuration.path if configuration else beside
    old = read_source(file, file) if configuration else ""
    new = with_pose(file, old, args.file, *pose) if isinstance(old, str) else None
    if isinstance(old, Failure) or new is None:
        return f"{file}: pose '{pose.name}' cannot be added"
    if configuration is None:
        write_output(file, new)
    elif (failure := write_text(file, file, old, new)) is not None:
        return failure.message
    print(f"{file}: pose '{pose.name}'", flush=True)
    return ""


def _bind(args: argparse.Namespace, writing: "Writing") -> str:
    """Bind parameters anew in the document's configuration file; return why not, or nothing."""
    from kindsl.judgement.config.toml_edits import binding_edit

    names = ", ".join(f"'{name}'" for name, _ in writing.bindings)
    configuration = choices_of(args).configuration_for(args.file)
    text = read_source(configuration.path, configuration.path) if configuration else None
    if configuration is None or not isinstance(text, str):
        return f"{names} is not bound in a configuration file"
    edit = binding_edit(configuration.path, text, args.file, writing.bindings)
    if edit is None:
        return f"{names} cannot be bound in {configuration.path}"
    failure = write_text(configuration.path, configuration.path, text, apply_edits(text, [edit]))
    return failure.message if failure is not None else ""


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > 65535:
        raise argparse.ArgumentTypeError(f"'{text}' is not a port: 0 to 65535")
    return int(text)
