"""`forward_dynamics.h` and `forward_dynamics.impl.h`."""

from collections.abc import Sequence

from kindsl.codegen.robcogen.engines import (
    INCLUDES,
    MEMBERS,
    STATUS,
    TYPES,
    Arguments,
    handed,
    kernels_under_loads,
    parameters,
    updates,
)
from kindsl.codegen.robcogen.robot import GeneratedRobot
from kindsl.dynamics.generation.forward_dynamics import forward_dynamics
from kindsl.dynamics.generation.terms import Scalar
from kindsl.dynamics.generation.vectors import ZERO, Vector

_TEXT = """
namespace iit {
namespace @NS@ {
namespace dyn {
namespace tpl {

/**
 * The joint accelerations under joint forces.
 *
 * Overloads without q take the joint positions that the transforms have. Forces on links are in the
 * links' coordinates.
 */
template <typename TRAIT>
class ForwardDynamics {
public:
@TYPES@
    ForwardDynamics(IProperties& in, MTransforms& tr) : inertiaProps(&in), xm(&tr) {}

@FUNCTIONS@
@STATUS@
private:
@COMPUTE@
@MEMBERS@
}
}
}
"""

_FIXED = """\
    void fd(
        JointState& qdd, const JointState& q, const JointState& qd, const JointState& tau,
        const ExtForces& fext = zeroExtForces)
    {
        xm->storeJointStatus(q);
        compute(qdd, q, qd, tau, fext);
    }
    void fd(
        JointState& qdd, const JointState& qd, const JointState& tau,
        const ExtForces& fext = zeroExtForces)
    {
        compute(qdd, jointStatus(), qd, tau, fext);
    }
"""

_FIXED_COMPUTE = """\
    void compute(
        JointState& qdd, const JointState& q, const JointState& qd, const JointState& tau,
        const ExtForces& fext)
    {
        const Scalar g(iit::rbd::g);
@PARAMETERS@@UNUSED@        if (&fext != &zeroExtForces) {
            kernels::forward_dynamics_loaded<TRAIT>(
                @P@q.data(), qd.data(), tau.data(), &g, fext[orderedLinkIDs[0]].data(), qdd.data());
        } else {
            kernels::forward_dynamics<TRAIT>(@P@q.data(), qd.data(), tau.data(), &g, qdd.data());
        }
    }
"""

_FLOATING = """\
    void fd(
        JointState& qdd, Acceleration& @BASE@_a, const Velocity& @BASE@_v, const Acceleration& g,
        const JointState& q, const JointState& qd, const JointState& tau,
        const ExtForces& fext = zeroExtForces)
    {
        xm->storeJointStatus(q);
        compute(qdd, @BASE@_a, @BASE@_v, g, q, qd, tau, fext);
    }
    void fd(
        JointState& qdd, Acceleration& @BASE@_a, const Velocity& @BASE@_v, const Acceleration& g,
        const JointState& qd, const JointState& tau, const ExtForces& fext = zeroExtForces)
    {
        compute(qdd, @BASE@_a, @BASE@_v, g, jointStatus(), qd, tau, fext);
    }
"""

_FLOATING_COMPUTE = """\
    void compute(
        JointState& qdd, Acceleration& acceleration, const Velocity& velocity,
        const Acceleration& g, const JointState& q, const JointState& qd, const JointState& tau,
        const ExtForces& fext)
    {
        const Acceleration weight = g;
@PARAMETERS@        if (&fext != &zeroExtForces) {
            kernels::forward_dynamics_loaded<TRAIT>(
                @P@q.data(), qd.data(), tau.data(), velocity.data(),
                fext[orderedLinkIDs[0]].data(), qdd.data(), acceleration.data());
        } else {
            kernels::forward_dynamics<TRAIT>(
                @P@q.data(), qd.data(), tau.data(), velocity.data(), qdd.data(),
                acceleration.data());
        }
        acceleration += weight;
    }
"""


def forward_dynamics_headers(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    compute = _FLOATING_COMPUTE if robot.is_floating else _FIXED_COMPUTE
    body = robot.filled(
        _TEXT,
        TYPES=robot.filled(TYPES),
        FUNCTIONS=robot.filled(_FLOATING if robot.is_floating else _FIXED),
        STATUS=robot.filled(STATUS, UPDATES=updates(robot)),
        MEMBERS=robot.filled(MEMBERS, CLASS="ForwardDynamics"),
        COMPUTE=robot.filled(compute, PARAMETERS=parameters(robot), P=handed(robot), UNUSED=""),
    )
    name = "forward_dynamics.impl.h"
    return {
        "forward_dynamics.h": robot.header("forward_dynamics.h", [*INCLUDES, f'"{name}"'], body),
        name: robot.header(name, ['"declarations.h"'], robot.kernels(_kernels(robot))),
    }


def _kernels(robot: GeneratedRobot) -> list[str]:
    tree, x, n = robot.tree, robot.library.inputs, robot.n_joints
    takes: dict[str, Sequence[Scalar]] = {"q": x.q, "qd": x.qd, "tau": x.tau}
    weight: Vector = ZERO
    if robot.is_floating:
        takes["v0"] = x.v0
    else:
        g = robot.library.robot.graph.input()
        takes["g"], weight = [g], [0.0, 0.0, -g]

    def results(forces: Sequence[Vector]) -> Arguments:
        found = forward_dynamics(tree, x.q, x.qd, x.tau, x.v0, weight, forces)
        return {"qdd": found[:n], "a0": found[n:]} if robot.is_floating else {"qdd": found[:n]}

    return kernels_under_loads(robot, "forward_dynamics", takes, results)
