"""Prints the inertia of a link from a CAD report, a shape or a mesh.

REPORT is the text that SolidWorks, Onshape, Fusion 360, Inventor, Creo or FreeCAD shows for the
mass properties of one body. Its digits are kept. What was noticed is reported on stderr. Sizes of
shapes are in metres, densities in kg/m³; a shape is centred at the origin, its axis along z.

examples:
  kindsl inertia report.txt
  kindsl inertia --box 0.04,0.04,0.3 --density 2700
  kindsl inertia --stl part.stl --scale 0.001 --mass 1.2
  kindsl inertia report.txt --document arm.kindsl --link forearm
"""

import argparse
import sys
from decimal import Decimal, InvalidOperation
from functools import partial
from typing import TYPE_CHECKING

from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.documents.choices import Choices
from kindsl.frontends.cli.documents.document_reading import (
    CommandError,
    read_document,
    read_whole,
    refusals,
    shown_name,
)
from kindsl.frontends.cli.documents.sources import STDIN
from kindsl.frontends.cli.outcome import Failure
from kindsl.language.text.nearest import hint, nearest_name
from kindsl.language.text.phrases import alternatives
from kindsl.language.text.printable import printable
from kindsl.language.text.regular import content_of

if TYPE_CHECKING:
    from kindsl.language.semantics.declarations import Link
    from kindsl.robots.cad.properties import MassProperties

SUMMARY = "write the inertia of a CAD report, a shape or a mesh"
_SIZES = {
    "box": "X,Y,Z",
    "cylinder": "R,L",
    "hollow-cylinder": "R,INNER,L",
    "sphere": "R",
    "capsule": "R,L",
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = parser.add_argument
    add("report", metavar="REPORT", nargs="?", help="a file with the report, or '-' for stdin")
    shapes = parser.add_argument_group("shapes")
    add_shape = partial(shapes.add_argument, dest="shapes", action="append", default=[])
    for name, sizes in _SIZES.items():
        sides = "its sides" if name == "box" else "R: its radius"
        sides += ", L: its length" if "L" in sizes else ""
        sides += " without the caps" if name == "capsule" else ""
        read = partial(_shape, name, sizes)
        add_shape(f"--{name}", metavar=sizes, type=read, help=sides)
    shapes.add_argument("--stl", metavar="FILE", help="a closed mesh, in its own frame")
    shapes.add_argument(
        "--scale",
        metavar="S",
        type=_number,
        default=Decimal(1),
        help="the mesh's unit in metres: 0.001 for millimetres",
    )
    shapes.add_argument("--mass", metavar="KG", type=_number, help="of a shape or mesh")
    shapes.add_argument("--density", metavar="KG/M3", type=_number, help="instead of --mass")
    link = parser.add_argument_group("for a link of a document")
    link.add_argument("--document", metavar="FILE", help="write the block as this document has it")
    link.add_argument("--link", metavar="NAME", help="the link; a frame of it may be the report's")


def run(args: argparse.Namespace) -> int:
    """Print the block.

    Returns:
        0; 1 if the report contradicts itself or lacks something, or no body has these sizes;
        2 if a file cannot be read or is no report.
    """
    _check(args)
    link = _link(args)
    found = _found(args)
    names = [str(frame.name) for frame in link.frames] if link is not None else []
    frame = found.system if found.system in names else ""
    inertia = None if link is None else link.inertia
    keyword = "inertia_params" if inertia is None else next(inertia.node.tokens()).text
    for note in found.notes:
        if not frame or "coordinate system" not in note:
            write(sys.stderr, f"{_name(args)}: note: {printable(note)}\n")
    write(sys.stdout, found.block(keyword, frame=frame) + "\n")
    return 0


def _check(args: argparse.Namespace) -> None:
    """Raise CommandError unless there is one body, with what it needs."""
    is_report = args.report is not None
    if is_report + (args.stl is not None) + len(args.shapes) != 1:
        options = alternatives(("REPORT", *(f"--{name}" for name in _SIZES), "--stl"))
        raise CommandError.about("kindsl inertia", f"give one of {options}")
    n_given = (args.mass is not None) + (args.density is not None)
    if is_report and n_given:
        message = "--mass and --density belong to a shape or a mesh, not to a report"
        raise CommandError.about(_name(args), message)
    if not is_report and n_given != 1:
        raise CommandError.about(_name(args), "give either --mass or --density")
    if (args.document is None) != (args.link is None):
        raise CommandError.about("kindsl inertia", "--document and --link must be used together")


def _name(args: argparse.Namespace) -> str:
    if args.report is not None:
        return shown_name(args.report)
    if args.stl is not None:
        return str(args.stl)
    return f"--{args.shapes[0][0]}"


def _found(args: argparse.Namespace) -> "MassProperties":
    if args.report is not None:
        return _of_report(args.report)
    from kindsl.robots.cad.shape import ShapeError

    with refusals(_name(args), ShapeError, status=1):
        return _of_mesh(args) if args.stl is not None else _of_shape(args)


def _of_report(path: str) -> "MassProperties":
    text = read_whole(path)
    from kindsl.robots.cad.report import NoReportError, ReportError
    from kindsl.robots.cad.taking_over import mass_properties

    try:
        return mass_properties(text)
    except ReportError as error:
        status = 2 if isinstance(error, NoReportError) else 1
        failures = [Failure(shown_name(path), reason) for reason in error.reasons]
        raise CommandError(failures, status) from None


def _of_mesh(args: argparse.Namespace) -> "MassProperties":
    from kindsl.robots.cad.mesh import mesh_properties

    with refusals(args.stl, OSError):
        content = content_of(args.stl)
    return mesh_properties(content, args.mass, args.density, args.scale)


def _of_shape(args: argparse.Namespace) -> "MassProperties":
    from kindsl.robots.cad.shape import kind_called, shape_properties

    ((name, sizes),) = args.shapes
    kind = kind_called(name)
    assert kind is not None, "each option is the name of a shape"
    return shape_properties(kind, sizes, args.mass, args.density)


def _link(args: argparse.Namespace) -> "Link | None":
    if args.document is None:
        return None
    if args.document == STDIN and args.report == STDIN:
        message = "the report and the document cannot both be read from stdin"
        raise CommandError.about("kindsl inertia", message)
    bodies = read_document(args.document, Choices()).model.bodies
    found = next((body for body in bodies if body.name == args.link), None)
    if found is None:
        meant = hint(nearest_name(args.link, [str(body.name) for body in bodies]), after=",")
        message = f"there is no link '{args.link}'{meant}"
        raise CommandError.about(args.document, message)
    return found


def _number(text: str) -> Decimal:
    try:
        number = Decimal(text)
    except InvalidOperation:
        number = Decimal("NaN")
    if not number.is_finite():
        raise argparse.ArgumentTypeError(f"'{text}' is not a number")
    return number


def _shape(name: str, wanted: str, text: str) -> tuple[str, list[Decimal]]:
    sizes = [_number(part) for part in text.split(",")]
    if len(sizes) != len(wanted.split(",")):
        raise argparse.ArgumentTypeError(f"'{text}' is not {wanted}")
    return name, sizes
