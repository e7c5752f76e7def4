{% extends "engine.h" %}
{% set name_of_class = "InverseDynamics" %}
{% set about = "The joint forces of a motion. What the getters tell is computed when they are asked." %}
{% block calls %}
    InverseDynamics(IProperties& in, MTransforms& tr) : inertiaProps(&in), xm(&tr)
    {
        velocities = Velocity::Zero();
        accelerations = Acceleration::Zero();
        forces = Force::Zero();
    }

{% if robot.is_floating %}
    /** The base is free: gives its acceleration. */
    void id(
        JointState& jForces, Acceleration& @base@_a, const Acceleration& g,
        const Velocity& @base@_v, const JointState& q, const JointState& qd, const JointState& qdd,
        const ExtForces& fext = zeroExtForces)
    {
        xm->storeJointStatus(q);
        compute(jForces, @base@_a, g, @base@_v, q, qd, qdd, fext);
    }
    void id(
        JointState& jForces, Acceleration& @base@_a, const Acceleration& g,
        const Velocity& @base@_v, const JointState& qd, const JointState& qdd,
        const ExtForces& fext = zeroExtForces)
    {
        compute(jForces, @base@_a, g, @base@_v, jointStatus(), qd, qdd, fext);
    }

    /** The base is moved by a wrench: gives this. */
    void id_fully_actuated(
        Force& baseWrench, JointState& jForces, const Acceleration& g, const Velocity& @base@_v,
        const Acceleration& baseAccel, const JointState& q, const JointState& qd,
        const JointState& qdd, const ExtForces& fext = zeroExtForces)
    {
        xm->storeJointStatus(q);
        actuated(baseWrench, jForces, g, @base@_v, baseAccel, q, qd, qdd, fext);
    }
    void id_fully_actuated(
        Force& baseWrench, JointState& jForces, const Acceleration& g, const Velocity& @base@_v,
        const Acceleration& baseAccel, const JointState& qd, const JointState& qdd,
        const ExtForces& fext = zeroExtForces)
    {
        actuated(baseWrench, jForces, g, @base@_v, baseAccel, jointStatus(), qd, qdd, fext);
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
        Force& baseWrench, JointState& jForces, const Velocity& @base@_v, const JointState& q,
        const JointState& qd)
    {
        xm->storeJointStatus(q);
        coriolis(baseWrench, jForces, @base@_v, q, qd);
    }
    void C_terms_fully_actuated(
        Force& baseWrench, JointState& jForces, const Velocity& @base@_v, const JointState& qd)
    {
        coriolis(baseWrench, jForces, @base@_v, jointStatus(), qd);
    }
{% else %}
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
{% endif %}
{% endblock %}
{% block rest %}
{% if robot.is_floating %}
    const Force& getForce_@base@() const
    {
        bringForces();
        return forces[@robot.body_ids[0]@];
    }
{% endif %}
{% for i in links %}
    const Velocity& getVelocity_@robot.bodies[i]@() const
    {
        bringVelocities();
        return velocities[@robot.body_ids[i]@];
    }
    const Acceleration& getAcceleration_@robot.bodies[i]@() const
    {
        bringForces();
        return accelerations[@robot.body_ids[i]@];
    }
    const Force& getForce_@robot.bodies[i]@() const
    {
        bringForces();
        return forces[@robot.body_ids[i]@];
    }
{% endfor %}
protected:
{% set absent = ("secondPass_fullyActuated",) if robot.is_floating else ("firstPass", "secondPass") %}
{% for method in absent %}
    template <typename... A>
    void @method@(A&&...)
    {
        static_assert(kernels::Never<void(A...)>::value,
            "there are no passes to call: id and its like compute everything at once");
    }
{% endfor %}

private:
{% if robot.is_floating %}
    void compute(
        JointState& jForces, Acceleration& acceleration, const Acceleration& g,
        const Velocity& velocity, const JointState& q, const JointState& qd, const JointState& qdd,
        const ExtForces& fext)
    {
        q_v = unaligned(q);
        qd_v = unaligned(qd);
        isVelocityKnown = false;
        asked = MOTION;
        qdd_a = unaligned(qdd);
        v0 = velocity;
        const Acceleration weight = g;
        keepForces(fext);
{% include "list_parameters.h" %}
        if (isLoaded) {
            kernels::inverse_dynamics_loaded<TRAIT>(
                @p@raw(q), raw(qd), raw(qdd), velocity.data(), first(fext), raw(jForces),
                acceleration.data());
        } else {
            kernels::inverse_dynamics<TRAIT>(
                @p@raw(q), raw(qd), raw(qdd), velocity.data(), raw(jForces),
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
        q_v = unaligned(q);
        qd_v = unaligned(qd);
        isVelocityKnown = false;
        asked = MOTION;
        qdd_a = unaligned(qdd);
        v0 = velocity;
        a0 = acceleration - g;
        isLate = false;
        keepForces(fext);
{% include "list_parameters.h" %}
        if (isLoaded) {
            kernels::inverse_dynamics_actuated_loaded<TRAIT>(
                @p@raw(q), raw(qd), raw(qdd), velocity.data(), a0.data(), first(fext),
                raw(jForces), wrench.data());
        } else {
            kernels::inverse_dynamics_actuated<TRAIT>(
                @p@raw(q), raw(qd), raw(qdd), velocity.data(), a0.data(), raw(jForces),
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
{% include "list_parameters.h" %}
        kernels::gravity<TRAIT>(@p@raw(q), a0.data(), raw(jForces), wrench.data());
    }

    void coriolis(
        Force& wrench, JointState& jForces, const Velocity& velocity, const JointState& q,
        const JointState& qd)
    {
        q_v = unaligned(q);
        qd_v = unaligned(qd);
        isVelocityKnown = false;
        asked = MOTION;
        qdd_a.setZero();
        v0 = velocity;
        a0.setZero();
        isLate = false;
        isLoaded = false;
{% include "list_parameters.h" %}
        kernels::coriolis<TRAIT>(
            @p@raw(q), raw(qd), velocity.data(), raw(jForces), wrench.data());
    }
{% else %}
    void compute(
        JointState& jForces, const JointState& q, const JointState& qd, const JointState& qdd,
        const ExtForces& fext)
    {
        const Scalar g = Scalar(iit::rbd::g);
        q_v = unaligned(q);
        qd_v = unaligned(qd);
        isVelocityKnown = false;
        asked = MOTION;
        qdd_a = unaligned(qdd);
        setBase(g);
        keepForces(fext);
{% include "list_parameters.h" %}
        if (isLoaded) {
            kernels::inverse_dynamics_loaded<TRAIT>(
                @p@raw(q), raw(qd), raw(qdd), &g, first(fext), raw(jForces));
        } else {
            kernels::inverse_dynamics<TRAIT>(
                @p@raw(q), raw(qd), raw(qdd), &g, raw(jForces));
        }
    }

    void gravity(JointState& jForces, const JointState& q)
    {
        const Scalar g = Scalar(iit::rbd::g);
        q_a = unaligned(q);
        asked = REST;
        setBase(g);
{% include "list_parameters.h" %}
        kernels::gravity<TRAIT>(@p@raw(q), &g, raw(jForces));
    }

    void coriolis(JointState& jForces, const JointState& q, const JointState& qd)
    {
        q_v = unaligned(q);
        qd_v = unaligned(qd);
        isVelocityKnown = false;
        asked = MOTION;
        qdd_a.setZero();
        setBase(Scalar(0));
        isLoaded = false;
{% include "list_parameters.h" %}
        kernels::coriolis<TRAIT>(@p@raw(q), raw(qd), raw(jForces));
    }

    /** The base stands still; it seems to accelerate upwards. */
    void setBase(const Scalar& g)
    {
        v0.setZero();
        a0.setZero();
        a0(iit::rbd::LZ) = g;
    }
{% endif %}

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
        static const int parents[linksCount] = {@robot.tree.parents|join(', ')@};
        return parents[link];
    }
    static iit::rbd::Coords6D axis(int link)
    {
        static const iit::rbd::Coords6D axes[linksCount] = {{% for kind in robot.tree.kinds %}iit::rbd::@'AZ' if kind == 'revolute' else 'LZ'@@'' if loop.last else ', '@{% endfor %}};
        return axes[link];
    }

    Matrix66s across(int link, const JointState& q) const
    {
        Matrix66s X = Matrix66s::Zero();
{% include "list_parameters.h" %}
        kernels::across<TRAIT>(link, @p@raw(q), X.data());
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
{% for i in robot.inertial_bodies %}
        @"default" if loop.last else "case " ~ i@: return inertiaProps->getTensor_@robot.bodies[i]@();
{% endfor %}
        }
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
        for (int i = @robot.inertial_bodies[0]@; i < linksCount; i++) {
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
            if (parent(i) >= @robot.inertial_bodies[0]@) {
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
{% endblock %}
