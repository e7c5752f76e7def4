"""`inverse_dynamics.h` and `inverse_dynamics.impl.h`."""

from collections.abc import Sequence

from kindsl.codegen.robcogen.engines import (
    INCLUDES,
    MEMBERS,
    STATUS,
    TYPES,
    Arguments,
    at_rest,
    handed,
    kernels_under_loads,
    parameters,
    updates,
)
from kindsl.codegen.robcogen.robot import GeneratedRobot
from kindsl.dynamics.generation.inverse_dynamics import (
    actuated_base_inverse_dynamics,
    bias_torque,
    floating_base_inverse_dynamics,
    inverse_dynamics,
)
from kindsl.dynamics.generation.terms import Scalar
from kindsl.dynamics.generation.vectors import ZERO, Vector

_TEXT = """
namespace iit {
namespace @NS@ {
namespace dyn {
namespace tpl {

/**
 * The joint forces of a motion.
 *
 * Overloads without q take the joint positions that the transforms have. Forces on links are in the
 * links' coordinates. What the getters tell is computed when they are asked.
 */
template <typename TRAIT>
class InverseDynamics {
public:
@TYPES@
    InverseDynamics(IProperties& in, MTransforms& tr) : inertiaProps(&in), xm(&tr)
    {
        velocities = Velocity::Zero();
        accelerations = Acceleration::Zero();
        forces = Force::Zero();
    }

@FUNCTIONS@
@STATUS@
@GETTERS@
protected:
@ABSENT@
private:
    enum Asked { NOTHING, MOTION, REST };

    /** A vector that need not stand where Eigen wants it, as in a plain std::vector. */
    static Eigen::Map<const JointState> unaligned(const JointState& v)
    {
        return Eigen::Map<const JointState>(v.data());
    }

    static const Scalar* first(const ExtForces& fext)
    {
        return fext[orderedLinkIDs[0]].data();
    }

    void keepForces(const ExtForces& fext)
    {
        isLoaded = &fext != &zeroExtForces;
        if (isLoaded) {
            loads = fext;
        }
    }

@LINKS@
    // The last motion that velocities, and all the rest, were asked for.
    JointState q_v, qd_v, qdd_a, q_a;
    Velocity v0;
    Acceleration a0, a0_late;
    ExtForces loads;
    bool isLoaded = false;
    bool isLate = false;
    mutable bool isVelocityKnown = true;
    mutable Asked asked = NOTHING;
    mutable LinkDataMap<Velocity> velocities;
    mutable LinkDataMap<Acceleration> accelerations;
    mutable LinkDataMap<Force> forces;

@MEMBERS@
}
}
}
"""

# What every function keeps for the getters.
_KEEP_MOTION = """\
        q_v = unaligned(q);
        qd_v = unaligned(qd);
        isVelocityKnown = false;
        asked = MOTION;
"""

_FIXED = """\
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

_FIXED_LINKS = """\
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
                @P@q.data(), qd.data(), qdd.data(), &g, first(fext), jForces.data());
        } else {
            kernels::inverse_dynamics<TRAIT>(
                @P@q.data(), qd.data(), qdd.data(), &g, jForces.data());
        }
    }

    void gravity(JointState& jForces, const JointState& q)
    {
        const Scalar g(iit::rbd::g);
        q_a = unaligned(q);
        asked = REST;
        setBase(g);
@PARAMETERS@        kernels::gravity<TRAIT>(@P@q.data(), &g, jForces.data());
    }

    void coriolis(JointState& jForces, const JointState& q, const JointState& qd)
    {
@KEEP@        qdd_a.setZero();
        setBase(Scalar(0));
        isLoaded = false;
@PARAMETERS@        kernels::coriolis<TRAIT>(@P@q.data(), qd.data(), jForces.data());
    }

    /** The base stands still; it seems to accelerate upwards. */
    void setBase(const Scalar& g)
    {
        v0.setZero();
        a0.setZero();
        a0(iit::rbd::LZ) = g;
    }
"""

_FLOATING = """\
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

_FLOATING_LINKS = """\
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
                @P@q.data(), qd.data(), qdd.data(), velocity.data(), first(fext), jForces.data(),
                acceleration.data());
        } else {
            kernels::inverse_dynamics<TRAIT>(
                @P@q.data(), qd.data(), qdd.data(), velocity.data(), jForces.data(),
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
                @P@q.data(), qd.data(), qdd.data(), velocity.data(), a0.data(), first(fext),
                jForces.data(), wrench.data());
        } else {
            kernels::inverse_dynamics_actuated<TRAIT>(
                @P@q.data(), qd.data(), qdd.data(), velocity.data(), a0.data(), jForces.data(),
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
@PARAMETERS@        kernels::gravity<TRAIT>(@P@q.data(), a0.data(), jForces.data(), wrench.data());
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
            @P@q.data(), qd.data(), velocity.data(), jForces.data(), wrench.data());
    }
"""

_LINKS = """
    static int parent(int link)
    {
        static const int parents[linksCount] = {@PARENTS@};
        return parents[link];
    }
    static iit::rbd::Coords6D axis(int link)
    {
        static const iit::rbd::Coords6D axes[linksCount] = {@AXES@};
        return axes[link];
    }

    Matrix66s across(int link, const JointState& q) const
    {
        Matrix66s X = Matrix66s::Zero();
@PARAMETERS@        kernels::across<TRAIT>(link, @P@q.data(), X.data());
        return X;
    }

    /** The rate of a motion vector that is constant in its link, which moves by v. */
    static Acceleration cross(const Velocity& v, const Velocity& m)
    {
        Acceleration rate;
        rate.template head<3>() = v.template head<3>().cross(m.template head<3>());
        rate.template tail<3>() = v.template head<3>().cross(m.template tail<3>())
            + v.template tail<3>().cross(m.template head<3>());
        return rate;
    }

    static Force bias(const Velocity& v, const InertiaMatrix& inertia)
    {
        const Force h = inertia * v;
        Force rate;
        rate.template head<3>() = v.template head<3>().cross(h.template head<3>())
            + v.template tail<3>().cross(h.template tail<3>());
        rate.template tail<3>() = v.template head<3>().cross(h.template tail<3>());
        return rate;
    }

    void bringVelocities() const
    {
        if (isVelocityKnown) {
            return;
        }
        isVelocityKnown = true;
        velocities[orderedLinkIDs[0]] = v0;
        for (int i = 1; i < linksCount; i++) {
            Velocity& v = velocities[orderedLinkIDs[i]];
            v = across(i, q_v) * velocities[orderedLinkIDs[parent(i)]];
            v(axis(i)) += qd_v(i - 1);
        }
    }

    const InertiaMatrix& inertia(int link) const
    {
        switch (link) {
@INERTIA@        }
    }

    void bringForces() const
    {
        if (asked == NOTHING) {
            return;
        }
        const bool isMoving = asked == MOTION;
        asked = NOTHING;
        if (isMoving) {
            bringVelocities();
        }
        const JointState& q = isMoving ? q_v : q_a;
        accelerations[orderedLinkIDs[0]] = a0;
        for (int i = 1; i < linksCount; i++) {
            Acceleration& a = accelerations[orderedLinkIDs[i]];
            a = across(i, q) * accelerations[orderedLinkIDs[parent(i)]];
            if (isMoving) {
                Velocity joint = Velocity::Zero();
                joint(axis(i)) = qd_v(i - 1);
                a += cross(velocities[orderedLinkIDs[i]], joint);
                a(axis(i)) += qdd_a(i - 1);
            }
        }
        for (int i = @FIRST@; i < linksCount; i++) {
            const LinkIdentifiers link = orderedLinkIDs[i];
            forces[link] = inertia(i) * accelerations[link];
            if (isMoving) {
                forces[link] += bias(velocities[link], inertia(i));
            }
            if (isMoving && isLoaded) {
                forces[link] -= loads[link];
            }
        }
        for (int i = linksCount - 1; i > 0; i--) {
            if (parent(i) >= @FIRST@) {
                forces[orderedLinkIDs[parent(i)]]
                    += across(i, q).transpose() * forces[orderedLinkIDs[i]];
            }
        }
        if (isLate) {
            // As it is with RobCoGen: what the base's own acceleration gives the links.
            accelerations[orderedLinkIDs[0]] = a0_late;
            for (int i = 1; i < linksCount; i++) {
                accelerations[orderedLinkIDs[i]]
                    = across(i, q) * accelerations[orderedLinkIDs[parent(i)]];
            }
        }
    }
"""

_GETTERS = """\
    const Velocity& getVelocity_@NAME@() const
    {
        bringVelocities();
        return velocities[@ID@];
    }
    const Acceleration& getAcceleration_@NAME@() const
    {
        bringForces();
        return accelerations[@ID@];
    }
    const Force& getForce_@NAME@() const
    {
        bringForces();
        return forces[@ID@];
    }
"""

_BASE_GETTER = """\
    const Force& getForce_@NAME@() const
    {
        bringForces();
        return forces[@ID@];
    }
"""

_ABSENT = """\
    template <typename... A>
    void @METHOD@(A&&...)
    {
        static_assert(kernels::Never<void(A...)>::value,
            "there are no passes to call: id and its like compute everything at once");
    }
"""


def inverse_dynamics_headers(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    kernels = _floating_kernels(robot) if robot.is_floating else _fixed_kernels(robot)
    text = robot.kernels(kernels)
    name = "inverse_dynamics.impl.h"
    return {
        "inverse_dynamics.h": robot.header(
            "inverse_dynamics.h", [*INCLUDES, f'"{name}"'], _class(robot)
        ),
        name: robot.header(name, ['"declarations.h"'], text),
    }


def _class(robot: GeneratedRobot) -> str:
    ids = robot.body_ids
    getters = [robot.filled(_BASE_GETTER, NAME=robot.bodies[0], ID=ids[0])] * robot.is_floating
    getters += [robot.filled(_GETTERS, NAME=robot.bodies[i], ID=ids[i]) for i in robot.tree.links()]
    absent = ["secondPass_fullyActuated"] if robot.is_floating else ["firstPass", "secondPass"]
    own = _FLOATING_LINKS if robot.is_floating else _FIXED_LINKS
    kinds = robot.tree.kinds
    axes = (f"iit::rbd::{'AZ' if k == 'revolute' else 'LZ'}" for k in kinds)
    *first, last = robot.inertial_bodies
    inertia = "".join(f"        case {i}: return {_tensor(robot, i)};\n" for i in first)
    values = {
        "KEEP": _KEEP_MOTION,
        "PARAMETERS": parameters(robot),
        "P": handed(robot),
        "PARENTS": ", ".join(map(str, robot.tree.parents)),
        "AXES": ", ".join(axes),
        "INERTIA": f"{inertia}        default: return {_tensor(robot, last)};\n",
        "FIRST": robot.inertial_bodies[0],
    }
    return robot.filled(
        _TEXT,
        TYPES=robot.filled(TYPES),
        FUNCTIONS=robot.filled(_FLOATING if robot.is_floating else _FIXED),
        STATUS=robot.filled(STATUS, UPDATES=updates(robot)),
        MEMBERS=robot.filled(MEMBERS, CLASS="InverseDynamics"),
        GETTERS="".join(getters),
        ABSENT="".join(robot.filled(_ABSENT, METHOD=method) for method in absent),
        LINKS=robot.filled(own + _LINKS, **values),
    )


def _tensor(robot: GeneratedRobot, body: int) -> str:
    return f"inertiaProps->getTensor_{robot.bodies[body]}()"


def _fixed_kernels(robot: GeneratedRobot) -> list[str]:
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


def _floating_kernels(robot: GeneratedRobot) -> list[str]:
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
