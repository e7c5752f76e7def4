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
