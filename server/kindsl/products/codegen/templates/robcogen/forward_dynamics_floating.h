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
