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
