"""Inverse dynamics of a robot whose base stands still: calls, and the code behind them."""

from collections.abc import Sequence

from kindsl.codegen.robcogen.engines import (
    Arguments,
    at_rest,
    kernels_under_loads,
    parameters,
    parameters_first,
)
from kindsl.codegen.robcogen.link_motions import KEEP_MOTION
from kindsl.codegen.robcogen.robot import GeneratedRobot
from kindsl.dynamics.generation.inverse_dynamics import (
    bias_torque,
    inverse_dynamics,
)
from kindsl.dynamics.generation.terms import Scalar
from kindsl.dynamics.generation.vectors import ZERO, Vector

_CALLS = """\
    void id(
        JointState& jForces, const JointState& q, const JointState& qd, const JointState& qdd,
        const ExtForces& fext = zeroExtForces)
    {
        xm->storeJointStatus(q);
        compute(jForces, q, qd, qdd, fext);
    }
    void id(
        JointState& jForces, const JointState& qd, const JointState& qdd,
        const ExtForces& fext = zeroExtForces)
    {
        compute(jForces, jointStatus(), qd, qdd, fext);
    }

    void G_terms(JointState& jForces, const JointState& q)
    {
        xm->storeJointStatus(q);
        gravity(jForces, q);
    }
    void G_terms(JointState& jForces) { gravity(jForces, jointStatus()); }

    void C_terms(JointState& jForces, const JointState& q, const JointState& qd)
    {
        xm->storeJointStatus(q);
        coriolis(jForces, q, qd);
    }
    void C_terms(JointState& jForces, const JointState& qd)
    {
        coriolis(jForces, jointStatus(), qd);
    }
"""

_COMPUTING = """\
    void compute(
        JointState& jForces, const JointState& q, const JointState& qd, const JointState& qdd,
        const ExtForces& fext)
    {
        const Scalar g(iit::rbd::g);
@KEEP@        qdd_a = unaligned(qdd);
        setBase(g);
        keepForces(fext);
@PARAMETERS@        if (isLoaded) {
            kernels::inverse_dynamics_loaded<TRAIT>(
                @P@raw(q), raw(qd), raw(qdd), &g, first(fext), raw(jForces));
        } else {
            kernels::inverse_dynamics<TRAIT>(
                @P@raw(q), raw(qd), raw(qdd), &g, raw(jForces));
        }
    }

    void gravity(JointState& jForces, const JointState& q)
    {
        const Scalar g(iit::rbd::g);
        q_a = unaligned(q);
        asked = REST;
        setBase(g);
@PARAMETERS@        kernels::gravity<TRAIT>(@P@raw(q), &g, raw(jForces));
    }

    void coriolis(JointState& jForces, const JointState& q, const JointState& qd)
    {
@KEEP@        qdd_a.setZero();
        setBase(Scalar(0));
        isLoaded = false;
@PARAMETERS@        kernels::coriolis<TRAIT>(@P@raw(q), raw(qd), raw(jForces));
    }

    /** The base stands still; it seems to accelerate upwards. */
    void setBase(const Scalar& g)
    {
        v0.setZero();
        a0.setZero();
        a0(iit::rbd::LZ) = g;
    }
"""


def fixed_base(robot: GeneratedRobot) -> tuple[str, str, list[str]]:
    """Return the class's functions, what they call, and the functions that compute."""
    hidden = robot.filled(
        _COMPUTING, KEEP=KEEP_MOTION, PARAMETERS=parameters(robot), P=parameters_first(robot)
    )
    return robot.filled(_CALLS), hidden, _kernels(robot)


def _kernels(robot: GeneratedRobot) -> list[str]:
    graph, tree, x = robot.library.robot.graph, robot.tree, robot.library.inputs
    g = graph.input()
    weight: Vector = [0.0, 0.0, -g]
    motion: dict[str, Sequence[Scalar]] = {"q": x.q, "qd": x.qd, "qdd": x.qdd, "g": [g]}
    rest = at_rest(robot)
    still = bias_torque(tree, x.q, rest, [0.0] * 6, weight)
    floating = bias_torque(tree, x.q, x.qd, [0.0] * 6, ZERO)

    def results(forces: Sequence[Vector]) -> Arguments:
        return {"tau": inverse_dynamics(tree, x.q, x.qd, x.qdd, weight, forces)}

    return [
        *kernels_under_loads(robot, "inverse_dynamics", motion, results),
        robot.kernel("gravity", {"q": x.q, "g": [g]}, {"tau": still}),
        robot.kernel("coriolis", {"q": x.q, "qd": x.qd}, {"tau": floating}),
    ]
