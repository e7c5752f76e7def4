"""Types of automatic differentiation go through generated C++."""

import sys
from pathlib import Path

import numpy as np
import pytest
from tests.codegen.robcogen.programs import HEAD, generated, needs_cpp, printed
from tests.codegen.robcogen.test_classes import ROBOTS, VALUES

INCLUDES = (Path("/usr/include"), *(Path(p, "cmeel.prefix", "include") for p in sys.path if p))
CPPAD = next((folder for folder in INCLUDES if (folder / "cppad/cppad.hpp").is_file()), None)
needs_cppad = pytest.mark.skipif(CPPAD is None, reason="there is no CppAD")

# CppAD's compiled part, which nothing here needs.
ARM = """
namespace CppAD {
namespace local {
std::string temp_file() { return ""; }
}
}

int main()
{
    typedef CppAD::AD<double> AD;
    typedef iit::UR5eLike::tpl::Traits<AD> T;
    Eigen::Matrix<AD, Eigen::Dynamic, 1> x(18), y(30);
    for (int i = 0; i < 18; i++) {
        x(i) = std::sin(0.7 * (i + 1));
        std::printf("%s%.17g", i == 0 ? "x " : " ", std::sin(0.7 * (i + 1)));
    }
    std::puts("");
    CppAD::Independent(x);
    T::MotionTransforms X;
    T::ForceTransforms F;
    T::InertiaProperties I;
    T::InvDynEngine id(I, X);
    T::FwdDynEngine fd(I, X);
    T::JSIM M(I, F);
    const T::JointState q = x.head<6>(), qd = x.segment<6>(6), qdd = x.tail<6>();
    T::JointState tau, acceleration;
    id.id(tau, q, qd, qdd);
    y.head<6>() = tau;
    fd.fd(acceleration, q, qd, qdd);
    y.segment<6>(6) = acceleration;
    M.update(q);
    M.computeL();
    M.computeInverse();
    y.segment<6>(12) = M.getInverse() * qd;
    y.segment<6>(18) = id.getForce_wrist_3_link();
    const ur5elike::BasicModel<AD> model;
    const AD g[] = {0.0, 0.0, -9.81};
    model.inverse_dynamics(q.data(), qd.data(), qdd.data(), g, nullptr, y.data() + 24);
    CppAD::ADFun<double> function(x, y);
    std::vector<double> at(18);
    for (int i = 0; i < 18; i++) {
        at[i] = std::sin(0.7 * (i + 1));
    }
    const std::vector<double> J = function.Jacobian(at);
    row("J", Eigen::Map<const Eigen::Matrix<double, 30, 18, Eigen::RowMajor>>(J.data()));
}
"""


@needs_cpp
@needs_cppad
def test_cppad_differentiates_dynamics(tmp_path: Path) -> None:
    analysis, library = generated(ROBOTS["arm"], VALUES, tmp_path)
    generated(ROBOTS["arm"], VALUES, tmp_path, language="cpp")
    headers = ("<cppad/cppad.hpp>", "<cppad/example/cppad_eigen.hpp>", '"ur5elike.hpp"')
    include = "".join(f"#include {name}\n" for name in headers)
    found = printed(tmp_path, include + HEAD + ARM, "-isystem", str(CPPAD))
    J, (q, qd, qdd) = found["J"].reshape(30, 18), found["x"].reshape(3, 6)
    mechanics = analysis.mechanism({name: VALUES[name] for name in library.defaults})
    inverse = mechanics.inverse_dynamics_derivatives(q, qd, qdd)
    M = mechanics.joint_space_inertia(q)
    expected = np.hstack([inverse.dtau_dq, inverse.dtau_dqd, M])
    np.testing.assert_allclose(J[:6], expected, rtol=0, atol=1e-12 * abs(expected).max())
    np.testing.assert_allclose(J[24:], expected, rtol=0, atol=1e-12 * abs(expected).max())
    forward = mechanics.forward_dynamics_derivatives(q, qd, qdd)
    expected = np.hstack([forward.dqdd_dq, forward.dqdd_dqd, np.linalg.inv(M)])
    np.testing.assert_allclose(J[6:12], expected, rtol=0, atol=1e-12 * abs(expected).max())
    np.testing.assert_allclose(J[12:18, 6:12], np.linalg.inv(M), rtol=0, atol=1e-11)
    # The last joint takes a component of its link's wrench.
    np.testing.assert_allclose(J[20], J[5], rtol=0, atol=1e-12 * abs(J[5]).max())
