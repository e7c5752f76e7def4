{% extends "engine.h" %}
{% set name_of_class = "ForwardDynamics" %}
{% set about = "The joint accelerations under joint forces." %}
{% block calls %}
    ForwardDynamics(IProperties& in, MTransforms& tr) : inertiaProps(&in), xm(&tr) {}

{% if robot.is_floating %}
    void fd(
        JointState& qdd, Acceleration& @base@_a, const Velocity& @base@_v, const Acceleration& g,
        const JointState& q, const JointState& qd, const JointState& tau,
        const ExtForces& fext = zeroExtForces)
    {
        xm->storeJointStatus(q);
        compute(qdd, @base@_a, @base@_v, g, q, qd, tau, fext);
    }
    void fd(
        JointState& qdd, Acceleration& @base@_a, const Velocity& @base@_v, const Acceleration& g,
        const JointState& qd, const JointState& tau, const ExtForces& fext = zeroExtForces)
    {
        compute(qdd, @base@_a, @base@_v, g, jointStatus(), qd, tau, fext);
    }
{% else %}
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
{% endif %}
{% endblock %}
{% block rest %}
private:
{% if robot.is_floating %}
    void compute(
        JointState& qdd, Acceleration& acceleration, const Velocity& velocity,
        const Acceleration& g, const JointState& q, const JointState& qd, const JointState& tau,
        const ExtForces& fext)
    {
        const Acceleration weight = g;
{% include "list_parameters.h" %}
        if (&fext != &zeroExtForces) {
            kernels::forward_dynamics_loaded<TRAIT>(
                @p@raw(q), raw(qd), raw(tau), velocity.data(),
                first(fext), raw(qdd), acceleration.data());
        } else {
            kernels::forward_dynamics<TRAIT>(
                @p@raw(q), raw(qd), raw(tau), velocity.data(), raw(qdd),
                acceleration.data());
        }
        acceleration += weight;
    }
{% else %}
    void compute(
        JointState& qdd, const JointState& q, const JointState& qd, const JointState& tau,
        const ExtForces& fext)
    {
        const Scalar g = Scalar(iit::rbd::g);
{% include "list_parameters.h" %}
        if (&fext != &zeroExtForces) {
            kernels::forward_dynamics_loaded<TRAIT>(
                @p@raw(q), raw(qd), raw(tau), &g, first(fext), raw(qdd));
        } else {
            kernels::forward_dynamics<TRAIT>(@p@raw(q), raw(qd), raw(tau), &g, raw(qdd));
        }
    }
{% endif %}
{% endblock %}
