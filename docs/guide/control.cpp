#include "traits.h"

#include <cmath>
#include <cstdio>

typedef iit::Crane::tpl::Traits<double> Crane;

int main()
{
    Crane::MotionTransforms transforms;
    Crane::InertiaProperties inertia;
    Crane::InvDynEngine inverse(inertia, transforms);
    Crane::FwdDynEngine forward(inertia, transforms);
    Crane::JointState q, qd, qdd, tau;
    q.setConstant(0.5);
    qd.setZero();
    for (int step = 0; step < 5000; step++) {
        qdd = -100.0 * q - 20.0 * qd;
        inverse.id(tau, q, qd, qdd);
        forward.fd(qdd, q, qd, tau);
        qd += 0.001 * qdd;
        q += 0.001 * qd;
    }
    std::printf("%s\n", q.norm() < 1e-9 ? "the crane is where it should be" : "it is not");
    return 0;
}
