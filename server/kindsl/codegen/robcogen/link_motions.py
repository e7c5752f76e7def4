"""The motions of links that inverse dynamics was asked for, computed when a getter asks."""

from kindsl.codegen.robcogen.engines import parameters, parameters_first
from kindsl.codegen.robcogen.robot import GeneratedRobot

# The statements that keep a motion for the getters.
KEEP_MOTION = """\
        q_v = unaligned(q);
        qd_v = unaligned(qd);
        isVelocityKnown = false;
        asked = MOTION;
"""

_STATE = """\
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
"""

_PASSES = """
    enum Asked { NOTHING, MOTION, REST };

    /** A vector that need not stand where Eigen wants it, as in a plain std::vector. */
    static Eigen::Map<const JointState> unaligned(const JointState& v)
    {
        return Eigen::Map<const JointState>(raw(v));
    }

    void keepForces(const ExtForces& fext)
    {
        isLoaded = &fext != &zeroExtForces;
        if (isLoaded) {
            loads = fext;
        }
    }

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
@PARAMETERS@        kernels::across<TRAIT>(link, @P@raw(q), X.data());
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


def getters(robot: GeneratedRobot) -> str:
    """Return the functions that tell velocities, accelerations and forces."""
    ids = robot.body_ids
    texts = [robot.filled(_BASE_GETTER, NAME=robot.bodies[0], ID=ids[0])] * robot.is_floating
    texts += [robot.filled(_GETTERS, NAME=robot.bodies[i], ID=ids[i]) for i in robot.tree.links()]
    return "".join(texts)


def link_motions(robot: GeneratedRobot) -> str:
    """Return the functions behind the getters and the members that they read."""
    kinds = robot.tree.kinds
    axes = (f"iit::rbd::{'AZ' if k == 'revolute' else 'LZ'}" for k in kinds)
    *first, last = robot.inertial_bodies
    inertia = "".join(f"        case {i}: return {_tensor(robot, i)};\n" for i in first)
    return robot.filled(
        _PASSES + _STATE,
        PARAMETERS=parameters(robot),
        P=parameters_first(robot),
        PARENTS=", ".join(map(str, robot.tree.parents)),
        AXES=", ".join(axes),
        INERTIA=f"{inertia}        default: return {_tensor(robot, last)};\n",
        FIRST=robot.inertial_bodies[0],
    )


def _tensor(robot: GeneratedRobot, body: int) -> str:
    return f"inertiaProps->getTensor_{robot.bodies[body]}()"
