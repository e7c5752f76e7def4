"""Write the `inertia_params` block of a link from a CAD report, or from a shape.

A report is the text that SolidWorks, Onshape, Fusion 360, Inventor, Creo or FreeCAD shows for the
mass properties of one body; its units and signs are read, its numbers checked against each other.
Shapes are centred at the origin, a cylinder's and a capsule's axis along z.
"""

from decimal import Decimal

from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.tool import Arguments, Content, Field, text
from kindsl.robots.cad.properties import MassProperties
from kindsl.robots.cad.report import ReportError
from kindsl.robots.cad.shape import KINDS, ShapeError, kind_called, shape_properties
from kindsl.robots.cad.taking_over import mass_properties

_SHAPES = ", ".join(f"{kind.name} ({', '.join(kind.sizes)})" for kind in KINDS)


class InertiaArguments(Arguments):
    """A report, or a shape with its mass or density."""

    path: str | None = Field(None, description="A file with a report, from the server's folder")
    text: str | None = Field(None, description="The report's text, instead of a path")
    shape: str | None = Field(None, description=f"One of {_SHAPES}")
    sizes: list[float] = Field([], description="The shape's sizes in that order, metres")
    mass: float | None = Field(None, description="Of a shape, kg")
    density: float | None = Field(None, description="Of a shape, instead of its mass, kg/m³")


def run(arguments: InertiaArguments, folder: Folder) -> list[Content]:
    """Return the block, and what was noticed."""
    sources = (arguments.path, arguments.text, arguments.shape)
    if sum(source is not None for source in sources) != 1:
        raise ToolError("give one of 'path', 'text' and 'shape'")
    try:
        found = _found(arguments, folder)
    except (ReportError, ShapeError) as error:
        raise ToolError(str(error)) from None
    return [text(found.block("inertia_params")), *map(text, found.notes)]


def _found(arguments: InertiaArguments, folder: Folder) -> MassProperties:
    if arguments.shape is None:
        report = arguments.text
        return mass_properties(folder.read(arguments.path or "") if report is None else report)
    kind = kind_called(arguments.shape)
    if kind is None:
        raise ToolError(f"there is no shape '{arguments.shape}': {_SHAPES}")
    if len(arguments.sizes) != len(kind.sizes):
        raise ToolError(f"the sizes of a {kind.name} are {', '.join(kind.sizes)}")
    if (arguments.mass is None) == (arguments.density is None):
        raise ToolError("give either 'mass' or 'density'")
    sizes = [_decimal(size) for size in arguments.sizes]
    amounts = (arguments.mass, arguments.density)
    mass, density = (None if amount is None else _decimal(amount) for amount in amounts)
    return shape_properties(kind, sizes, mass, density)


def _decimal(value: float) -> Decimal:
    if value - value != 0.0:
        raise ToolError("sizes, masses and densities are finite")
    return Decimal(repr(value))
