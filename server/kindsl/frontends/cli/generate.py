"""Generates code for kinematics and dynamics: a library in C or C++, or one file in Python.

Unbound parameters stay inputs of the code. All files go to one folder at once; what was not
generated there is never overwritten without --force.

examples:
  kindsl generate arm.kindsl --language c -o arm_c
  kindsl generate arm.kindsl --language python --derivatives --parameters payload -o arm_py
  kindsl generate arm.kindsl --check arm_c
"""

import argparse
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.documents.choices import choices_of
from kindsl.frontends.cli.documents.document_reading import (
    CommandError,
    model_errors,
    note_errors,
    note_readings,
    read_named,
    read_whole,
    refusals,
    require_syntax,
    shown_name,
)
from kindsl.frontends.cli.documents.sources import STDIN
from kindsl.frontends.cli.documents.writing import unwritable, write_output
from kindsl.frontends.cli.options import add_parameter_arguments
from kindsl.language.text.phrases import counted, listed
from kindsl.language.text.printable import printable
from kindsl.products.codegen.language import language_named, language_names
from kindsl.products.codegen.layouts import LAYOUTS

if TYPE_CHECKING:
    from kindsl.language.semantics.model import Model
    from kindsl.products.codegen.generating import Source
    from kindsl.products.codegen.library import Library, Options

SUMMARY = "write code for kinematics and dynamics"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = parser.add_argument
    parser.set_defaults(default_of=parser.get_default)
    add("file", metavar="FILE", help="the document, or '-' for stdin")
    add("--language", choices=language_names(), help="what to write")
    add("-o", "--output", metavar="DIR", help="the folder to write to")
    add("--name", metavar="PREFIX", help="what all names begin with (default: the robot's name)")
    add("--quantities", metavar="LIST", help="separated by commas (default: all but the next two)")
    add("--derivatives", action="store_true", help="derivatives and the regressor too")
    add(
        "--control", action="store_true",
        help="momentum, motions of frames, M^-1, Coriolis matrix and contacts too",
    )  # fmt: skip
    add(
        "--parameters", metavar="unbound|all|NAMES",
        help="parameters that remain inputs of the code besides the unbound ones",
    )  # fmt: skip
    add("--real", choices=("double", "float"), default="double", help="the type of numbers in C")
    add("--single-header", action="store_true", help="C in one file")
    add(
        "--transforms",
        metavar="FILE.dtdsl",
        help="a transforms document: additional transforms and Jacobians",
    )
    add(
        "--write-transforms",
        metavar="FILE",
        help="write the transforms document used without --transforms, to edit it",
    )
    add(
        "--frames", metavar="LIST",
        help="links and frames to limit poses and Jacobians to; '' for none",
    )  # fmt: skip
    add(
        "--layout",
        choices=LAYOUTS,
        default=LAYOUTS[0],
        help="whose folders and names RobCoGen's classes have",
    )
    add(
        "--runtime",
        action="store_true",
        help="with RobCoGen's classes, headers of their own 'iit/rbd'",
    )
    add(
        "--namespace",
        metavar="A::B",
        help="the namespace of RobCoGen's classes (default: iit::NAME)",
    )
    add(
        "--sources",
        action="store_true",
        help="with each of RobCoGen's headers, the .cpp file that build files name",
    )
    add("--force", action="store_true", help="overwrite files that were not generated")
    add("--check", metavar="DIR", help="check whether the code in DIR still matches FILE")
    add("-q", "--quiet", action="store_true", help="no remarks")
    add_parameter_arguments(parser.add_argument_group("parameters and configuration"))


def run(args: argparse.Namespace) -> int:
    """Generate or check.

    Returns:
        0; 1 if the document gives no mechanism, or code does not fit it; 2 for wrong usage or what
        cannot be read or written.
    """
    is_document_alone = args.write_transforms is not None and args.language is None
    if args.check is None and not is_document_alone and not (args.language and args.output):
        raise CommandError.about("kindsl generate", "--language and -o DIR are needed")
    _refuse_unheeded(args)
    source = _source(args)
    if args.write_transforms is not None:
        _write_transforms(args, source)
    if args.check is not None:
        return _check(args, source)
    return 0 if is_document_alone else _generate(args, source)


def _refuse_unheeded(args: argparse.Namespace) -> None:
    heeded = {name: language_named(name).options for name in language_names()}
    of_some = frozenset().union(*heeded.values())
    why = "has no effect without --language"
    unheeded = {"--output", "--parameters", *of_some}
    if args.check is not None:
        why = f"cannot be used with --check, which takes it from '{args.check}'"
        unheeded |= {"--language", "--frames", "--force"}
    elif args.language is not None:
        why = ""
        unheeded = {*(of_some - heeded[args.language])}
    for option in sorted(unheeded):
        if _is_given(args, option):
            others = listed([name for name, options in heeded.items() if option in options])
            why = why or f"has no effect with --language {args.language}, only with {others}"
            raise CommandError.about("kindsl generate", f"{option} {why}")
    if args.write_transforms is not None and _is_given(args, "--frames"):
        message = "--frames cannot be used with --write-transforms"
        raise CommandError.about("kindsl generate", message)


def _is_given(args: argparse.Namespace, option: str) -> bool:
    name = option.removeprefix("--").replace("-", "_")
    return bool(getattr(args, name) != args.default_of(name))


def _source(args: argparse.Namespace) -> "Source":
    from kindsl.products.codegen.generating import Source

    analysis = read_named(args)
    require_syntax(args.file, analysis)
    note_readings(args.file, analysis)
    note_errors(args.file, analysis)
    name = Path(shown_name(args.file)).name
    known = {str(parameter.name) for parameter in analysis.model.parameters}
    bound = choices_of(args).decisions.bindings.items()
    given = {parameter: binding.value for parameter, binding in bound if parameter in known}
    transforms = _transforms(args)
    if transforms is not None:
        _judge_transforms(*transforms, analysis.model)
    text = transforms[1] if transforms is not None else None
    return Source(name, analysis, given, text, tuple(_places(args)))


def _places(args: argparse.Namespace) -> Iterator[str]:
    """Yield the document and the options that name files and folders, as typed in its folder."""
    document = Path(args.file)
    yield document.name
    folder = document.parent
    given = {"--transforms": args.transforms, "--config": args.config}
    for option, path in given.items():
        if path is not None:
            yield from (option, _seen_from(folder, path))
    if args.isolated:
        yield "--isolated"


def _seen_from(folder: Path, path: str) -> str:
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:  # on another drive
        return Path(path).name


def _transforms(args: argparse.Namespace) -> tuple[str, str] | None:
    """Return path and text of the transforms document that is named, or beside the model.

    Code that is checked names the one it was generated with.
    """
    path = args.transforms
    if path is None:
        then = None if args.check is None else _transforms_file(Path(args.check))
        document = Path(args.file)
        found = document.with_suffix(".dtdsl") if then is None else document.parent / then
        path = str(found) if args.file != STDIN and found.is_file() else None
    return None if path is None else (path, read_whole(path))


def _transforms_file(folder: Path) -> str | None:
    from kindsl.products.codegen.library import GenerationError
    from kindsl.products.codegen.manifest import read_manifest

    try:
        manifest = read_manifest(folder)
    except (GenerationError, OSError):
        return None  # The check itself says why.
    return None if manifest is None else manifest.transforms_file


def _judge_transforms(path: str, text: str, model: "Model") -> None:
    """Warn of frames that the robot lacks where no pair needs them; refuse what else is wrong."""
    from kindsl.language.semantics.transforms import unknown_frames, unknown_listed_frames
    from kindsl.language.syntax.transforms_text import Defect, read_transforms
    from kindsl.language.text.lines import LineIndex

    lines, document = LineIndex(text), read_transforms(text)

    def place(wrong: Defect) -> str:
        line, column = lines.place(wrong.start)
        return f"{shown_name(path)}:{line}:{column}"

    for wrong in (*document.defects, *unknown_frames(document, model)):
        raise CommandError.about(place(wrong), wrong.message, status=1)
    for wrong in unknown_listed_frames(document, model):
        write(sys.stderr, f"{place(wrong)}: warning[KD801] {printable(wrong.message)}\n")


def _generate(args: argparse.Namespace, source: "Source") -> int:
    from kindsl.products.codegen.generating import generate
    from kindsl.products.codegen.library import GenerationError
    from kindsl.products.codegen.manifest import refuse_foreign, write_files

    errors = refusals(args.file, GenerationError, status=1)
    with errors, model_errors(args.file, source.analysis):
        library, files = generate(source, _options(args, source))
    folder = Path(args.output)
    try:
        with refusals(args.file, GenerationError):
            if not args.force:
                refuse_foreign(folder, files)
            write_files(folder, files)
    except OSError as error:
        raise CommandError.about(args.output, unwritable(args.output, error)) from None
    if not args.quiet:
        write(sys.stderr, _remarks(library, args, len(files)))
    return 0


def _write_transforms(args: argparse.Namespace, source: "Source") -> int:
    """Write the transforms document of a robot, unless there is a file already."""
    from kindsl.language.semantics.transforms import UnwritableNameError, transforms_document

    path, model = args.write_transforms, source.analysis.model
    if not model.bodies or not model.name:
        message = "a robot without a name or links has no transforms document"
        raise CommandError.about(args.file, message, status=1)
    if os.path.exists(path) and not args.force:
        raise CommandError.about(path, "the file exists; --force overwrites it")
    with refusals(args.file, UnwritableNameError, status=1):
        write_output(path, transforms_document(model))
    return 0


def _check(args: argparse.Namespace, source: "Source") -> int:
    from kindsl.products.codegen.checking import misfit
    from kindsl.products.codegen.library import GenerationError

    unreadable = refusals(args.check, OSError)
    errors = refusals(args.file, GenerationError, status=1)
    with unreadable, errors, model_errors(args.file, source.analysis):
        why = misfit(source, Path(args.check))
    if why is not None:
        raise CommandError.about(args.file, why, status=1)
    if not args.quiet:
        write(sys.stderr, f"{args.check}: fits {shown_name(args.file)}\n")
    return 0


def _options(args: argparse.Namespace, source: "Source") -> "Options":
    from kindsl.products.codegen.library import Options
    from kindsl.products.codegen.names_in_code import UnusableNameError, namespace_of, prefix_of

    with refusals(args.file, UnusableNameError):
        prefix = prefix_of(str(source.analysis.model.name or ""), args.name)
        namespace = "" if args.namespace is None else namespace_of(args.namespace)
    parameters = args.parameters or language_named(args.language).parameters
    return Options(
        args.language, _quantities(args), args.real, args.single_header, parameters, prefix,
        args.layout, args.runtime, None if args.frames is None else _listed(args.frames),
        namespace, args.sources,
    )  # fmt: skip


def _listed(text: str | None) -> tuple[str, ...]:
    return tuple(name.strip() for name in (text or "").split(",") if name.strip())


def _quantities(args: argparse.Namespace) -> tuple[str, ...]:
    from kindsl.language.text.nearest import hint, nearest_word
    from kindsl.mechanics.dynamics.generation.functions import QUANTITIES

    chosen = _listed(args.quantities)
    if args.quantities is not None and not chosen:
        raise CommandError.about(args.file, "--quantities names no quantity")
    for name in chosen:
        if name not in QUANTITIES:
            close = hint(nearest_word(name, QUANTITIES)) or f", not one of {', '.join(QUANTITIES)}"
            message = f"--quantities: unknown quantity '{name}'{close}"
            raise CommandError.about(args.file, message)
    return tuple(
        name
        for name, quantity in QUANTITIES.items()
        if name in chosen or (getattr(args, quantity.group) if quantity.group else not chosen)
    )


def _remarks(library: "Library", args: argparse.Namespace, n_files: int) -> str:
    lines = [f"{counted(n_files, 'file')} written"]
    lines += [
        f"note: '{printable(name)}' is '{safe}' in the code"
        for name, safe in language_named(args.language).renamed(library).items()
    ]
    return "".join(f"{args.output}: {line}\n" for line in lines)
