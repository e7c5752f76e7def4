"""RobCoGen's classes, called as programs call them, against the mechanics of this project."""

import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from tests.codegen.robcogen.programs import (
    COMPILERS,
    HEAD,
    QUICK,
    built,
    generated,
    needs_cpp,
    printed,
)
from tests.support.amount import usually

from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.generation.emitters import c
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import skew
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.robcogen import robot as generated_robot
from kindsl.products.codegen.robcogen import transforms
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

Case = tuple[Mechanics, Library, dict[str, Array]]

EXAMPLES = Path(__file__).parents[3] / "examples"
GRAVITY = np.array([0.3, -0.4, -9.7])

# Branches, both kinds of joints, and parameters of each class.
CRAB = """
Robot Crab {
RobotBase shell floating {
    inertia_params { mass = body CoM = (0.1, 0.0, 0.05)
        Ix=0.5 Iy=0.6 Iz=0.7 Ixy=0.0 Ixz=0.01 Iyz=0.0 }
    children { Left via L1  right via R1 }
}
link Left { id = 1
    inertia_params { mass = 1.5 CoM = (reach, 0.0, 0.1)
        Ix=0.2 Iy=0.2 Iz=spin Ixy=0.01 Ixz=twist Iyz=0.0 }
    children { claw via L2 }
}
link claw { id = 2
    inertia_params { mass = 0.5 CoM = (0.0, shift, 0.1)
        Ix=0.02 Iy=0.03 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children {}
    frames { tip { translation = (reach, 0.0, 0.1) rotation = (0.0, bend, 0.2) } }
}
link right { id = 3
    inertia_params { mass = 0.8 CoM = (0.1, 0.0, 0.0)
        Ix=0.02 Iy=0.03 Iz=0.04 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children {}
}
r_joint L1 { ref_frame { translation = (reach, 0.2, 0.0) rotation = (bend, 0.3, 0.0) } }
p_joint L2 { ref_frame { translation = (0.1, 0.0, 0.3) rotation = (PI/2.0, 0.0, bend) } }
r_joint R1 { ref_frame { translation = (0.1, -0.2, 0.0) rotation = (0.0, PI/2.0, 0.0) } }
}
"""
VALUES = {
    "body": 4.0, "reach": 0.35, "bend": 0.6, "spin": 0.1, "twist": 0.02, "shift": 0.02,
    "tool_length": 0.15,
}  # fmt: skip
ROBOTS = {
    "quadruped": (EXAMPLES / "quadruped.kindsl").read_text(),
    "arm": (EXAMPLES / "industrial_arm.kindsl").read_text(),
    "crab": CRAB,
}


CONTAINERS = """\
    T::MotionTransforms X;
    T::ForceTransforms F;
    T::HomogeneousTransforms H;
    T::Jacobians J;
    T::InertiaProperties I;
"""

MAIN = """
typedef iit::@NS@::tpl::Traits<double> T;

// In C++14 a plain std::vector puts vectors where they are not aligned for AVX.
const T::JointState& unaligned(int k, double seed)
{
    alignas(32) static double places[3][64];
    double* place = places[k] + 2;
    for (int i = 0; i < T::joints_count; i++) {
        place[i] = std::sin(seed * (i + 1));
    }
    return *reinterpret_cast<const T::JointState*>(place);
}

int main(int, char** arguments)
{
    (void)arguments;
@CONTAINERS@
    T::InvDynEngine id(I, X);
    T::FwdDynEngine fd(I, X);
    T::JSIM M(I, F);
@BEFORE@
    const T::JointState &q = unaligned(0, 1.3), &qd = unaligned(1, 0.7), &qdd = unaligned(2, 2.1);
    row("q", q); row("qd", qd); row("qdd", qdd);
    T::InvDynEngine::ExtForces fext(T::InvDynEngine::Force::Zero());
    for (int i = 0; i < T::links_count; i++) {
        fext[T::orderedLinkIDs()[i]] = numbers<T::InvDynEngine::Force>(0.4 + i);
    }
    T::JointState t;
    row("M", M(q));
    M.computeL();
    M.computeInverse();
    row("L", M.getL());
    row("inverse", M.getInverse());
    row("com", iit::@NS@::getWholeBodyCOM(I, q, H));
    row("mass", Eigen::Matrix<double, 1, 1>(I.getTotalMass()));
@BODY@
}
"""

FIXED = """
    id.id(t, q, qd, qdd); row("id", t);
    @ID_GETTERS@
    id.id(t, q, qd, qdd, fext); row("id_ext", t);
    id.G_terms(t, q); row("G", t);
    id.C_terms(t, q, qd); row("C", t);
    @C_GETTERS@
    fd.fd(t, q, qd, qdd); row("fd", t);
    fd.fd(t, q, qd, qdd, fext); row("fd_ext", t);
    const T::JointState other = numbers<T::JointState>(3.3);
    id.setJointStatus(other);
    id.id(t, qd, qdd); row("id_at_other", t);
    fd.fd(t, qd, qdd); row("fd_at_other", t);
    row("other", other);
"""

FLOATING = """
    T::InvDynEngine::Velocity v0 = numbers<T::InvDynEngine::Velocity>(0.9), a0, g, given;
    T::InvDynEngine::Force f0;
    given = numbers<T::InvDynEngine::Velocity>(1.9);
    g << 0, 0, 0, @G@;
    row("v0", v0); row("given", given);
    id.id(t, a0, g, v0, q, qd, qdd); row("id", t); row("id_a0", a0);
    @ID_GETTERS@
    id.id(t, a0, g, v0, q, qd, qdd, fext); row("id_ext", t); row("id_ext_a0", a0);
    id.id_fully_actuated(f0, t, g, v0, given, q, qd, qdd); row("ida", t); row("ida_f0", f0);
    @IDA_GETTERS@
    id.id_fully_actuated(f0, t, g, v0, given, q, qd, qdd, fext);
    row("ida_ext", t); row("ida_ext_f0", f0);
    id.G_terms_fully_actuated(f0, t, g, q); row("G", t); row("G_f0", f0);
    id.C_terms_fully_actuated(f0, t, v0, q, qd); row("C", t); row("C_f0", f0);
    fd.fd(t, a0, v0, g, q, qd, qdd); row("fd", t); row("fd_a0", a0);
    fd.fd(t, a0, v0, g, q, qd, qdd, fext); row("fd_ext", t); row("fd_ext_a0", a0);
    row("whole", M.getWholeBodyInertia()); row("MF", M.getF()); row("H", M.getFixedBaseBlock());
    const T::JointState other = numbers<T::JointState>(3.3);
    id.setJointStatus(other);
    id.id(t, a0, g, v0, qd, qdd); row("id_at_other", t);
    fd.fd(t, a0, v0, g, qd, qdd); row("fd_at_other", t);
    row("other", other);
"""


def program(library: Library, containers: str = CONTAINERS, before: str = "") -> str:
    """Return a program that prints inputs and results of everything.

    Args:
        library: The robot.
        containers: What declares the containers of transforms and inertia.
        before: What is done first.
    """
    ns, names = library.robot_name, [library.robot.base_name, *library.robot.link_names]
    g = ", ".join(map(str, GRAVITY))
    if library.robot.tree.is_floating:
        body = FLOATING.replace("@G@", g)
        first = [f'row("force_{{}}_{names[0]}", id.getForce_{names[0]}());']
    else:
        body, first = FIXED, []
    getters = first + [
        f'row("{kind.lower()}_{{}}_{name}", id.get{kind}_{name}());'
        for name in names[1:]
        for kind in ("Velocity", "Acceleration", "Force")
    ]
    told = "\n    ".join(getters)
    for call in ("id", "G", "C", "ida"):
        body = body.replace(f"@{call.upper()}_GETTERS@", told.replace("{}", call))
    inertia = "".join(
        f'    row("com_{n}", I.getCOM_{n}()); row("tensor_{n}", I.getTensor_{n}());\n'
        for n in (names if library.robot.tree.is_floating else names[1:])
    )
    pairs = library.wanted.transforms
    frames = "".join(
        f'    {c}.{b.name}_X_{t.name}(q);\n    row("{c}_{t.name}", {c}.{b.name}_X_{t.name});\n'
        for b, t in pairs
        for c in "XFH"
    ) + "".join(
        f'    row("J_{t.name}", J.{b.name}_J_{t.name}.update(q));\n'
        for b, t in library.wanted.jacobians
    )
    main = HEAD + MAIN.replace("@CONTAINERS@", containers).replace("@BEFORE@", before)
    return main.replace("@NS@", ns).replace("@BODY@", body + inertia + frames)


@pytest.fixture(scope="module", params=usually(("arm", "crab"), (*ROBOTS,)))
def case(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Case:
    """Return a robot's mechanics, its library, and what a program with its classes prints."""
    folder = tmp_path_factory.mktemp(request.param)
    with pytest.MonkeyPatch.context() as patch:
        if request.param == "crab":  # as with large robots: in parts, products, one for all loads
            patch.setattr(generated_robot, "MOST_JOINTS_OF_SMALL", 1)
            patch.setattr(transforms, "MOST_JOINTS_OF_LARGE", 1)
            patch.setattr(c, "MOST_IN_TEMPLATE", 100)
            patch.setattr(c, "OPERATIONS_PER_PART", 70)
        analysis, library = generated(ROBOTS[request.param], VALUES, folder)
    used = {name: VALUES[name] for name in library.defaults}
    compiler = COMPILERS[0] if request.param == "crab" else QUICK
    found = printed(folder, program(library), "-march=native", compiler=compiler)
    return analysis.mechanism(used), library, found


def equal(found: Array, expected: Array, tolerance: float = 1e-12) -> None:
    expected = np.asarray(expected).ravel()
    scale = max(1.0, abs(expected).max(initial=0.0))
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=tolerance * scale)


def wrenches(mechanics: Mechanics, q: Array, is_loaded: bool) -> Array:
    """Return the generalised forces of the wrenches that the program puts on links."""
    names = [mechanics.bodies.base_name, *mechanics.link_names]
    total = np.zeros(mechanics.bodies.n_velocities)
    for i, name in enumerate(names):
        wrench = np.sin((0.4 + i) * np.arange(1, 7))
        if i:
            total += mechanics.jacobian(q, name).T @ wrench
        elif mechanics.bodies.is_floating:
            total[:6] += wrench
    return total * is_loaded


@needs_cpp
def test_the_matrices(case: Case) -> None:
    mechanics, _, found = case
    q = found["q"]
    M = mechanics.joint_space_inertia(q)
    L = found["L"].reshape(M.shape)
    equal(found["M"], M)
    equal((L.T @ L).ravel(), M)
    assert not np.triu(L, 1).any()
    equal(found["inverse"], np.linalg.inv(M), 1e-10)
    equal(found["com"], mechanics.center_of_mass(q))
    equal(found["mass"], np.array([mechanics.total_mass()]))
    if mechanics.bodies.is_floating:
        equal(found["whole"], M[:6, :6])
        equal(found["MF"], M[:6, 6:])
        equal(found["H"], M[6:, 6:])


@needs_cpp
@pytest.mark.parametrize("case", ["arm"], indirect=True)
def test_dynamics_of_a_fixed_base(case: Case) -> None:
    mechanics, _, found = case
    q, qd, qdd, g = found["q"], found["qd"], found["qdd"], (0.0, 0.0, -9.81)
    for suffix in ("", "_ext"):
        carried = wrenches(mechanics, q, bool(suffix))
        equal(found[f"id{suffix}"], mechanics.inverse_dynamics(q, qd, qdd, None, g) - carried)
        tau = qdd + carried
        equal(found[f"fd{suffix}"], mechanics.forward_dynamics(q, qd, tau, None, g), 1e-11)
    equal(found["G"], mechanics.gravity_torque(q, g))
    equal(found["C"], mechanics.bias_torque(q, qd, None, (0.0, 0.0, 0.0)))
    other = found["other"]
    equal(found["id_at_other"], mechanics.inverse_dynamics(other, qd, qdd, None, g))
    equal(found["fd_at_other"], mechanics.forward_dynamics(other, qd, qdd, None, g), 1e-11)


@needs_cpp
@pytest.mark.parametrize("case", usually(["crab"], ["quadruped", "crab"]), indirect=True)
def test_dynamics_of_a_floating_base(case: Case) -> None:
    mechanics, _, found = case
    q, qd, qdd, v0, given = (found[name] for name in ("q", "qd", "qdd", "v0", "given"))
    M, bias = mechanics.joint_space_inertia(q), mechanics.bias_torque(q, qd, v0, GRAVITY)
    for suffix in ("", "_ext"):
        still = bias - wrenches(mechanics, q, bool(suffix))
        a0 = np.linalg.solve(M[:6, :6], -(M[:6, 6:] @ qdd + still[:6]))
        equal(found[f"id{suffix}_a0"], a0)
        equal(found[f"id{suffix}"], (M @ [*a0, *qdd] + still)[6:])
        driven = M @ [*given, *qdd] + still
        equal(np.array([*found[f"ida{suffix}_f0"], *found[f"ida{suffix}"]]), driven)
        moved = np.linalg.solve(M, [*np.zeros(6), *qdd] - still)
        equal(np.array([*found[f"fd{suffix}_a0"], *found[f"fd{suffix}"]]), moved, 1e-11)
    rest, none = np.zeros_like(q), np.zeros(3)
    for name, expected in (
        ("G", mechanics.bias_torque(q, rest, np.zeros(6), GRAVITY)),
        ("C", mechanics.bias_torque(q, qd, v0, none)),
    ):
        equal(np.array([*found[f"{name}_f0"], *found[name]]), expected)
    other = found["other"]
    free = mechanics.inverse_dynamics(other, qd, qdd, v0, GRAVITY)
    equal(found["id_at_other"], free.tau)
    equal(found["fd_at_other"], mechanics.forward_dynamics(other, qd, qdd, v0, GRAVITY).qdd, 1e-11)


@needs_cpp
def test_what_links_do(case: Case) -> None:
    mechanics, library, found = case
    bodies = mechanics.bodies
    q, qd, qdd = found["q"], found["qd"], found["qdd"]
    v0 = [found["v0"]] if bodies.is_floating else []
    rates = np.concatenate([*v0, qd])
    call = "ida" if bodies.is_floating else "id"
    base = found["given"] if bodies.is_floating else np.zeros(6)
    accelerations = np.array([*(base if bodies.is_floating else []), *qdd])
    up = np.array([0.0, 0.0, 0.0, *(-GRAVITY if bodies.is_floating else (0.0, 0.0, 9.81))])
    h = 1e-6
    for number, name in enumerate(mechanics.link_names):
        equal(found[f"velocity_{call}_{name}"], mechanics.jacobian(q, name) @ rates)
        later, earlier = (
            mechanics.jacobian(q + s * h * qd, name) @ (rates + s * h * accelerations)
            for s in (1.0, -1.0)
        )
        E = mechanics.forward_kinematics(q)[name][:3, :3].T
        lifted = [*(E @ up[:3]), *(E @ up[3:])]
        expected = (later - earlier) / (2 * h) + lifted
        equal(found[f"acceleration_{call}_{name}"], expected, 1e-8)
        axis = 2 if bodies.joint_kinds[number] == "revolute" else 5
        assert found[f"force_{call}_{name}"][axis] == pytest.approx(found[call][number], abs=1e-10)
    if bodies.is_floating:
        base_name = library.robot.base_name
        equal(found[f"force_ida_{base_name}"], found["ida_f0"])
        a0 = found["id_a0"] - [0.0, 0.0, 0.0, *GRAVITY]
        pose = mechanics.forward_kinematics(q)
        for name in mechanics.link_names:
            R, r = pose[name][:3, :3], pose[name][:3, 3]
            expected = [*(R.T @ a0[:3]), *(R.T @ (a0[3:] + np.cross(a0[:3], r)))]
            equal(found[f"acceleration_id_{name}"], np.array(expected))


@needs_cpp
def test_transforms_and_jacobians(case: Case) -> None:
    mechanics, library, found = case
    q = found["q"]
    poses = dict(mechanics.forward_kinematics(q).items())
    known = {f"fr_{name}": poses[name] for name in mechanics.link_names} | poses
    assert library.wanted.transforms and library.wanted.jacobians
    for _, target in library.wanted.transforms:
        T = known[target.name]
        E, coupling = T[:3, :3], skew(T[:3, 3]) @ T[:3, :3]
        zero = np.zeros((3, 3))
        equal(found[f"H_{target.name}"], T)
        equal(found[f"X_{target.name}"], np.block([[E, zero], [coupling, E]]))
        equal(found[f"F_{target.name}"], np.block([[E, coupling], [zero, E]]))
    for _, target in library.wanted.jacobians:
        name = target.name.removeprefix("fr_") if target.name not in poses else target.name
        own = mechanics.jacobian(q, name)[:, mechanics.bodies.n_velocities - len(q) :]
        R = poses[name][:3, :3]
        turned = np.vstack([R @ own[:3], R @ own[3:]])
        equal(found[f"J_{target.name}"], turned[:, abs(turned).any(axis=0)])


@needs_cpp
def test_inertia(case: Case) -> None:
    mechanics, library, found = case
    names = [library.robot.base_name, *mechanics.link_names]
    for i, name in enumerate(names):
        if f"com_{name}" in found:
            equal(found[f"com_{name}"], mechanics.bodies.coms[i])
            mass = mechanics.bodies.masses[i] * np.eye(3)
            first = skew(mass @ mechanics.bodies.coms[i])
            tensor = np.block([[mechanics.bodies.inertias[i], first], [first.T, mass]])
            equal(found[f"tensor_{name}"], tensor)


@needs_cpp
@pytest.mark.parametrize("compiler", COMPILERS)
def test_no_compiler_warns(compiler: str, tmp_path: Path) -> None:
    robot = "crab" if compiler == COMPILERS[0] else "arm"
    _, library = generated(ROBOTS[robot], VALUES, tmp_path)
    options = ("-std=c++17", "-Wconversion", "-Wno-sign-conversion", "-fsyntax-only")
    done = built(tmp_path, program(library), *options, compiler=compiler)
    assert (done.returncode, done.stderr) == (0, "")


@needs_cpp
def test_names_that_headers_and_classes_have_are_changed_and_told(tmp_path: Path) -> None:
    names = {"Crab": "Eigen", "Left": "union", "claw": "null", "right": "scalar", "L1": "UNION",
             "L2": "m_pi", "tip": "operator", "reach": "INFINITY", "bend": "defaults",
             "spin": "math_errhandling", "twist": "RuntimeInertiaParams"}  # fmt: skip
    text = re.sub(r"\w+", lambda word: names.get(word[0], word[0]), CRAB)
    values = {names.get(name, name): value for name, value in VALUES.items()}
    _, library = generated(text, values, tmp_path, layout="robcogen-0.5")
    assert GeneratedRobot(library).renamed == {
        "Eigen": "Eigen_", "union": "UNION_2", "null": "NULL_", "scalar": "SCALAR_2",
        "m_pi": "M_PI_", "operator": "operator_", "INFINITY": "INFINITY_",
        "defaults": "defaults_", "math_errhandling": "math_errhandling_",
    }  # fmt: skip
    whole = "".join(
        f"template class iit::Eigen_::{name}<iit::rbd::DoubleTrait>;\n"
        for name in (
            "tpl::MotionTransforms", "tpl::HomogeneousTransforms", "tpl::Jacobians",
            "dyn::tpl::InertiaProperties", "dyn::tpl::InverseDynamics", "dyn::tpl::ForwardDynamics",
            "dyn::tpl::JSIM",
        )
    )  # fmt: skip
    done = built(tmp_path, HEAD + whole, "-std=c++14", "-fsyntax-only")
    assert (done.returncode, done.stderr) == (0, "")


@needs_cpp
@pytest.mark.parametrize("compiler", usually(COMPILERS[:1], COMPILERS))
def test_vectors_that_are_not_aligned_are_read(compiler: str, tmp_path: Path) -> None:
    mass = "mass = 1.0 CoM = (0.1, 0.0, 0.0) Ix=0.1 Iy=0.1 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0"
    body, place = f"inertia_params {{ {mass} }}", "translation = (0.3, 0.0, 0.1)"
    text = f"Robot Four {{ RobotBase base floating {{ {body} children {{ l1 via j1 }} }}\n"
    for i in range(1, 5):
        children = f"l{i + 1} via j{i + 1}" if i < 4 else ""
        text += f"link l{i} {{ id = {i} {body} children {{ {children} }} }}\n"
        text += f"r_joint j{i} {{ ref_frame {{ {place} rotation = (0.4, 0.0, 0.0) }} }}\n"
    generated(f"{text}}}\n", {}, tmp_path)
    source = """
typedef iit::Four::tpl::Traits<double> T;
typedef T::InvDynEngine::Velocity Velocity;

__attribute__((noinline)) void call(
    T::InvDynEngine& id, T::JointState& tau, const T::JointState& q, const T::JointState& qd)
{
    Velocity v0 = numbers<Velocity>(0.9), a0;
    id.id(tau, a0, v0, v0, q, qd, qd);
}

int main()
{
    alignas(32) static double places[14] = {};
    T::JointState* v = reinterpret_cast<T::JointState*>(places + 2);
    T::MotionTransforms X;
    T::InertiaProperties I;
    T::InvDynEngine id(I, X);
    Eigen::Map<T::JointState>(places + 2).setConstant(0.1);
    call(id, v[1], v[0], v[2]);
    std::printf("force %.17g\\n", id.getForce_l4()(0));
}
"""
    done = built(tmp_path, HEAD + source, "-std=c++14", "-O2", "-march=native", compiler=compiler)
    assert (done.returncode, done.stderr) == (0, "")
    subprocess.run([tmp_path / "main"], check=True, timeout=60)


@needs_cpp
def test_what_there_is_not_is_said_when_it_is_called(tmp_path: Path) -> None:
    generated(ROBOTS["arm"], VALUES, tmp_path)
    text = """
struct Own : iit::UR5eLike::dyn::InverseDynamics {
    void call(JointState& t) { secondPass(t); }
};
void call(Own& own, Own::JointState& t) { own.call(t); }
"""
    done = built(tmp_path, HEAD + text, "-std=c++14", "-fsyntax-only")
    assert done.returncode != 0
    assert "there are no passes to call" in done.stderr


@needs_cpp
def test_the_guide_closes_its_loop(tmp_path: Path) -> None:
    guide = EXAMPLES.parent / "docs" / "guide"
    generated((guide / "crane.kindsl").read_text(), {}, tmp_path)
    source = (guide / "control.cpp").read_text()
    done = built(tmp_path, source, "-std=c++14", compiler=COMPILERS[0])
    assert (done.returncode, done.stderr) == (0, "")
    told = subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=False)
    assert told.stdout == "the crane is where it should be\n"
