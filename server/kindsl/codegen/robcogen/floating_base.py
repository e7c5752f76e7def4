"""Inverse dynamics of a robot whose base is free, or driven: calls, and the code behind them."""

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
    actuated_base_inverse_dynamics,
    bias_torque,
    floating_base_inverse_dynamics,
)
from kindsl.dynamics.generation.terms import Scalar
from kindsl.dynamics.generation.vectors import ZERO, Vector

_CALLS = """\
    /** The base is free: gives its acceleration. */
    void id(
        JointState& jForces, Acceleration& @BASE@_a, const Acceleration& g,
        const Velocity& @BASE@_v, const JointState& q, const JointState& qd, const JointState& qdd,
        const ExtForces& fext = zeroExtForces)
    {
        xm->storeJointStatus(q);
        compute(jForces, @BASE@_a, g, @BASE@_v, q, qd, qdd, fext);
    }
    void id(
        JointState& jForces, Acceleration& @BASE@_a, const Acceleration& g,
        const Velocity& @BASE@_v, const JointState& qd, const JointState& qdd,
        const ExtForces& fext = zeroExtForces)
    {
        compute(jForces, @BASE@_a, g, @BASE@_v, jointStatus(), qd, qdd, fext);
    }

    /** The base is moved by a wrench: gives this. */
    void id_fully_actuated(
        Force& baseWrench, JointState& jForces, const Acceleration& g, const Velocity& @BASE@_v,
        const Acceleration& baseAccel, const JointState& q, const JointState& qd,
        const JointState& qdd, const ExtForces& fext = zeroExtForces)
    {
        xm->storeJointStatus(q);
        actuated(baseWrench, jForces, g, @BASE@_v, baseAccel, q, qd, qdd, fext);
    }
    void id_fully_actuated(
        Force& baseWrench, JointState& jForces, const Acceleration& g, const Velocity& @BASE@_v,
        const Acceleration& baseAccel, const JointState& qd, const JointState& qdd,
        const ExtForces& fext = zeroExtForces)
    {
        actuated(baseWrench, jForces, g, @BASE@_v, baseAccel, jointStatus(), qd, qdd, fext);
    }

    void G_terms_fully_actuated(
        Force& baseWrench, JointState& jForces, const Acceleration& g, const JointState& q)
    {
        xm->storeJointStatus(q);
        gravity(baseWrench, jForces, g, q);
    }
    void G_terms_fully_actuated(Force& baseWrench, JointState& jForces, const Acceleration& g)
    {
        gravity(baseWrench, jForces, g, jointStatus());
    }

    void C_terms_fully_actuated(
        Force& baseWrench, JointState& jForces, const Velocity& @BASE@_v, const JointState& q,
        const JointState& qd)
    {
        xm->storeJointStatus(q);
        coriolis(baseWrench, jForces, @BASE@_v, q, qd);
    }
    void C_terms_fully_actuated(
        Force& baseWrench, JointState& jForces, const Velocity& @BASE@_v, const JointState& qd)
    {
        coriolis(baseWrench, jForces, @BASE@_v, jointStatus(), qd);
    }
"""

_COMPUTING = """\
    void compute(
        JointState& jForces, Acceleration& acceleration, const Acceleration& g,
        const Velocity& velocity, const JointState& q, const JointState& qd, const JointState& qdd,
        const ExtForces& fext)
    {
@KEEP@        qdd_a = unaligned(qdd);
        v0 = velocity;
        const Acceleration weight = g;
        keepForces(fext);
@PARAMETERS@        if (isLoaded) {
            kernels::inverse_dynamics_loaded<TRAIT>(
                @P@raw(q), raw(qd), raw(qdd), velocity.data(), first(fext), raw(jForces),
                acceleration.data());
        } else {
            kernels::inverse_dynamics<TRAIT>(
                @P@raw(q), raw(qd), raw(qdd), velocity.data(), raw(jForces),
                acceleration.data());
        }
        a0.setZero();
        a0_late = acceleration;
        isLate = true;
        acceleration += weight;
    }

    void actuated(
        Force& wrench, JointState& jForces, const Acceleration& g, const Velocity& velocity,
        const Acceleration& acceleration, const JointState& q, const JointState& qd,
        const JointState& qdd, const ExtForces& fext)
    {
@KEEP@        qdd_a = unaligned(qdd);
        v0 = velocity;
        a0 = acceleration - g;
        isLate = false;
        keepForces(fext);
@PARAMETERS@        if (isLoaded) {
            kernels::inverse_dynamics_actuated_loaded<TRAIT>(
                @P@raw(q), raw(qd), raw(qdd), velocity.data(), a0.data(), first(fext),
                raw(jForces), wrench.data());
        } else {
            kernels::inverse_dynamics_actuated<TRAIT>(
                @P@raw(q), raw(qd), raw(qdd), velocity.data(), a0.data(), raw(jForces),
                wrench.data());
        }
    }

    void gravity(
        Force& wrench, JointState& jForces, const Acceleration& g, const JointState& q)
    {
        q_a = unaligned(q);
        asked = REST;
        a0 = -g;
        isLate = false;
@PARAMETERS@        kernels::gravity<TRAIT>(@P@raw(q), a0.data(), raw(jForces), wrench.data());
    }

    void coriolis(
        Force& wrench, JointState& jForces, const Velocity& velocity, const JointState& q,
        const JointState& qd)
    {
@KEEP@        qdd_a.setZero();
        v0 = velocity;
        a0.setZero();
        isLate = false;
        isLoaded = false;
@PARAMETERS@        kernels::coriolis<TRAIT>(
            @P@raw(q), raw(qd), velocity.data(), raw(jForces), wrench.data());
    }
"""


def floating_base(robot: GeneratedRobot) -> tuple[str, str, list[str]]:
    """Return the class's functions, what they call, and the functions that compute."""
    hidden = robot.filled(
        _COMPUTING, KEEP=KEEP_MOTION, PARAMETERS=parameters(robot), P=parameters_first(robot)
    )
    return robot.filled(_CALLS), hidden, _kernels(robot)


def _kernels(robot: GeneratedRobot) -> list[str]:
    """Return functions for a base in free fall; what gravity does is added to accelerations."""
    tree, x, n = robot.tree, robot.library.inputs, robot.n_joints
    motion: dict[str, Sequence[Scalar]] = {"q": x.q, "qd": x.qd, "qdd": x.qdd, "v0": x.v0}
    driven = {**motion, "a0": x.a0}

    def free(forces: Sequence[Vector]) -> Arguments:
        found = floating_base_inverse_dynamics(tree, x.q, x.qd, x.qdd, x.v0, ZERO, forces)
        return {"tau": found[:n], "a0": found[n:]}

    def held(forces: Sequence[Vector]) -> Arguments:
        found = actuated_base_inverse_dynamics(tree, x.q, x.qd, x.qdd, x.v0, x.a0, ZERO, forces)
        return {"tau": found[6:], "f0": found[:6]}

    kernels = kernels_under_loads(robot, "inverse_dynamics", motion, free)
    kernels += kernels_under_loads(robot, "inverse_dynamics_actuated", driven, held)
    rest, still = at_rest(robot), [0.0] * 6
    weight = actuated_base_inverse_dynamics(tree, x.q, rest, rest, [*still], x.a0, ZERO)
    moving = bias_torque(tree, x.q, x.qd, x.v0, ZERO)
    gives = {"tau": weight[6:], "f0": weight[:6]}
    kernels.append(robot.kernel("gravity", {"q": x.q, "a0": x.a0}, gives))
    takes = {"q": x.q, "qd": x.qd, "v0": x.v0}
    kernels.append(robot.kernel("coriolis", takes, {"tau": moving[6:], "f0": moving[:6]}))
    return kernels
