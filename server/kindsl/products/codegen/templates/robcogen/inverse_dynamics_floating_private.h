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
