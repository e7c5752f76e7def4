"""Code that the classes for inverse and forward dynamics share."""

from collections.abc import Callable, Mapping, Sequence
from typing import TypeAlias

from kindsl.codegen.robcogen.robot import GeneratedRobot
from kindsl.dynamics.generation.terms import Scalar
from kindsl.dynamics.generation.vectors import Vector

Arguments: TypeAlias = Mapping[str, Sequence[Scalar]]

INCLUDES = (
    "<Eigen/Dense>", "<iit/rbd/rbd.h>", "<iit/rbd/InertiaMatrix.h>", "<iit/rbd/utils.h>",
    "<iit/rbd/robcogen_commons.h>", "<iit/rbd/traits/DoubleTrait.h>", '"declarations.h"',
    '"inertia_properties.h"', '"transforms.h"', '"link_data_map.h"',
)  # fmt: skip

TYPES = """\
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    typedef typename TRAIT::Scalar Scalar;
    typedef Scalar SCALAR;
    typedef iit::rbd::Core<Scalar> CoreS;
    typedef typename CoreS::ForceVector Force;
    typedef LinkDataMap<Force> ExtForces;
    typedef typename CoreS::VelocityVector Velocity;
    typedef typename CoreS::VelocityVector Acceleration;
    typedef typename CoreS::Column6D Column6DS;
    typedef typename CoreS::Matrix66 Matrix66s;
    typedef typename CoreS::Matrix66 Matrix66S;
    typedef iit::rbd::tpl::InertiaMatrixDense<Scalar> InertiaMatrix;
    typedef iit::@NS@::tpl::JointState<Scalar> JointState;
    typedef iit::@NS@::tpl::MotionTransforms<TRAIT> MTransforms;
    typedef InertiaProperties<TRAIT> IProperties;
    static_assert(sizeof(ExtForces) == sizeof(Scalar) * 6 * linksCount,
        "the forces on all links must lie one after the other in memory");
"""

STATUS = """\
    /** Updates the transforms across joints. */
    void setJointStatus(const JointState& q) const
    {
@UPDATES@    }
"""


# The end of either class, and what follows it.
MEMBERS = """\
    JointState jointStatus() const
    {
        JointState q;
        xm->loadJointStatus(q);
        return q;
    }

    IProperties* inertiaProps;
    MTransforms* xm;

    static const ExtForces zeroExtForces;
};

template <typename TRAIT>
const typename @CLASS@<TRAIT>::ExtForces
    @CLASS@<TRAIT>::zeroExtForces(@CLASS@<TRAIT>::Force::Zero());

}

typedef tpl::@CLASS@<rbd::DoubleTrait> @CLASS@;
"""


def updates(robot: GeneratedRobot) -> str:
    """Return the statements that update the transforms across joints."""
    return "".join(f"        xm->{robot.across(i)}(q);\n" for i in robot.tree.links())


def parameters(robot: GeneratedRobot, transforms: str = "xm->", indent: str = "        ") -> str:
    """Return the statements that list all parameters."""
    if not robot.has_parameters:
        return ""
    return (
        f"{indent}Scalar p[{len(robot.library.robot.parameters)}] = {{}};\n"
        f"{indent}{transforms}parameters(p);\n{indent}inertiaProps->parameters(p);\n"
    )


def handed(robot: GeneratedRobot) -> str:
    """Return the first argument of functions, which parameters are."""
    return "p, " if robot.has_parameters else ""


def kernels_under_loads(
    robot: GeneratedRobot,
    name: str,
    takes: Arguments,
    results: Callable[[Sequence[Vector]], Arguments],
) -> list[str]:
    """Return a function without forces on links, and with them: its name with `_loaded`.

    That of a large robot is one for both, which compilers take half the time for: forces add little
    there.

    Args:
        robot: The robot.
        name: The function's name.
        takes: Its arguments.
        results: Takes the wrench on each body, none for no forces; returns the results.
    """
    given: Arguments = {**takes, "fext": robot.library.external}
    loaded = results(robot.library.inputs.external)
    with_loads = robot.kernel(f"{name}_loaded", given, loaded)
    if not robot.is_large:
        return [robot.kernel(name, takes, results([])), with_loads]
    number, first = "typename TRAIT::Scalar", ["p"] if robot.has_parameters else []
    declared = [f"const {number}* {n}" for n in (*first, *takes)]
    declared += [f"{number}* {n}" for n in loaded]
    handed_on = ", ".join((*first, *takes, "none", *loaded))
    size = len(given["fext"])
    without = (
        f"template <class TRAIT>\ninline void {name}({', '.join(declared)})\n{{\n"
        f"    {number} none[{size}];\n    for (int i = 0; i < {size}; i++) {{\n"
        f"        none[i] = {number}(0);\n    }}\n    {name}_loaded<TRAIT>({handed_on});\n}}\n"
    )
    return [with_loads, without]


def at_rest(robot: GeneratedRobot) -> Vector:
    """Return joint velocities of zero."""
    return [0.0] * robot.n_joints
