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
