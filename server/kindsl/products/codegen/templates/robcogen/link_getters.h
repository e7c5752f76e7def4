    const Velocity& getVelocity_@NAME@() const
    {
        bringVelocities();
        return velocities[@ID@];
    }
    const Acceleration& getAcceleration_@NAME@() const
    {
        bringForces();
        return accelerations[@ID@];
    }
    const Force& getForce_@NAME@() const
    {
        bringForces();
        return forces[@ID@];
    }
