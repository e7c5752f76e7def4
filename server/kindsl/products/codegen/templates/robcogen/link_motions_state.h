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
