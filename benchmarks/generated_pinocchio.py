"""Generated C against pinocchio in C++, function by function, robot by robot.

    python benchmarks/generated_pinocchio.py [--robots NAME ...] [--rounds N]

pinocchio is that of the wheel `pin`, which has headers and libraries: models are built here and
read by a program in C++. All is compiled with `-O2`, without instructions of this processor alone,
and called in turns. Prints the text and the compiler's seconds, then microseconds of the processor
for one call, the least of the rounds, and how many times faster generated code is. Joints are
revolute; results are compared first.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import pinocchio as pin
from benchmarks.dynamics_models import arm, chain, quadruped
from tests.codegen.robots import write_c
from tests.dynamics.pinocchio_model import PinocchioModel
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.bodies import Bodies

INCLUDE = Path(pin.__file__).parents[4] / "include"
LIBRARIES = INCLUDE.parent / "lib"
QUANTITIES = (
    "inverse_dynamics", "inverse_dynamics_actuated", "forward_dynamics", "joint_space_inertia",
    "inverse_dynamics_derivatives", "forward_dynamics_derivatives",
)  # fmt: skip
# pinocchio's side, compiled once.
THEIRS = r"""
#include <pinocchio/multibody.hpp>
#include <pinocchio/serialization.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/aba-derivatives.hpp>

static pinocchio::Model model;
static pinocchio::Data data;
static Eigen::VectorXd q, v, a, tau;

extern "C" void load(int n, const double *values)
{
    model.loadFromText("model.txt");
    data = pinocchio::Data(model);
    q = Eigen::Map<const Eigen::VectorXd>(values, model.nq);
    v = Eigen::Map<const Eigen::VectorXd>(values + model.nq, model.nv);
    a = Eigen::Map<const Eigen::VectorXd>(values + model.nq + model.nv, model.nv);
    tau = a;
    tau.head(model.nv - n).setZero();
}

extern "C" void theirs(int which)
{
    switch (which) {
    case 0: pinocchio::rnea(model, data, q, v, a); break;
    case 1: pinocchio::aba(model, data, q, v, tau); break;
    case 2: pinocchio::crba(model, data, q); break;
    case 3: pinocchio::computeRNEADerivatives(model, data, q, v, a); break;
    default: pinocchio::computeABADerivatives(model, data, q, v, tau);
    }
}

/* The greatest entry of joints, which does not depend on the order of coordinates. */
extern "C" double greatest(int which, int n)
{
    switch (which) {
    case 0: return data.tau.tail(n).cwiseAbs().maxCoeff();
    case 1: return data.ddq.tail(n).cwiseAbs().maxCoeff();
    case 2: return data.M.bottomRightCorner(n, n).cwiseAbs().maxCoeff();
    case 3: return data.dtau_dq.bottomRightCorner(n, n).cwiseAbs().maxCoeff();
    default: return data.ddq_dq.bottomRightCorner(n, n).cwiseAbs().maxCoeff();
    }
}
"""
OURS = r"""
#define _POSIX_C_SOURCE 199309L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "robot.h"

void load(int n, const double *values);
void theirs(int which);
double greatest(int which, int n);

static const double VALUES[] = {@VALUES@};
static const double *q = VALUES, *qd = VALUES + ROBOT_NJ, *qdd = VALUES + 2 * ROBOT_NJ;
static const double *v0 = VALUES + 3 * ROBOT_NJ, *a0 = VALUES + 3 * ROBOT_NJ + 6;
static const double g[3] = {0.0, 0.0, -9.81};
static double tau[ROBOT_NV], f0[6], x[ROBOT_NV * ROBOT_NV], y[ROBOT_NV * ROBOT_NV];
static double z[ROBOT_NV * ROBOT_NV];
static robot_model m;

static void ours(int which)
{
    switch (which) {
    case 0: INVERSE; break;
    case 1: FORWARD; break;
    case 2: robot_joint_space_inertia(&m, q, x); break;
    case 3: DINVERSE; break;
    default: DFORWARD;
    }
}

static double own_greatest(int which)
{
    double found = 0.0;
    for (int i = ROBOT_NV - ROBOT_NJ; i < ROBOT_NV; i++) {
        for (int j = ROBOT_NV - ROBOT_NJ; j < ROBOT_NV; j++) {
            const double entry = which < 2 ? tau[i - ROBOT_NV + ROBOT_NJ] : x[ROBOT_NV * i + j];
            found = fmax(found, fabs(entry));
        }
    }
    return found;
}

static double seconds(void (*call)(int), int which, int n)
{
    struct timespec a, b;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &a);
    for (int i = 0; i < n; i++) {
        call(which);
    }
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &b);
    return (double)(b.tv_sec - a.tv_sec) + 1e-9 * (double)(b.tv_nsec - a.tv_nsec);
}

int main(int argc, char **argv)
{
    const char *names[] = {"ID", "FD", "M", "dID", "dFD"};
    const robot_parameters parameters = robot_default_parameters();
    robot_model_init(&m, &parameters);
    load(ROBOT_NJ, VALUES + 3 * ROBOT_NJ + 12);
    (void)v0, (void)a0, (void)f0, (void)argc;
    for (int k = 0; k < 5; k++) {
        double mine = 1e9, other = 1e9;
        ours(k);
        theirs(k);
        const double found = own_greatest(k), right = greatest(k, ROBOT_NJ);
        if (fabs(found - right) > 1e-8 * right) {
            printf("%s: %.12g is not %.12g\n", names[k], found, right);
            return 1;
        }
        const int repeat = 1 + (int)(2e-3 / seconds(theirs, k, 1));
        for (int i = 0; i < atoi(argv[1]); i++) {
            mine = fmin(mine, seconds(ours, k, repeat) / repeat);
            other = fmin(other, seconds(theirs, k, repeat) / repeat);
        }
        printf("  %-4s %8.2f us, pinocchio %8.2f us: %4.1f x\n", names[k], 1e6 * mine,
               1e6 * other, other / mine);
    }
    return 0;
}
"""
CALLS = {
    "DINVERSE": "robot_inverse_dynamics_derivatives(&m, q, qd, qdd, {v0}{a0}g, x, y, z)",
    "DFORWARD": "robot_forward_dynamics_derivatives(&m, q, qd, qdd, {v0}g, x, y, z)",
    "INVERSE": "robot_inverse_dynamics{actuated}(&m, q, qd, qdd, {v0}{a0}g, NULL, tau{f0})",
    "FORWARD": "robot_forward_dynamics(&m, q, qd, qdd, {v0}g, NULL, tau{f0})",
}


def humanoid() -> Bodies:
    """Return a floating tree of 38 revolute joints, of which most are in long limbs."""
    bodies = random_bodies(np.random.default_rng(5), 38, is_floating=True)
    return replace(bodies, joint_kinds=("revolute",) * 38, frames=())


ROBOTS = {
    "arm-7": arm, "quadruped-6+12": quadruped, "humanoid-6+38": humanoid,
    "chain-30": lambda: chain(30), "chain-60": lambda: chain(60), "chain-100": lambda: chain(100),
}  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--robots", nargs="*", choices=ROBOTS, default=list(ROBOTS))
    parser.add_argument("--rounds", type=int, default=40)
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        other = _theirs(Path(temporary))
        for name in args.robots:
            place = Path(temporary, name)
            place.mkdir()
            print(name)
            _compared(ROBOTS[name](), place, args.rounds, other)


def _theirs(place: Path) -> Path:
    (place / "theirs.cpp").write_text(THEIRS, encoding="utf-8")
    command = ["g++", "-std=c++17", "-O2", "-DNDEBUG", "-w"]
    command += [f"-I{INCLUDE}", f"-I{INCLUDE / 'eigen3'}"]
    # As pinocchio itself is compiled: its variant of joints has more kinds than Boost's lists.
    command += ["-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS"]
    command += ["-DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION", "-c", "theirs.cpp"]
    subprocess.run(command, cwd=place, check=True)
    return place / "theirs.o"


def _compared(bodies: Bodies, place: Path, rounds: int, other: Path) -> None:
    is_floating = bodies.is_floating
    write_c(bodies, place, tuple(q for q in QUANTITIES if is_floating or "actuated" not in q))
    model = PinocchioModel(bodies, np.array([0.0, 0.0, -9.81]))
    model.model.saveToText(str(place / "model.txt"))
    generator = np.random.default_rng(1)
    q, qd, qdd = (generator.uniform(-1.0, 1.0, bodies.n_links) for _ in range(3))
    v0, a0 = (generator.uniform(-1.0, 1.0, 6) * is_floating for _ in range(2))
    values = (q, qd, qdd, v0, a0, model.q_of(q), model.v_of(v0, qd), model.v_of(a0, qdd))
    numbers = ", ".join(repr(float(x)) for vector in values for x in vector)
    parts = {"v0": "v0, ", "a0": "a0, ", "f0": ", f0", "actuated": "_actuated"}
    program = OURS.replace("@VALUES@", numbers)
    for macro, call in CALLS.items():
        given = {name: text if is_floating else "" for name, text in parts.items()}
        program = program.replace(f": {macro};", f": {call.format(**given)};")
    sources = sorted(p.name for p in place.glob("*.c") if not p.name.endswith("_test.c"))
    size = sum((place / source).stat().st_size for source in sources)
    before = os.times()
    subprocess.run(["cc", "-std=c11", "-O2", "-c", *sources], cwd=place, check=True)
    spent = os.times().children_user - before.children_user
    (place / "main.c").write_text(program, encoding="utf-8")
    subprocess.run(["cc", "-std=c11", "-O2", "-c", "main.c"], cwd=place, check=True)
    objects = [source.replace(".c", ".o") for source in (*sources, "main.c")]
    command = ["g++", *objects, str(other), f"-L{LIBRARIES}", f"-Wl,-rpath,{LIBRARIES}"]
    command += ["-lpinocchio_default", "-lboost_serialization", "-o", "main"]
    subprocess.run(command, cwd=place, check=True)
    print(f"  text {size / 1e6:.2f} MB, cc -O2 {spent:.1f} s", flush=True)
    subprocess.run(["./main", str(rounds)], cwd=place, check=True)


if __name__ == "__main__":
    main()
