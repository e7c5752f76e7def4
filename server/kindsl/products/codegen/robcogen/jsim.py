"""`jsim.h` and `jsim.impl.h`: the joint-space inertia matrix."""

from kindsl.mechanics.dynamics.generation.composite_bodies import joint_space_inertia
from kindsl.mechanics.dynamics.generation.vectors import transpose
from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.engines import parameters
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

_TEXT = template("robcogen/jsim.h")

_BLOCK_TYPES = """\
    typedef const Eigen::Block<const MatrixType, 6, @NJ@> BlockF_t;
    typedef const Eigen::Block<const MatrixType, @NJ@, @NJ@> BlockFixedBase_t;
"""

_BLOCKS = template("robcogen/jsim_blocks.h")


def jsim(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    M = joint_space_inertia(robot.tree, robot.library.inputs.q)
    kernels = robot.matrix_kernels("joint_space_inertia", transpose(M))
    body = robot.filled(
        _TEXT,
        BLOCK_TYPES=robot.filled(_BLOCK_TYPES) if robot.is_floating else "",
        BLOCKS=robot.filled(_BLOCKS) if robot.is_floating else "",
        BEFORE=", ".join(map(str, _before(robot))),
        WHOLE="    mutable InertiaMatrix whole;\n" if robot.is_floating else "",
        PARAMETERS=parameters(robot, "frcTransf->"),
    )
    includes = [
        "<cmath>", "<iit/rbd/rbd.h>", "<iit/rbd/StateDependentMatrix.h>",
        "<iit/rbd/robcogen_commons.h>", "<iit/rbd/traits/DoubleTrait.h>", '"declarations.h"',
        '"transforms.h"', '"inertia_properties.h"',
    ]  # fmt: skip
    return robot.headers("jsim", includes, body, kernels)


def _before(robot: GeneratedRobot) -> list[int]:
    """Return the velocity variable before each on the way to the base, -1 for the first."""
    first = 6 if robot.is_floating else 0
    parents = robot.tree.parents
    # A link's variable is `first + link - 1`; a floating base's last is 5, a fixed base has none.
    return [*range(-1, first - 1), *(first + parents[i] - 1 for i in robot.tree.links())]
