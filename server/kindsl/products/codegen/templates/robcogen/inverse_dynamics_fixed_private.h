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
                @P@raw(q), raw(qd), raw(qdd), &g, first(fext), raw(jForces));
        } else {
            kernels::inverse_dynamics<TRAIT>(
                @P@raw(q), raw(qd), raw(qdd), &g, raw(jForces));
        }
    }

    void gravity(JointState& jForces, const JointState& q)
    {
        const Scalar g(iit::rbd::g);
        q_a = unaligned(q);
        asked = REST;
        setBase(g);
@PARAMETERS@        kernels::gravity<TRAIT>(@P@raw(q), &g, raw(jForces));
    }

    void coriolis(JointState& jForces, const JointState& q, const JointState& qd)
    {
@KEEP@        qdd_a.setZero();
        setBase(Scalar(0));
        isLoaded = false;
@PARAMETERS@        kernels::coriolis<TRAIT>(@P@raw(q), raw(qd), raw(jForces));
    }

    /** The base stands still; it seems to accelerate upwards. */
    void setBase(const Scalar& g)
    {
        v0.setZero();
        a0.setZero();
        a0(iit::rbd::LZ) = g;
    }
