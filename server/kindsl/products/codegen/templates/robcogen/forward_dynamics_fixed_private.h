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
