"""`forward_dynamics.h` and `forward_dynamics.impl.h`."""

from collections.abc import Sequence

from kindsl.codegen.robcogen.engines import (
    Arguments,
    Engine,
    engine_headers,
    kernels_under_loads,
    parameters,
    parameters_first,
)
from kindsl.codegen.robcogen.robot import GeneratedRobot
from kindsl.dynamics.generation.forward_dynamics import forward_dynamics
from kindsl.dynamics.generation.terms import Scalar
from kindsl.dynamics.generation.vectors import ZERO, Vector

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
@PARAMETERS@        if (&fext != &zeroExtForces) {
            kernels::forward_dynamics_loaded<TRAIT>(
                @P@raw(q), raw(qd), raw(tau), &g, first(fext), raw(qdd));
        } else {
            kernels::forward_dynamics<TRAIT>(@P@raw(q), raw(qd), raw(tau), &g, raw(qdd));
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
                @P@raw(q), raw(qd), raw(tau), velocity.data(),
                first(fext), raw(qdd), acceleration.data());
        } else {
            kernels::forward_dynamics<TRAIT>(
                @P@raw(q), raw(qd), raw(tau), velocity.data(), raw(qdd),
                acceleration.data());
        }
        acceleration += weight;
    }
"""


def forward_dynamics_headers(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    compute = _FLOATING_COMPUTE if robot.is_floating else _FIXED_COMPUTE
    computing = robot.filled(compute, PARAMETERS=parameters(robot), P=parameters_first(robot))
    construction = "    ForwardDynamics(IProperties& in, MTransforms& tr)"
    calls = robot.filled(_FLOATING if robot.is_floating else _FIXED)
    engine = Engine(
        "ForwardDynamics",
        "The joint accelerations under joint forces.",
        f"{construction} : inertiaProps(&in), xm(&tr) {{}}\n\n{calls}",
        f"private:\n{computing}",
    )
    return engine_headers(robot, "forward_dynamics", engine, _kernels(robot))


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
