"""All files of a robot's C++ classes, in the folders that programs look for them in."""

from pathlib import Path

from kindsl.products.codegen.library import Library
from kindsl.products.codegen.robcogen import rcg_names
from kindsl.products.codegen.robcogen.build import build
from kindsl.products.codegen.robcogen.data_maps import data_maps
from kindsl.products.codegen.robcogen.declarations import declarations
from kindsl.products.codegen.robcogen.forward_dynamics import forward_dynamics_headers
from kindsl.products.codegen.robcogen.inertia_properties import inertia_properties
from kindsl.products.codegen.robcogen.inverse_dynamics import inverse_dynamics_headers
from kindsl.products.codegen.robcogen.jacobians import jacobians
from kindsl.products.codegen.robcogen.jsim import jsim
from kindsl.products.codegen.robcogen.miscellaneous import miscellaneous
from kindsl.products.codegen.robcogen.parameters import parameter_headers
from kindsl.products.codegen.robcogen.robot import GeneratedRobot
from kindsl.products.codegen.robcogen.traits import traits
from kindsl.products.codegen.robcogen.transforms import transforms

HEADERS = (
    declarations, data_maps, parameter_headers, transforms, jacobians, inertia_properties,
    inverse_dynamics_headers, forward_dynamics_headers, jsim, traits, miscellaneous,
)  # fmt: skip

RUNTIME = Path(__file__).parent / "runtime"


def robot_files(library: Library) -> dict[str, str]:
    """Return the text of each file by its path."""
    robot = GeneratedRobot(library)
    files = {name: text for make in HEADERS for name, text in make(robot).items()}
    layout = library.options.layout
    if layout == rcg_names.LAYOUT:
        files |= rcg_names.rcg_names(robot)
    if layout == "robcogen":
        files = {f"iit/robots/{robot.space.lower()}/{n}": text for n, text in files.items()}
    has_runtime = library.options.has_runtime or layout == rcg_names.LAYOUT
    if has_runtime:
        files |= runtime_files()
    return {**files, **build(robot, files, has_runtime)}


def runtime_files() -> dict[str, str]:
    """Return the headers that all robots share, by their paths."""
    return {
        path.relative_to(RUNTIME).as_posix(): path.read_text(encoding="utf-8")
        for path in sorted(RUNTIME.rglob("*.h"))
    }
