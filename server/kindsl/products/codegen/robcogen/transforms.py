"""`transforms.h` and `transforms.impl.h`: coordinate transforms of motions, forces and points."""

from itertools import chain
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.vectors import Matrix, Vector, multiply, transpose
from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.long_transforms import HELPERS, is_long, long_kernels
from kindsl.products.codegen.robcogen.parameters import (
    groups,
    parameter_array,
    parameters_of_class,
    setters,
)
from kindsl.products.codegen.robcogen.robot import GeneratedRobot
from kindsl.products.codegen.robcogen.wanted_names import transform_pairs

_BASES = template("robcogen/transforms.h")
_CONTAINER = template("robcogen/transforms_container.h")
_TYPE = template("robcogen/transform.h")
_CASE = """\
    case @LINK@:
        m_@NAME@_constants<TRAIT>(X);
        m_@NAME@<TRAIT>(@P@q, X);
        break;
"""
_ACROSS = """\
template <class TRAIT>
inline void across(int link, @TAKES@const typename TRAIT::Scalar* q, typename TRAIT::Scalar* X)
{
    switch (link) {
@CASES@    }
}
"""


class _Kind(NamedTuple):
    letter: str
    name: str
    base: str
    what: str


KINDS = (
    _Kind("m", "Motion", "TransformMotion", "The 6x6 transforms of motion vectors."),
    _Kind("f", "Force", "TransformForce", "The 6x6 transforms of force vectors."),
    _Kind("h", "Homogeneous", "TransformHomogeneous", "The 4x4 transforms of points."),
)


def transforms(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    pairs = transform_pairs(robot)
    functions, products, moving = [HELPERS], [], {}
    for pair in pairs:
        if is_long(robot, pair):
            products += long_kernels(robot, pair)
            moving[pair.name] = bool(groups(robot))
        else:
            E, p = robot.pose_in(pair.base, pair.target)
            functions += _kernels(robot, pair.name, E, p)
            moving[pair.name] = robot.depends_on_parameters(chain(*E, p))
    functions += [*products, _across(robot)]
    classes = "".join(_container(robot, kind, moving) for kind in KINDS)
    body = robot.filled(_BASES, CLASSES=classes)
    includes = [
        "<Eigen/Dense>", "<iit/rbd/rbd.h>", "<iit/rbd/TransformsBase.h>",
        "<iit/rbd/traits/DoubleTrait.h>", '"declarations.h"', '"kinematics_parameters.h"',
    ]  # fmt: skip
    return robot.headers("transforms", includes, body, functions)


def _kernels(robot: GeneratedRobot, name: str, E: Matrix, p: Vector) -> list[str]:
    """Return the functions of a pair's three matrices."""
    return [
        function
        for kind in KINDS
        for function in robot.matrix_kernels(
            f"{kind.letter}_{name}", transpose(matrix_of(kind.letter, E, p))
        )
    ]


def matrix_of(letter: str, E: Matrix, p: Vector) -> Matrix:
    """Return a transform of motions, forces or points (m, f, h) from rotation and position."""
    if letter == "h":
        return [[*E[row], p[row]] for row in range(3)] + [[0.0, 0.0, 0.0, 1.0]]
    crossed: Matrix = [[0.0, 0.0 - p[2], p[1]], [p[2], 0.0, 0.0 - p[0]], [0.0 - p[1], p[0], 0.0]]
    coupling, nothing = multiply(crossed, E), [0.0] * 3
    if letter == "m":
        below = [[*c, *e] for c, e in zip(coupling, E, strict=True)]
        return [[*e, *nothing] for e in E] + below
    return [[*e, *c] for e, c in zip(E, coupling, strict=True)] + [[*nothing, *e] for e in E]


def _container(robot: GeneratedRobot, kind: _Kind, moving: dict[str, bool]) -> str:
    across = {robot.across(i): i for i in robot.tree.links()} if kind.letter == "m" else {}
    types = "\n".join(
        _type(robot, kind, name, has_parameters, across.get(name))
        for name, has_parameters in moving.items()
    )
    members = "".join(f"    Type_{name} {name};\n" for name in moving)
    dependent = [name for name, has_parameters in moving.items() if has_parameters]
    construction, values = setters(robot, f"{kind.name}Transforms", dependent)
    return robot.filled(
        _CONTAINER,
        WHAT=kind.what,
        CLASS=f"{kind.name}Transforms",
        BASE=kind.base,
        TYPES=types,
        CONSTRUCTION=construction,
        MEMORY=_memory(across) if across else "",
        MEMBERS=members,
        VALUES=values,
    )


def _type(
    robot: GeneratedRobot, kind: _Kind, name: str, has_parameters: bool, joint: int | None
) -> str:
    memory = parameters_of_class(robot) if has_parameters else ""
    store = ""
    if joint is not None:
        store = f"            position = q({joint - 1});\n"
        memory += "        Scalar position; // of the joint, when this was updated last\n"
    array = parameter_array(robot, "            ") if has_parameters else ""
    return robot.filled(
        _TYPE,
        NAME=name,
        BASE=kind.base,
        KIND=kind.letter,
        INITIAL="" if joint is None else " : position(0)",
        PARAMETERS=array,
        P=("p, " if has_parameters else "nullptr, ") if robot.has_parameters else "",
        STORE=store,
        MEMORY=memory,
    )


def _memory(across: dict[str, int]) -> str:
    kept = "".join(f"        {name}.position = q({i - 1});\n" for name, i in across.items())
    told = "".join(f"        q({i - 1}) = {name}.position;\n" for name, i in across.items())
    return (
        "    /** Keeps joint positions for what is computed without any; no matrix changes. */\n"
        f"    void storeJointStatus(const JState& q)\n    {{\n{kept}    }}\n"
        "    /** Returns the joint positions that each transform was updated with last. */\n"
        f"    void loadJointStatus(JState& q) const\n    {{\n{told}    }}\n"
    )


def _across(robot: GeneratedRobot) -> str:
    """Return the function that fills in the motion transform to any link from its parent."""
    links = robot.tree.links()
    cases = "".join(robot.filled(_CASE, LINK=i, NAME=robot.across(i)) for i in links)
    return robot.filled(_ACROSS, CASES=cases)
