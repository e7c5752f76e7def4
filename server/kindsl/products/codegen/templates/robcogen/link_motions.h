
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
