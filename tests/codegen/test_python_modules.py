"""Modules for NumPy, JAX and CasADi, and the header for Eigen, compute what the mechanics do."""

import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from tests.codegen.compiling import COMPILERS, EIGEN, needs_compiler
from tests.codegen.robots import ALL, PLAIN, bodies_of_seed, library, reference
from tests.dynamics.random_bodies import with_drives
from tests.support.amount import usually
from tests.support.differences import worst_difference

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.language import language_named
from kindsl.products.codegen.library import Options
from kindsl.products.codegen.reference import Reference

ROOT = Path(__file__).parents[2]
# What JAX computes on arrays, and one function that it computes in straight lines.
FEW = (
    "poses", "inverse_dynamics", "inverse_dynamics_actuated", "forward_dynamics",
    "joint_space_inertia", "gravity_torque", "bias_torque", "center_of_mass",
)  # fmt: skip
NAMES = {"v0": "base_velocity", "a0": "base_acceleration", "g": "gravity"}
CORPUS = """
Robot R {
RobotBase b floating { inertia_params { mass = m CoM = (0.1, 0.0, c) Ix = 0.5 Iy = 0.6 Iz = 0.7
  Ixy = 0.0 Ixz = 0.01 Iyz = 0.0 } children { a via j } }
link a { id = 1 inertia_params { mass = 2.0 * m CoM = (l, 0.0, 0.0) Ix = 0.1 Iy = i Iz = 0.3
  Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children { d via k } frames { tip {
  translation = (l, 0.0, 0.1) rotation = (0.0, angle, 0.0) } } }
link d { id = 2 inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.1) Ix = 0.1 Iy = 0.2 Iz = 0.1
  Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children { } }
r_joint j { ref_frame { translation = (l, 0.0, 0.0) rotation = (angle, 0.0, PI/2.0) } }
p_joint k { ref_frame { translation = (0.0, 2.0 * l, 0.0) rotation = (0.0, -PI/2.0, 0.0) } }
}
"""
VALUES = {"m": 3.0, "c": -0.2, "l": 0.7, "i": 0.9, "angle": 0.4}


def _module(text: str) -> ModuleType:
    module = ModuleType("robot")
    exec(compile(text, "robot.py", "exec"), module.__dict__)
    return module


def _language(bodies, language: str, quantities: tuple[str, ...] = PLAIN) -> ModuleType:
    made = library(bodies, quantities, language=language)
    (text,) = language_named(language).files(made, reference(bodies)).values()
    return _module(text)


def _assert_right(module, made, expected: Reference, tolerance: float = 1e-12, **more) -> None:
    for function in made.all_functions:
        given = {NAMES.get(a.name, a.name): expected.values[a.name] for a in function.arguments}
        call = getattr(module, made.function_names[function.key])
        cases = [({}, expected.results(function))]
        if function.loaded is not None:
            wrenches = expected.values["fext"]
            for shape in (wrenches.shape, (*wrenches.shape[:-1], len(module.BODIES), 6)):
                load = {"external_forces": wrenches.reshape(shape)}
                cases.append((load, expected.loaded_results(function)))
        for load, answers in cases:
            found = call(**given, **load, **more)
            parts = [np.asarray(x) for x in (found if isinstance(found, tuple) else (found,))]
            assert worst_difference(parts, answers) < tolerance, function.name


@pytest.mark.parametrize("seed", range(0, 100, 9))
def test_numpy_on_random_trees(seed: int) -> None:
    bodies = bodies_of_seed(seed, 3)
    quantities = ALL if seed in (18, 27) else PLAIN
    _assert_right(
        _language(bodies, "python", quantities), library(bodies, quantities), reference(bodies)
    )


@pytest.mark.parametrize("shape", [(), (6,), (5, 6), (4, 2, 6)])
def test_forces_of_other_bodies_are_refused(shape: tuple[int, ...]) -> None:
    bodies = bodies_of_seed(3)
    module, zero = _language(bodies, "python"), np.zeros(bodies.n_links)
    with pytest.raises(ValueError, match=rf"expected \(..., {6 * bodies.n_links + 6}\)"):
        module.inverse_dynamics(zero, zero, zero, external_forces=np.zeros(shape))


def test_numpy_in_batches_and_by_name() -> None:
    bodies = bodies_of_seed(3)
    module, mechanics = _language(bodies, "python"), reference(bodies).mechanics
    generator, n = np.random.default_rng(1), bodies.n_links
    q, qd, x = (generator.uniform(-1.0, 1.0, (3, 2, n)) for _ in range(3))
    v0 = generator.uniform(-1.0, 1.0, (2, 6))
    for mine, other in zip(
        module.forward_dynamics(q, qd, x, v0), mechanics.forward_dynamics(q, qd, x, v0), strict=True
    ):
        np.testing.assert_allclose(mine, other, rtol=1e-10, atol=1e-10)
    poses = mechanics.forward_kinematics(q)
    for name, pose in module.forward_kinematics(q).items():
        np.testing.assert_allclose(pose, poses[name], rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(
            module.jacobian(q, name), mechanics.jacobian(q, name), rtol=1e-12, atol=1e-12
        )
    with pytest.raises(ValueError, match="expected"):
        module.poses(np.zeros(n + 1))
    with pytest.raises(ValueError, match="there is no link or frame 'nowhere', only "):
        module.jacobian(q, "nowhere")


def test_jax() -> None:
    """In a process of its own: JAX starts threads, and whoever forks after that is warned."""
    pytest.importorskip("jax")
    check = "from tests.codegen.test_python_modules import check_jax; check_jax()"
    # Most of the time is XLA's, which makes code that is run once; not each version has all flags.
    quick = "--xla_backend_optimization_level=0 --xla_cpu_use_fusion_emitters=false"
    for flags in (quick, ""):
        told = subprocess.run(
            [sys.executable, "-c", check],
            cwd=ROOT, env={**os.environ, "XLA_FLAGS": flags}, capture_output=True, text=True,
            check=False,
        )  # fmt: skip
        if "Unknown flag" not in told.stderr:
            break
    assert (told.returncode, told.stderr) == (0, "")


def check_jax() -> None:
    import jax

    jax.config.update("jax_enable_x64", True)
    # Two links on a fixed base, two in a row on a floating one; more links in trees of both.
    for seed, most_links in usually(((36, 3), (1, 3)), thoroughly=((4, 4), (7, 4))):
        bodies = with_drives(bodies_of_seed(seed, most_links), np.random.default_rng(seed))
        some = tuple(x for x in FEW if bodies.is_floating or not x.endswith("_actuated"))
        module = _language(bodies, "jax", some)
        _assert_right(module, library(bodies, some), reference(bodies))
    assert bodies.is_floating
    values = reference(bodies).values
    call = lambda q: module.gravity_torque(q, values["g"])  # noqa: E731
    slope = jax.jit(jax.jacfwd(call))(values["q"])
    rest = [np.zeros_like(values["qd"])] * 2
    expected = reference(bodies).mechanics.inverse_dynamics_derivatives(
        values["q"], *rest, gravity=values["g"]
    )
    np.testing.assert_allclose(slope, expected.dtau_dq[:, 6:], rtol=1e-10, atol=1e-10)
    moves = [values[name] for name in ("q", "qd", "tau", "v0", "g")]
    pulled = np.linspace(1.0, 2.0, bodies.n_links)
    moved = lambda q: pulled @ module.forward_dynamics(q, *moves[1:])[0]  # noqa: E731
    expected = reference(bodies).mechanics.forward_dynamics_derivatives(
        *moves[:4], gravity=values["g"]
    )
    np.testing.assert_allclose(
        jax.jit(jax.grad(moved))(values["q"]),
        pulled @ expected.dqdd_dq[6:, 6:],
        rtol=1e-9,
        atol=1e-9,
    )
    compiled: list[str] = []
    jax.monitoring.register_event_duration_secs_listener(
        lambda event, *_, **__: compiled.append(event)
    )
    rounds = []
    for _ in range(2):
        compiled.clear()
        module.forward_dynamics(*moves)
        jax.grad(moved)(values["q"])
        rounds.append(sum("backend_compile" in event for event in compiled))
    assert rounds[0] and not rounds[1]
    batch = np.random.default_rng(1).uniform(-1.0, 1.0, (4, bodies.n_links))
    mapped = jax.vmap(call)(batch)
    np.testing.assert_allclose(mapped, call(batch), rtol=1e-12, atol=1e-12)
    assert module.gravity_torque(np.zeros((0, bodies.n_links))).shape == (0, bodies.n_links + 6)
    jax.config.update("jax_enable_x64", False)
    tau = _language(bodies, "jax", FEW).gravity_torque(batch.astype(np.float32))
    assert tau.dtype == np.float32
    expected = reference(bodies).mechanics.gravity_torque(batch)
    np.testing.assert_allclose(tau, expected, rtol=1e-3, atol=1e-4 * abs(expected).max())


def test_casadi() -> None:
    casadi = pytest.importorskip("casadi")
    bodies = bodies_of_seed(5, 3)
    module, made, expected = (
        _language(bodies, "casadi", ALL), library(bodies, ALL), reference(bodies),
    )  # fmt: skip
    values = {k: casadi.DM(v) for k, v in expected.values.items()}
    _assert_right(module, made, Reference(expected.mechanics, expected.values))
    with pytest.raises(ValueError, match=r"an argument has shape \(99, 1\), expected \(\d+, 1\)"):
        module.poses(np.zeros(99))
    q = casadi.SX.sym("q", bodies.n_links)
    slope = casadi.Function("slope", [q], [casadi.jacobian(module.gravity_torque(q), q)])
    rest = [np.zeros(bodies.n_links)] * 2
    derivatives = expected.mechanics.inverse_dynamics_derivatives(expected.values["q"], *rest)
    np.testing.assert_allclose(
        slope(values["q"]), derivatives.dtau_dq[:, 6:], rtol=1e-10, atol=1e-10
    )
    for name, pose in expected.mechanics.forward_kinematics(expected.values["q"]).items():
        found = module.forward_kinematics(values["q"])[name]
        np.testing.assert_allclose(found, pose, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("choice", ["unbound", "l,angle", "all"])
def test_parameters_at_run_time_are_bound_ones(choice: str) -> None:
    """With values from outside the code gives what a document with these values gives."""
    from kindsl.language.semantics.parameters import Binding

    bindings = {"m": 1.0, "l": 9.0, "angle": 1.0} if choice != "unbound" else {}
    settings = Settings(bindings={name: Binding(value) for name, value in bindings.items()})
    analysis = kindsl.parse(CORPUS, settings)
    options = Options("python", ALL, "double", False, choice, "r")
    made, files = generate(Source("r.kindsl", analysis, {}), options)
    fixed = {name: x for name, x in bindings.items() if name not in made.defaults}
    values = {**VALUES, **fixed}
    mechanics = analysis.mechanism(values)
    module = _module(files["r.py"])
    given = {name: values[name] for name in made.defaults}
    _assert_right(module, made, reference(mechanics.bodies), parameters=given)
    assert set(module.PARAMETERS) == set(VALUES) - set(fixed)
    with pytest.raises(ValueError, match="no parameter"):
        module.poses(np.zeros(2), parameters={**given, "nothing": 1.0})
    if choice == "unbound":
        with pytest.raises(ValueError, match="no value for"):
            module.poses(np.zeros(2))


@needs_compiler
@pytest.mark.skipif(EIGEN is None, reason="there is no Eigen")
def test_eigen(tmp_path: Path) -> None:
    bodies = bodies_of_seed(3, 2)
    quantities = ("poses", "joint_space_inertia", "inverse_dynamics")
    made = library(bodies, quantities, language="cpp")
    for name, text in language_named("cpp").files(made, reference(bodies)).items():
        (tmp_path / name).write_text(text)
    expected, values = reference(bodies), reference(bodies).values
    tau = float(expected.loaded_results(made.functions["inverse_dynamics"][0])[0][0])
    entry = float(expected.mechanics.joint_space_inertia(values["q"])[7, 6])
    fill = "\n".join(
        f"{kind} {n}; {n} << {', '.join(map(repr, values[n].tolist()))};"
        for n, kind in (
            ("q", "robot::JointVector"), ("qd", "robot::JointVector"),
            ("qdd", "robot::JointVector"), ("v0", "robot::Vector<6>"), ("g", "robot::Vector<3>"),
        )
    )  # fmt: skip
    forces = ", ".join(map(repr, values["fext"].reshape(-1, 6).T.ravel().tolist()))
    (tmp_path / "main.cpp").write_text(
        '#include "robot.hpp"\n#include <cmath>\nint main() {\n'
        f"{fill}\nrobot::ExternalForces fext; fext << {forces};\n"
        "const robot::Model model; robot::JointVector tau; robot::Vector<6> a0;\n"
        "model.inverse_dynamics(q, qd, qdd, v0, g, tau, a0, &fext);\n"
        "const auto M = model.joint_space_inertia(q);\n"
        f"return std::fabs(tau(0) - ({tau!r})) < 1e-9 && std::fabs(M(7, 6) - "
        f"({entry!r})) < 1e-12 ? 0 : 1; }}\n"
    )
    strict = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
    compiled = [
        ["clang++" if compiler.name == "clang" else "g++", f"-std=c++{standard}", *strict,
         "-isystem", str(EIGEN), source, "-o", source[:-4]]
        for compiler, standard, source in (
            (COMPILERS[0], 14, "main.cpp"), (COMPILERS[-1], 17, "robot_test.cpp"),
        )
    ]  # fmt: skip
    steps = [*compiled, ["./main"], ["./robot_test"]]
    for step in steps:
        done = subprocess.run(step, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
