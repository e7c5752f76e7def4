// RobCoGen's generated C++ for HyQ against generated C, a line for each quantity: name, its
// microseconds, ours. Medians of alternating rounds; results escape, or the compiler would delete
// what computes them.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <vector>

#include <Eigen/Dense>
#include <ct/iit_shim.h>

#include "hyq.h"
#include "testhyq/generated/declarations.h"
#include "testhyq/generated/traits.h"

using Clock = std::chrono::steady_clock;

template <class T> inline void escape(T &value) { asm volatile("" : : "r"(&value) : "memory"); }

template <class F> double time_of(F call)
{
    const auto start = Clock::now();
    for (int i = 0; i < 2000; i++) {
        call(i % 200);
    }
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count() / 2000;
}

template <class A, class B> void row(const char *what, A theirs, B ours)
{
    std::vector<double> a, b;
    for (int round = 0; round < 41; round++) {
        a.push_back(time_of(theirs));
        b.push_back(time_of(ours));
    }
    std::nth_element(a.begin(), a.begin() + 20, a.end());
    std::nth_element(b.begin(), b.begin() + 20, b.end());
    std::printf("%s\t%f\t%f\n", what, a[20], b[20]);
}

int main()
{
    using T = iit::TestHyQ::tpl::Traits<double>;
    using Spatial = T::InvDynEngine::Velocity;
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    T::MotionTransforms X;
    T::ForceTransforms F;
    T::HomogeneousTransforms H;
    T::InertiaProperties inertia;
    T::InvDynEngine inverse(inertia, X);
    T::FwdDynEngine forward(inertia, X);
    T::JSIM M(inertia, F);
    std::vector<T::JointState> q(200), v(200), a(200);
    for (int i = 0; i < 200; i++) {
        for (int k = 0; k < 12; k++) {
            q[i](k) = uniform(generator);
            v[i](k) = uniform(generator);
            a[i](k) = uniform(generator);
        }
    }
    Spatial v0 = Spatial::Random(), g6 = Spatial::Zero(), a0 = Spatial::Random(), wrench;
    g6(5) = -9.81;
    const double g[3] = {0, 0, -9.81};
    T::JointState tau, qdd;
    static double out[2000], base[6];
    const hyq_model *m = &hyq_default_model;
    const auto theirs_done = [&] { escape(tau); escape(qdd); escape(a0); escape(wrench); escape(M); escape(H); };
    const auto ours_done = [&] { escape(out); escape(base); };
    row("floating inverse dynamics",
        [&](int i) { inverse.id(tau, a0, g6, v0, q[i], v[i], a[i]); theirs_done(); },
        [&](int i) { hyq_inverse_dynamics(m, q[i].data(), v[i].data(), a[i].data(), v0.data(), g, nullptr, out, base); ours_done(); });
    row("actuated inverse dynamics",
        [&](int i) { inverse.id_fully_actuated(wrench, tau, g6, v0, a0, q[i], v[i], a[i]); theirs_done(); },
        [&](int i) { hyq_inverse_dynamics_actuated(m, q[i].data(), v[i].data(), a[i].data(), v0.data(), a0.data(), g, nullptr, out, base); ours_done(); });
    row("forward dynamics",
        [&](int i) { forward.fd(qdd, a0, v0, g6, q[i], v[i], a[i]); theirs_done(); },
        [&](int i) { hyq_forward_dynamics(m, q[i].data(), v[i].data(), a[i].data(), v0.data(), g, nullptr, out, base); ours_done(); });
    row("inertia", [&](int i) { M.update(q[i]); theirs_done(); },
        [&](int i) { hyq_joint_space_inertia(m, q[i].data(), out); ours_done(); });
    row("gravity", [&](int i) { inverse.G_terms_fully_actuated(wrench, tau, g6, q[i]); theirs_done(); },
        [&](int i) { hyq_gravity_torque(m, q[i].data(), g, out); ours_done(); });
    row("bias", [&](int i) { inverse.C_terms_fully_actuated(wrench, tau, v0, q[i], v[i]); theirs_done(); },
        [&](int i) { hyq_bias_torque(m, q[i].data(), v[i].data(), v0.data(), g, out); ours_done(); });
}
