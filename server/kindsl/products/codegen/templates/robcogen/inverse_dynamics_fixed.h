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
