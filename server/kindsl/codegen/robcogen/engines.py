"""Code that the classes for inverse and forward dynamics share."""

from collections.abc import Sequence

from kindsl.codegen.robcogen.robot import GeneratedRobot
from kindsl.dynamics.generation.terms import Scalar
from kindsl.dynamics.generation.vectors import Vector

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


def external(robot: GeneratedRobot) -> list[Scalar]:
    """Return the wrenches on all bodies, one after the other."""
    return [component for wrench in robot.library.inputs.external for component in wrench]


def at_rest(robot: GeneratedRobot) -> Vector:
    """Return joint velocities of zero."""
    return [0.0] * robot.n_joints


def named(*pairs: tuple[str, Sequence[Scalar]]) -> dict[str, Sequence[Scalar]]:
    """Return arguments by their names."""
    return dict(pairs)
