"""All files of a robot's C++ classes, in the folders that programs look for them in."""

from collections.abc import Iterator
from pathlib import Path

from kindsl.products.codegen.library import Library
from kindsl.products.codegen.robcogen import dynamics_kernels as dynamics
from kindsl.products.codegen.robcogen.robot import GeneratedRobot
from kindsl.products.codegen.robcogen.transforms import KINDS, jacobians, transforms
from kindsl.products.codegen.robcogen.wanted_names import jacobian_pairs, transform_pairs

RUNTIME = Path(__file__).parent / "runtime"
# The headers whose code RobCoGen writes to a source.
WITH_SOURCES = (
    "transforms", "jacobians", "inertia_properties", "inverse_dynamics", "forward_dynamics", "jsim",
)  # fmt: skip


def robot_files(library: Library) -> dict[str, str]:
    """Return the text of each file by its path."""
    robot = GeneratedRobot(library)
    layout = library.options.layout
    files = dict(_headers(robot))
    if library.options.has_sources:
        files |= {f"{n}.cpp": robot.rendered("source.cpp", header=n) for n in WITH_SOURCES}
    if layout == "robcogen":
        files = {f"iit/robots/{robot.space.lower()}/{n}": text for n, text in files.items()}
    named = [*files]
    has_runtime = library.options.has_runtime or robot.has_names_of_0_5
    if has_runtime:
        files |= runtime_files()
    files["CMakeLists.txt"] = robot.rendered(
        "CMakeLists.txt",
        has_runtime=has_runtime,
        sources=[name for name in named if name.endswith(".cpp")],
        headers=[name for name in named if name.endswith(".h")],
    )
    return files


def runtime_files() -> dict[str, str]:
    """Return the headers that all robots share, by their paths."""
    return {
        path.relative_to(RUNTIME).as_posix(): path.read_text(encoding="utf-8")
        for path in sorted(RUNTIME.rglob("*.h"))
    }


def _headers(robot: GeneratedRobot) -> Iterator[tuple[str, str]]:
    """Yield the name and text of each header, and of the source."""
    header = robot.header
    yield "declarations.h", header("declarations.h")
    for kind, names in (("Link", robot.body_names), ("Joint", robot.library.robot.joint_names)):
        file = f"{kind.lower()}_data_map.h"
        yield file, header(file, "data_map.h", kind=kind, names=names)
    for file in ("kinematics_parameters.h", "dynamics_parameters.h", "default_dynparams_getter.h"):
        yield file, header(file)
    across = {robot.across(link): link for link in robot.tree.links()}
    matrices, kernels = transforms(robot, transform_pairs(robot))
    values = {"kinds": KINDS, "matrices": matrices, "across": across}
    yield from _with_kernels(robot, "transforms", kernels, **values)
    matrices, kernels = jacobians(robot, jacobian_pairs(robot))
    yield from _with_kernels(robot, "jacobians", kernels, matrices=matrices)
    kernels = dynamics.inertia_kernels(robot)
    yield from _with_kernels(robot, "inertia_properties", kernels)
    kernels = dynamics.inverse_dynamics_kernels(robot)
    yield from _with_kernels(robot, "inverse_dynamics", kernels)
    kernels = dynamics.forward_dynamics_kernels(robot)
    yield from _with_kernels(robot, "forward_dynamics", kernels)
    kernels = dynamics.joint_space_inertia_kernels(robot)
    yield from _with_kernels(robot, "jsim", kernels, before=_before(robot))
    yield "traits.h", header("traits.h")
    yield "miscellaneous.h", header("miscellaneous.h")
    yield "miscellaneous.cpp", robot.rendered("miscellaneous.cpp")
    if robot.has_names_of_0_5:
        yield "rbd_types.h", header("rbd_types.h")
        yield "model_constants.h", header("model_constants.h")


def _with_kernels(
    robot: GeneratedRobot, name: str, kernels: list[str], **values: object
) -> Iterator[tuple[str, str]]:
    """Yield a header, and that of the functions that it calls."""
    yield f"{name}.h", robot.header(f"{name}.h", **values)
    yield f"{name}.impl.h", robot.header(f"{name}.impl.h", "kernels.h", functions=kernels)


def _before(robot: GeneratedRobot) -> list[int]:
    """Return the velocity variable before each on the way to the base, -1 for the first."""
    first = 6 if robot.is_floating else 0
    parents = robot.tree.parents
    # A link's variable is `first + link - 1`; a floating base's last is 5, a fixed base has none.
    return [*range(-1, first - 1), *(first + parents[i] - 1 for i in robot.tree.links())]
