"""Programs that were written for RobCoGen 0.5 find all its names in `NAME::rcg`."""

from pathlib import Path

import numpy as np
from tests.codegen.robcogen.programs import built, generated, needs_cpp, told
from tests.codegen.robcogen.test_classes import CRAB, GRAVITY, VALUES, equal

PROGRAM = """\
#include "forward_dynamics.h"
#include "inverse_dynamics.h"
#include "jacobians.h"
#include "jsim.h"
#include "traits.h"
#include "miscellaneous.h"

#include <cstdio>

class Model {
public:
    typedef Crab::rcg::Scalar Scalar;
    static constexpr int states = 6 + Crab::rcg::JointSpaceDimension;

    Model() : inverse(inertia, motions), forward(inertia, motions), M(inertia, forces) {}

    Eigen::Matrix<Scalar, states, 1> bias(
        const Crab::rcg::JointState& q, const Crab::rcg::JointState& qd,
        const Crab::rcg::Velocity& v)
    {
        using namespace Crab::rcg;
        Force base;
        JointState joints;
        Acceleration gravity = Acceleration::Zero();
        gravity.tail<3>() << 0.3, -0.4, -9.7;
        inverse.id_fully_actuated(
            base, joints, gravity, v, Acceleration::Zero(), q, qd, JointState::Zero());
        Eigen::Matrix<Scalar, states, 1> all;
        all << base, joints;
        return all;
    }

    Crab::rcg::Matrix66 whole(const Crab::rcg::JointState& q)
    {
        M.update(q);
        const Crab::rcg::InertiaMatrix& I = M.getWholeBodyInertia();
        return I;
    }

private:
    Crab::rcg::InertiaProperties inertia;
    Crab::rcg::MotionTransforms motions;
    Crab::rcg::ForceTransforms forces;
    Crab::rcg::HomogeneousTransforms poses;
    Crab::rcg::Jacobians jacobians;
    Crab::rcg::InverseDynamics inverse;
    Crab::rcg::ForwardDynamics forward;
    Crab::rcg::JSIM M;
};

template <class V>
void row(const char* name, const V& v)
{
    std::printf("%s", name);
    for (int i = 0; i < v.size(); i++) {
        std::printf(" %.17g", static_cast<double>(v.data()[i]));
    }
    std::puts("");
}

int main()
{
    typedef Crab::rcg::Traits Robot;
    Robot::JointState q, qd;
    q << 0.3, -0.2, 0.8;
    qd << 1.0, 0.5, -0.7;
    Crab::rcg::Velocity v;
    v << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
    Crab::rcg::LinkDataMap<Crab::rcg::Force> loads(Crab::rcg::Force::Zero());
    Crab::rcg::Vector3 force = iit::rbd::linearPart(loads[Crab::rcg::CLAW]);
    const Crab::rcg::LinkIdentifiers first = Robot::orderedLinkIDs()[0];
    Model model;
    row("bias", model.bias(q, qd, v));
    row("whole", model.whole(q));
    return first == Crab::rcg::SHELL && force.isZero() && Robot::links_count == 4
            && Robot::ScalarTraits::cos(Crab::rcg::Scalar(0)) == 1.0 && Crab::rcg::g == 9.81
        ? 0 : 1;
}
"""


@needs_cpp
def test_a_program_for_0_5_runs_as_it_is(tmp_path: Path) -> None:
    analysis, library = generated(CRAB, VALUES, tmp_path, layout="robcogen-0.5", has_runtime=False)
    done = built(tmp_path, PROGRAM, "-std=c++14")
    assert (done.returncode, done.stderr) == (0, "")
    found = told(tmp_path)
    mechanics = analysis.mechanism({name: VALUES[name] for name in library.defaults})
    q, qd, v = np.array([0.3, -0.2, 0.8]), np.array([1.0, 0.5, -0.7]), np.arange(1, 7) / 10
    equal(found["bias"], mechanics.bias_torque(q, qd, v, GRAVITY))
    equal(found["whole"], mechanics.joint_space_inertia(q)[:6, :6])
    missing = built(tmp_path, '#include "model_constants.h"\n', "-fsyntax-only")
    assert "change the document and generate again" in missing.stderr
