"""Compiled mechanics answer what the others do, whatever they are given."""

import inspect
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.cli.samples import GOOD
from tests.codegen.compiling import needs_compiler, quickly_compiled  # noqa: F401
from tests.codegen.robots import bodies_of_seed

import kindsl
from kindsl.mechanics.dynamics.evaluation.compiled import METHODS, CompiledMechanics
from kindsl.mechanics.dynamics.evaluation.compiling import CompileError
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.quantities import SingularInertiaError

pytestmark = needs_compiler
EXTREMES = (0.0, 1e-308, 1e4, 1e6, 1e12, 1e300, np.inf, np.nan)


@pytest.fixture(scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which each test finds what those before it compiled."""
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(params=[4, 1], ids=["fixed", "floating"])
def pair(
    request: pytest.FixtureRequest, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> tuple[CompiledMechanics, Mechanics]:
    """A mechanism, compiled and not."""
    monkeypatch.setenv("KINDSL_CACHE", str(cache))
    mechanics = Mechanics(bodies_of_seed(request.param, 3))
    return CompiledMechanics(mechanics.bodies), mechanics


def calls(n: int, is_floating: bool, shape: tuple[int, ...] = (), reach: float = 3.0):
    """Yield names of methods and arguments."""
    generator = np.random.default_rng(n)
    q, qd, qdd = (generator.uniform(-reach, reach, (*shape, n)) for _ in range(3))
    v0, a0 = (generator.uniform(-1.0, 1.0, (*shape, 6)) for _ in range(2))
    base, moving = ((v0,), (v0, a0)) if is_floating else ((None,), (None, None))
    g = np.array([0.3, -0.2, -9.7])
    yield "joint_space_inertia", (q,)
    yield "center_of_mass", (q,)
    yield "center_of_mass_jacobian", (q,)
    yield "gravity_torque", (q,)
    yield "gravity_torque", (q, g)
    yield "potential_energy", (q, g)
    yield "kinetic_energy", (q, qd, *base)
    for name in ("inverse_dynamics", "forward_dynamics"):
        yield name, (q, qd, qdd)
        yield name, (q, qd, qdd, *base, g)
    yield "bias_torque", (q, qd, *base, g)
    yield "inverse_dynamics_derivatives", (q, qd, qdd, *moving, g)
    yield "forward_dynamics_derivatives", (q, qd, qdd, *base, g)
    yield "regressor", (q, qd, qdd, *moving, g)
    yield "centroidal_momentum_matrix", (q,)
    yield "centroidal_momentum_drift", (q, qd, *base)
    yield "joint_space_inertia_inverse", (q,)
    yield "coriolis_matrix", (q, qd, *base)
    for frame in ("link1", "frame0"):
        yield "frame_velocity", (q, qd, frame, *base)
        yield "frame_acceleration", (q, qd, qdd, frame, *moving)
        yield "frame_acceleration_drift", (q, qd, frame, *base)


def assert_same(found: object, expected: object, tolerance: float = 1e-12) -> None:
    assert type(found) is type(expected)
    parts = zip(found, expected, strict=True) if isinstance(found, tuple) else [(found, expected)]
    for mine, other in parts:
        assert mine.shape == other.shape
        scale = max(1.0, float(np.max(abs(other))))
        np.testing.assert_allclose(mine, other, rtol=0.0, atol=tolerance * scale)


@pytest.mark.parametrize("shape", [(), (1,), (11,), (2, 3), (0,)], ids=str)
def test_answers_of_any_shape(
    pair: tuple[CompiledMechanics, Mechanics], shape: tuple[int, ...]
) -> None:
    compiled, mechanics = pair
    for name, arguments in calls(compiled.n_joints, compiled.bodies.is_floating, shape):
        if shape == (0,):
            assert getattr(compiled, name)(*arguments) is not None
            continue
        found = getattr(compiled, name)(*arguments)
        assert_same(found, getattr(mechanics, name)(*arguments), 1e-11)


@pytest.mark.parametrize("shape", [(), (7,), (2, 3)], ids=str)
def test_poses_and_jacobians(
    pair: tuple[CompiledMechanics, Mechanics], shape: tuple[int, ...]
) -> None:
    compiled, mechanics = pair
    q = np.random.default_rng(1).uniform(-3.0, 3.0, (*shape, compiled.n_joints))
    poses, expected = compiled.forward_kinematics(q), mechanics.forward_kinematics(q)
    assert list(poses) == list(expected)
    for name in expected:
        assert_same(poses[name], expected[name])
    for name in (*expected, compiled.bodies.base_name):
        assert_same(compiled.jacobian(q, name), mechanics.jacobian(q, name))
    with pytest.raises(ValueError, match="there is no link or frame 'nothing'"):
        compiled.jacobian(q, "nothing")


def test_large_angles_are_as_exact_as_the_library(
    pair: tuple[CompiledMechanics, Mechanics],
) -> None:
    compiled, mechanics = pair
    for reach in (1e4, 1e6, 1e12):
        arguments = next(calls(compiled.n_joints, False, (64,), reach))[1]
        found = compiled.joint_space_inertia(*arguments)
        single = np.stack([mechanics.joint_space_inertia(row) for row in arguments[0]])
        np.testing.assert_allclose(found, single, rtol=1e-11, atol=1e-11 * abs(single).max())


def test_results_go_where_they_are_wanted(pair: tuple[CompiledMechanics, Mechanics]) -> None:
    compiled, mechanics = pair
    for shape in ((), (5,), (2, 2)):
        q = np.full((*shape, compiled.n_joints), 0.3)
        out = np.empty((*shape, *(compiled.bodies.n_velocities,) * 2))
        assert compiled.joint_space_inertia(q, out=out) is out
        assert_same(out, mechanics.joint_space_inertia(q))
    with pytest.raises(ValueError, match=r"'out' has shape \(3,\), expected \(2, 2, "):
        compiled.joint_space_inertia(q, out=np.empty(3))
    q, torque = [0.3] * compiled.n_joints, np.empty(compiled.bodies.n_velocities)
    assert compiled.gravity_torque(q, out=torque) is torque
    assert_same(torque, mechanics.gravity_torque(q))


def test_several_results_go_where_they_are_wanted(
    pair: tuple[CompiledMechanics, Mechanics],
) -> None:
    """Also where Python answers: for lists, and for batches of several dimensions."""
    compiled, mechanics = pair
    n, nv = compiled.n_joints, compiled.bodies.n_velocities
    if compiled.bodies.is_floating:
        for q in ([0.3] * n, np.full((2, 2, n), 0.3)):
            expected = mechanics.inverse_dynamics(q, q, q)
            out = tuple(np.empty_like(part) for part in expected)
            assert compiled.inverse_dynamics(q, q, q, out=out) is out
            for mine, other in zip(out, expected, strict=True):
                assert_same(mine, other)
            with pytest.raises(ValueError, match=r"'out' has shape \(3,\), expected "):
                compiled.inverse_dynamics(q, q, q, out=(out[0], np.empty(3)))
    q = [0.3] * n
    triple = tuple(np.empty((nv, nv)) for _ in range(3))
    assert compiled.inverse_dynamics_derivatives(q, q, q, out=triple) is triple
    for mine, other in zip(triple, mechanics.inverse_dynamics_derivatives(q, q, q), strict=True):
        assert_same(mine, other)


def test_results_that_no_cache_holds(pair: tuple[CompiledMechanics, Mechanics]) -> None:
    """They are written another way, also to places between the borders of registers."""
    compiled, _ = pair
    size, nv = 7001, compiled.bodies.n_velocities
    q = np.random.default_rng(6).uniform(-3.0, 3.0, (size, compiled.n_joints))
    q[::1000, 0] = 1e6
    out = np.empty(size * nv**2 + 1)[1:].reshape((size, nv, nv))
    assert compiled.joint_space_inertia(q, out=out) is out
    for some in (slice(0, 90), slice(3000, 3100), slice(-90, None)):
        np.testing.assert_array_equal(out[some], compiled.joint_space_inertia(q[some]))


def test_lists_strides_and_keywords_are_taken(pair: tuple[CompiledMechanics, Mechanics]) -> None:
    compiled, mechanics = pair
    n = compiled.n_joints
    wide = np.random.default_rng(4).uniform(-1.0, 1.0, (2 * n, 6)).T
    for q in ([0.1] * n, wide[0, ::2], wide[:, :n], wide[:, :n].astype(np.float32)):
        found = compiled.inverse_dynamics(q=q, qdd=q, qd=q, gravity=(0.0, 0.0, -1.0))
        expected = mechanics.inverse_dynamics(q, q, q, gravity=(0.0, 0.0, -1.0))
        tolerance = 1e-6 if getattr(q, "dtype", None) == np.float32 else 1e-11
        assert_same(found, expected, tolerance)


def test_wrong_arguments_are_named(pair: tuple[CompiledMechanics, Mechanics]) -> None:
    compiled, _ = pair
    q = np.zeros(compiled.n_joints)
    with pytest.raises(ValueError, match=r"'qd' has shape \(1,\)"):
        compiled.inverse_dynamics(q, np.zeros(1), q)
    with pytest.raises(ValueError, match="'q' holds a value that is not finite"):
        compiled.joint_space_inertia(np.full(compiled.n_joints, np.nan))
    with pytest.raises(ValueError, match="'q' holds something that is not a real number"):
        compiled.joint_space_inertia("q")
    with pytest.raises(TypeError):
        compiled.inverse_dynamics(q, q)
    if not compiled.bodies.is_floating:
        with pytest.raises(ValueError, match="the base is fixed"):
            compiled.inverse_dynamics(q, q, q, np.zeros(6))


def test_extreme_values(pair: tuple[CompiledMechanics, Mechanics]) -> None:
    """The same numbers, or a clear error where nothing finite comes out."""
    compiled, mechanics = pair
    generator, n = np.random.default_rng(5), compiled.n_joints
    for _ in range(60):
        q, qd, qdd = generator.choice(EXTREMES, (3, n))
        try:
            expected = np.concatenate(np.atleast_2d(mechanics.inverse_dynamics(q, qd, qdd)[0]))
        except ValueError:
            expected = np.array([np.nan])
        try:
            found = np.concatenate(np.atleast_2d(compiled.inverse_dynamics(q, qd, qdd)[0]))
        except ValueError:
            assert not np.isfinite(expected).all()
            continue
        np.testing.assert_allclose(found, expected, rtol=1e-9)


def test_threads_change_nothing(pair: tuple[CompiledMechanics, Mechanics]) -> None:
    compiled, _ = pair
    threaded = CompiledMechanics(compiled.bodies, threads=2)
    for name, arguments in calls(compiled.n_joints, compiled.bodies.is_floating, (1003,)):
        assert_same(getattr(threaded, name)(*arguments), getattr(compiled, name)(*arguments))


@pytest.mark.usefixtures("quickly_compiled")
def test_documents_are_compiled() -> None:
    mechanism = kindsl.parse(GOOD).mechanism()
    compiled = mechanism.compiled()
    assert_same(compiled.gravity_torque([0.1, 0.2]), mechanism.gravity_torque([0.1, 0.2]))


def test_a_second_time_nothing_is_compiled(
    pair: tuple[CompiledMechanics, Mechanics], monkeypatch: pytest.MonkeyPatch
) -> None:
    q = np.zeros(pair[1].n_joints)
    first = pair[0].gravity_torque(q)
    monkeypatch.setattr("kindsl.mechanics.dynamics.evaluation.compiling._compile", None)
    again = CompiledMechanics(pair[1].bodies)
    np.testing.assert_array_equal(again.gravity_torque(q), first)


@pytest.mark.usefixtures("quickly_compiled")
@pytest.mark.parametrize(("name", "n_arguments"), [("regressor", 3), ("bias_torque", 2)])
def test_other_groups_are_compiled_once(
    name: str, n_arguments: int, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Also when the method was taken before it was compiled."""
    compiled = CompiledMechanics(bodies_of_seed(4, 2))
    assert len(list(tmp_path.iterdir())) == 1
    method, given = getattr(compiled, name), [np.zeros(compiled.n_joints)] * n_arguments
    first = method(*given)
    monkeypatch.setattr("kindsl.mechanics.dynamics.evaluation.kernels.kernels_of", None)
    np.testing.assert_array_equal(method(*given), first)
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.usefixtures("quickly_compiled")
def test_robots_that_are_compiled_twice_stay_apart() -> None:
    """CPython fills one module with what it loads again; each robot keeps its own functions."""
    robots = [bodies_of_seed(4, 2), bodies_of_seed(12, 2)]
    for bodies in robots:
        CompiledMechanics(bodies)
    again = [CompiledMechanics(bodies) for bodies in robots]
    for compiled, bodies in zip(again, robots, strict=True):
        q = np.full((2, 2, bodies.n_links), 0.4)
        assert_same(compiled.gravity_torque(q), Mechanics(bodies).gravity_torque(q))


def test_with_a_compiler_that_fails(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("KINDSL_CACHE", str(tmp_path))
    monkeypatch.setenv("CC", "false")
    with pytest.raises(CompileError, match="the C compiler failed: "):
        CompiledMechanics(bodies_of_seed(4, 2))
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("KINDSL_CACHE", str(tmp_path / "file"))
    with pytest.raises(CompileError, match="cannot be used"):
        CompiledMechanics(bodies_of_seed(4, 2))


@pytest.mark.usefixtures("quickly_compiled")
def test_a_rotor_without_mass_moves() -> None:
    """Moments alone resist; only the centre of mass is not defined."""
    bodies = bodies_of_seed(4, 2)
    turning = ("revolute",) * bodies.n_links
    rotors = replace(
        bodies, masses=0 * bodies.masses, inertias=np.eye(3) + 0 * bodies.inertias,
        joint_kinds=turning,
    )  # fmt: skip
    compiled, mechanics = CompiledMechanics(rotors), Mechanics(rotors)
    q = np.full(bodies.n_links, 0.4)
    assert_same(compiled.forward_dynamics(q, q, q), mechanics.forward_dynamics(q, q, q))
    for method in (compiled.center_of_mass, compiled.center_of_mass_jacobian):
        with pytest.raises(ValueError, match="the total mass is zero"):
            method(q)


def test_large_numbers_are_no_lack_of_inertia(pair: tuple[CompiledMechanics, Mechanics]) -> None:
    compiled, _ = pair
    q = np.zeros(compiled.n_joints)
    for shape in ((), (3,)):
        zero = np.zeros((*shape, compiled.n_joints))
        with pytest.raises(ValueError, match="'q', 'qd', 'tau': the values are too large"):
            compiled.forward_dynamics(zero, zero + 1e200, zero)
    with pytest.raises(ValueError, match="'q', 'qd', 'tau': the values are too large"):
        compiled.forward_dynamics_derivatives(q, q + 1e200, q)


def test_what_nothing_resists(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("KINDSL_CACHE", str(tmp_path))
    bodies = bodies_of_seed(4, 2)
    weightless = replace(bodies, masses=0 * bodies.masses, inertias=0 * bodies.inertias)
    with pytest.raises(SingularInertiaError, match="nothing resists motion of joint"):
        CompiledMechanics(weightless)


@pytest.mark.parametrize("shape", [(), (3,), (600,)], ids=str)
def test_feet_are_held_as_in_numpy(
    pair: tuple[CompiledMechanics, Mechanics], shape: tuple[int, ...]
) -> None:
    """And contacts that hold a motion twice are told, by whatever code."""
    compiled, mechanics = pair
    generator = np.random.default_rng(2)
    q, qd, tau = (generator.uniform(-1.0, 1.0, (*shape, compiled.n_joints)) for _ in range(3))
    base = (generator.uniform(-1.0, 1.0, (*shape, 6)),) if compiled.bodies.is_floating else ()
    for foot in compiled._feet:
        arguments = (q, qd, tau, [foot], *base)
        try:
            expected = mechanics.constrained_forward_dynamics(*arguments)
        except ValueError as error:
            with pytest.raises(ValueError, match=str(error)):
                compiled.constrained_forward_dynamics(*arguments)
        else:
            assert_same(compiled.constrained_forward_dynamics(*arguments), expected, 1e-9)


@pytest.mark.parametrize("shape", [(), (3,), (600,)], ids=str)
def test_loads_are_those_of_numpy(
    pair: tuple[CompiledMechanics, Mechanics], shape: tuple[int, ...]
) -> None:
    """External forces, a base's acceleration, Jacobians between frames and steps in time."""
    compiled, _ = pair
    generator, n = np.random.default_rng(8), compiled.n_joints
    q, qd, x = generator.uniform(-1.0, 1.0, (3, *shape, n))
    loads = {"external_forces": generator.uniform(-2.0, 2.0, (*shape, n + 1, 6))}
    base = {"base_velocity": np.full(6, 0.2)} if compiled.bodies.is_floating else {}
    given = [loads, {**loads, **base}]
    if compiled.bodies.is_floating:
        acceleration = {"base_acceleration": generator.uniform(-2.0, 2.0, (*shape, 6))}
        given += [acceleration, {**acceleration, **loads, **base}]
    for named in given:
        found, expected = (m.inverse_dynamics(q, qd, x, **named) for m in pair)
        assert_same(found, expected, 1e-11)
        if "base_acceleration" not in named:
            found, expected = (m.forward_dynamics(q, qd, x, **named) for m in pair)
            assert_same(found, expected, 1e-9)
    found, expected = (m.relative_jacobian(q, "link1", "frame0") for m in pair)
    assert_same(found, expected)
    found, expected = (m.integrate(q, qd, 0.1, **base) for m in pair)
    assert_same(found, expected)


def test_compiled_methods_have_signatures_and_help(
    pair: tuple[CompiledMechanics, Mechanics],
) -> None:
    """Before they are compiled and after, of the class and of the instance."""
    compiled, mechanics = pair
    q = np.zeros(compiled.n_joints)
    compiled.regressor(q, q, q)
    for group, names in METHODS.items():
        for name in names:
            original = getattr(mechanics, name)
            wanted = [*inspect.signature(original).parameters, "out"]
            for method in (getattr(compiled, name), getattr(CompiledMechanics, name)):
                assert [x for x in inspect.signature(method).parameters if x != "self"] == wanted
                assert inspect.getdoc(method) == inspect.getdoc(original), (group, name)
