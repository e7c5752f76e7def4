"""Derivatives and the regressor: three independent ways agree."""

import numpy as np
import pinocchio as pin
import pytest
from tests.codegen.robots import bodies_of_seed, library, reference
from tests.dynamics.pinocchio_model import PinocchioModel
from tests.dynamics.random_bodies import random_bodies
from tests.support.differences import worst_difference

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.generation.emitters.numbers import evaluate
from kindsl.mechanics.dynamics.generation.functions import QUANTITIES
from kindsl.mechanics.dynamics.generation.terms import operations
from kindsl.mechanics.dynamics.quantities import SingularInertiaError
from kindsl.mechanics.spatial.arrays import Array

DERIVATIVES = tuple(
    name for name, quantity in QUANTITIES.items() if quantity.group == "derivatives"
)
STEP = 1e-30


def _values_of_inputs(lib, values: dict[str, Array]) -> dict[int, complex]:
    return {
        x.index: value
        for name in ("q", "qd", "qdd", "tau", "v0", "a0", "g")
        for x, value in zip(getattr(lib.inputs, name), values[name], strict=True)
        if not isinstance(x, float)
    }


@pytest.mark.parametrize("seed", range(20))
def test_the_graph_and_the_book_agree(seed: int) -> None:
    bodies = bodies_of_seed(seed)
    lib, expected = library(bodies, DERIVATIVES), reference(bodies)
    numbers = _values_of_inputs(lib, expected.values)
    for function in lib.all_functions:
        found = [np.array(evaluate(lib.robot.graph, numbers, r.entries)) for r in function.results]
        assert worst_difference(found, expected.results(function)) < 1e-12, function.name


@pytest.mark.parametrize("seed", [3, 7])
def test_a_body_is_not_counted_once_for_each_joint_that_carries_it(seed: int) -> None:
    """Differentiating the forces along each direction takes eight times their operations."""
    lib = library(bodies_of_seed(seed), ("inverse_dynamics_actuated", DERIVATIVES[0]))
    forces, derivatives = (
        operations(lib.robot.graph, [x for result in function.results for x in result.entries])
        for function in lib.all_functions
    )
    assert derivatives < 5.5 * forces


@pytest.mark.parametrize("seed", [2, 3])
def test_complex_steps(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Forces and accelerations at a complex neighbour give derivatives without cancellation."""
    for name, function in (("sin", np.sin), ("cos", np.cos)):
        monkeypatch.setitem(evaluate.__globals__["OPERATIONS"], name, function)
    bodies = bodies_of_seed(seed)
    name = "inverse_dynamics_actuated" if bodies.is_floating else "inverse_dynamics"
    lib, values = library(bodies, (name, "forward_dynamics")), reference(bodies).values
    base = [values["v0"], values["a0"]] if bodies.is_floating else [None, None]
    mechanics = Mechanics(bodies)
    joints = [values[key] for key in ("q", "qd", "qdd")]
    inverse = mechanics.inverse_dynamics_derivatives(*joints, *base, values["g"])
    joints[2] = values["tau"]
    forward = mechanics.forward_dynamics_derivatives(*joints, base[0], values["g"])
    for function, (by_q, by_qd, by_last), last in zip(
        lib.all_functions, (inverse, forward), ("qdd", "tau"), strict=True
    ):
        columns = {"q": by_q, "qd": by_qd, last: by_last}
        for changed, expected in columns.items():
            stepped = _stepped(lib, function, values, changed)
            first = bodies.n_velocities - bodies.n_links
            np.testing.assert_allclose(stepped, expected[:, first:], rtol=1e-9, atol=1e-9)
        if bodies.is_floating:
            stepped = _stepped(lib, function, values, "v0")
            np.testing.assert_allclose(stepped, by_qd[:, :6], rtol=1e-9, atol=1e-9)


def _stepped(lib, function, values: dict[str, Array], changed: str) -> Array:
    columns = []
    for k in range(len(values[changed])):
        moved = values[changed].astype(complex)
        moved[k] += STEP * 1j
        numbers = _values_of_inputs(lib, {**values, changed: moved})
        parts = [evaluate(lib.robot.graph, numbers, r.entries) for r in function.results]
        columns.append(np.concatenate(parts[::-1]).imag / STEP)  # the base's rows first
    return np.array(columns).T


@pytest.mark.parametrize("seed", range(6))
def test_pinocchio_agrees(seed: int) -> None:
    """Its tangent space of a free-flyer is small turns and shifts about the base's axes too."""
    bodies = bodies_of_seed(seed)
    values = reference(bodies).values
    theirs, ours = PinocchioModel(bodies, values["g"]), Mechanics(bodies)
    is_floating = bodies.is_floating
    base = [values["v0"], values["a0"]] if is_floating else [None, None]
    q, qd, qdd, tau = (values[key] for key in ("q", "qd", "qdd", "tau"))
    order = np.ix_(theirs.order, theirs.order)
    v, a = theirs.v_of(values["v0"], qd), theirs.v_of(values["a0"], qdd)
    expected = pin.computeRNEADerivatives(theirs.model, theirs.data, theirs.q_of(q), v, a)
    found = ours.inverse_dynamics_derivatives(q, qd, qdd, *base, values["g"])
    for mine, other in zip(found[:2], expected[:2], strict=True):
        np.testing.assert_allclose(mine, other[order], rtol=1e-9, atol=1e-9)
    force = theirs.v_of(np.zeros(6), tau)
    pin.computeABADerivatives(theirs.model, theirs.data, theirs.q_of(q), v, force)
    found = ours.forward_dynamics_derivatives(q, qd, tau, base[0], values["g"])
    inverse = np.triu(theirs.data.Minv) + np.triu(theirs.data.Minv, 1).T
    expected = (theirs.data.ddq_dq, theirs.data.ddq_dv, inverse)
    for mine, other in zip(found, expected, strict=True):
        scale = abs(other).max()
        np.testing.assert_allclose(mine, other[order], rtol=1e-9, atol=1e-9 * scale)


@pytest.mark.parametrize("seed", range(6))
def test_the_regressor_gives_the_forces(seed: int) -> None:
    bodies = bodies_of_seed(seed)
    values, m = reference(bodies).values, Mechanics(bodies)
    q, qd, qdd, g = (values[key] for key in ("q", "qd", "qdd", "g"))
    base = [values["v0"], values["a0"]] if bodies.is_floating else [None, None]
    Y = m.regressor(q, qd, qdd, *base, g)
    a = np.concatenate((values["a0"], qdd)) if bodies.is_floating else qdd
    forces = m.joint_space_inertia(q) @ a + m.bias_torque(q, qd, base[0], g)
    np.testing.assert_allclose(Y @ m.inertial_parameters(), forces, rtol=1e-12, atol=1e-12)


def test_batches_broadcast() -> None:
    bodies = random_bodies(np.random.default_rng(1), 4, is_floating=True)
    generator, m = np.random.default_rng(2), Mechanics(bodies)
    q, qd, x = (generator.uniform(-1.0, 1.0, (3, 2, 4)) for _ in range(3))
    v0, g = generator.uniform(-1.0, 1.0, (2, 6)), np.array([0.1, 0.2, -9.0])
    answers = {
        "inverse_dynamics_derivatives": m.inverse_dynamics_derivatives(q, qd, x, v0, None, g),
        "forward_dynamics_derivatives": m.forward_dynamics_derivatives(q, qd, x, v0, g),
        "regressor": (m.regressor(q, qd, x, v0, None, g),),
    }
    for k in np.ndindex(3, 2):
        arguments = (q[k], qd[k], x[k], v0[k[1]])
        single = {
            "inverse_dynamics_derivatives": m.inverse_dynamics_derivatives(*arguments, None, g),
            "forward_dynamics_derivatives": m.forward_dynamics_derivatives(*arguments, g),
            "regressor": (m.regressor(*arguments, None, g),),
        }
        for name, whole in answers.items():
            for batch, alone in zip(whole, single[name], strict=True):
                np.testing.assert_allclose(batch[k], alone, rtol=1e-11, atol=1e-11)


def test_a_long_chain_is_no_matter_of_patience() -> None:
    bodies = random_bodies(np.random.default_rng(1), 60, is_floating=False)
    q = np.zeros(60)
    assert Mechanics(bodies).inverse_dynamics_derivatives(q, q, q).dtau_dq.shape == (60, 60)


def test_what_is_refused() -> None:
    fixed = Mechanics(bodies_of_seed(2))
    q = np.zeros(fixed.n_joints)
    with pytest.raises(ValueError, match="'base_acceleration' is given, but the base is fixed"):
        fixed.regressor(q, q, q, None, np.zeros(6))
    with pytest.raises(ValueError, match=r"'qd' has shape \(1,\)"):
        fixed.forward_dynamics_derivatives(q, [0.0], q)
    with pytest.raises(SingularInertiaError):
        Mechanics(_weightless(fixed.bodies)).forward_dynamics_derivatives(q, q, q)


def _weightless(bodies: Bodies) -> Bodies:
    from dataclasses import replace

    return replace(bodies, masses=0 * bodies.masses, inertias=0 * bodies.inertias)
