"""What must hold for every mechanism, whatever its numbers."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.dynamics.random_bodies import random_bodies, random_inertia, random_rotation

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.inertia import move_inertia

trees = st.builds(
    lambda seed, n_links, is_floating: random_bodies(
        np.random.default_rng(seed), n_links, is_floating
    ),
    st.integers(0, 10_000),
    st.integers(1, 9),
    st.booleans(),
)
few = settings(max_examples=25, deadline=None, derandomize=True)


def _motion(bodies: Bodies, rows: int = 3) -> tuple[Array, ...]:
    generator = np.random.default_rng(bodies.n_links)
    return (*generator.uniform(-2.0, 2.0, (rows, bodies.n_links)),)


def _base_velocity(bodies: Bodies) -> Array | None:
    return np.array([0.3, -0.2, 0.5, 1.0, -2.0, 0.4]) if bodies.is_floating else None


def _joints_and_base(bodies: Bodies, result: object) -> tuple[Array, Array]:
    if bodies.is_floating:
        joints, base = result  # type: ignore[misc]
        return joints, base
    return np.asarray(result), np.zeros(0)


@few
@given(trees)
def test_joint_space_inertia_is_symmetric_and_positive_definite(bodies: Bodies) -> None:
    M = Mechanics(bodies).joint_space_inertia(_motion(bodies)[0])
    assert abs(M - M.T).max() <= 1e-12 * abs(M).max()
    assert np.linalg.eigvalsh(M).min() > 0.0


@few
@given(trees)
def test_forward_dynamics_inverts_inverse_dynamics(bodies: Bodies) -> None:
    mechanics, v = Mechanics(bodies), _base_velocity(bodies)
    q, qd, qdd = _motion(bodies)
    tau, base = _joints_and_base(bodies, mechanics.inverse_dynamics(q, qd, qdd, v))
    got, got_base = _joints_and_base(bodies, mechanics.forward_dynamics(q, qd, tau, v))
    assert got == pytest.approx(qdd, rel=1e-8, abs=1e-8)
    assert got_base == pytest.approx(base, rel=1e-8, abs=1e-8)


@few
@given(trees)
def test_equation_of_motion_holds(bodies: Bodies) -> None:
    mechanics, v = Mechanics(bodies), _base_velocity(bodies)
    q, qd, qdd = _motion(bodies)
    tau, base = _joints_and_base(bodies, mechanics.inverse_dynamics(q, qd, qdd, v))
    forces = np.concatenate((np.zeros(len(base)), tau))
    M, bias = mechanics.joint_space_inertia(q), mechanics.bias_torque(q, qd, v)
    assert M @ np.concatenate((base, qdd)) + bias == pytest.approx(forces, rel=1e-9, abs=1e-8)


@few
@given(trees)
def test_kinetic_energy_is_half_the_inertia_between_velocities(bodies: Bodies) -> None:
    mechanics, v = Mechanics(bodies), _base_velocity(bodies)
    q, qd, _ = _motion(bodies)
    velocity = qd if v is None else np.concatenate((v, qd))
    expected = 0.5 * velocity @ mechanics.joint_space_inertia(q) @ velocity
    fixed_base_energy = mechanics.kinetic_energy(q, qd, v)
    assert fixed_base_energy == pytest.approx(expected, rel=1e-10)


@few
@given(trees)
def test_gravity_torque_is_the_slope_of_potential_energy(bodies: Bodies) -> None:
    mechanics, q, step = Mechanics(bodies), _motion(bodies)[0], 1e-6
    steps = step * np.eye(bodies.n_links)
    rise = mechanics.potential_energy(q + steps) - mechanics.potential_energy(q - steps)
    torque = mechanics.gravity_torque(q)[-bodies.n_links :]
    assert torque == pytest.approx(rise / (2.0 * step), rel=1e-5, abs=1e-5)


@few
@given(trees)
def test_jacobians_are_the_slopes_of_positions(bodies: Bodies) -> None:
    mechanics, q, step = Mechanics(bodies), _motion(bodies)[0], 1e-6
    name = bodies.frames[0].name
    steps = step * np.eye(bodies.n_links)
    ahead, behind = mechanics.forward_kinematics(q + steps), mechanics.forward_kinematics(q - steps)
    R = mechanics.forward_kinematics(q)[name][:3, :3]
    slope = (ahead[name] - behind[name])[:, :3, 3] @ R / (2.0 * step)
    J = mechanics.jacobian(q, name)[3:, -bodies.n_links :]
    assert pytest.approx(slope, abs=1e-6) == J.T
    com_slope = (mechanics.center_of_mass(q + steps) - mechanics.center_of_mass(q - steps)) / (
        2.0 * step
    )
    J_com = mechanics.center_of_mass_jacobian(q)[:, -bodies.n_links :]
    assert pytest.approx(com_slope, abs=1e-6) == J_com.T


@few
@given(trees, st.integers(0, 1000))
def test_inertia_may_be_given_in_any_frame(bodies: Bodies, seed: int) -> None:
    """Power does not depend on the frame in which a body's inertia was written down."""
    generator = np.random.default_rng(seed)
    given_in_frames, moved = [], []
    for _ in range(bodies.n_links + 1):
        mass, com, inertia = random_inertia(generator)
        R, r = random_rotation(generator), generator.uniform(-1.0, 1.0, 3)
        given_in_frames.append((mass, com, inertia))
        there = move_inertia(np.asarray(mass), com, inertia, R, r)
        moved.append((mass, *move_inertia(np.asarray(mass), *there, R.T, -R.T @ r)))
    q, qd, qdd = _motion(bodies)
    powers = []
    for properties in (given_in_frames, moved):
        masses, coms, inertias = (np.array(column) for column in zip(*properties, strict=True))
        changed = replace(bodies, masses=masses, coms=coms, inertias=inertias)
        result = Mechanics(changed).inverse_dynamics(q, qd, qdd, _base_velocity(bodies))
        powers.append(_joints_and_base(bodies, result)[0] @ qd)
    assert powers[0] == pytest.approx(powers[1], rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_energy_stays_along_a_swing(seed: int) -> None:
    bodies = random_bodies(np.random.default_rng(seed), 4, is_floating=False)
    mechanics = Mechanics(bodies)
    q, qd, _ = _motion(bodies)
    state = np.concatenate((q, 0.1 * qd))
    energy = _energy(mechanics, state)
    step = 1e-4
    for _ in range(500):
        state = _runge_kutta_step(mechanics, state, step)
    exchanged = abs(mechanics.potential_energy(state[:4]) - mechanics.potential_energy(q))
    assert exchanged > 0.1
    assert _energy(mechanics, state) == pytest.approx(energy, abs=1e-6 * max(1.0, abs(energy)))


@pytest.mark.parametrize("seed", range(3))
def test_a_free_mechanism_keeps_its_momentum(seed: int) -> None:
    """Without gravity the rate of the momentum in the base frame is its own turning."""
    bodies = random_bodies(np.random.default_rng(seed), 5, is_floating=True)
    mechanics, v = Mechanics(bodies), _base_velocity(bodies)
    q, qd, tau = _motion(bodies)
    qdd, base = mechanics.forward_dynamics(q, qd, tau, v, (0.0, 0.0, 0.0))  # type: ignore[misc]
    step = 1e-6

    def linear_momentum(sign: float) -> Array:
        J = mechanics.center_of_mass_jacobian(q + sign * step * qd)
        velocity = np.concatenate((v + sign * step * base, qd + sign * step * qdd))
        return mechanics.total_mass() * (J @ velocity)

    rate = (linear_momentum(1.0) - linear_momentum(-1.0)) / (2.0 * step)
    turning = np.cross(v[:3], linear_momentum(0.0))
    assert rate + turning == pytest.approx(np.zeros(3), abs=1e-4)


def _energy(mechanics: Mechanics, state: Array) -> float:
    q, qd = np.split(state, 2)
    return float(mechanics.kinetic_energy(q, qd) + mechanics.potential_energy(q))


def _runge_kutta_step(mechanics: Mechanics, state: Array, step: float) -> Array:
    k1 = _rate(mechanics, state)
    k2 = _rate(mechanics, state + 0.5 * step * k1)
    k3 = _rate(mechanics, state + 0.5 * step * k2)
    k4 = _rate(mechanics, state + step * k3)
    return state + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)


def _rate(mechanics: Mechanics, state: Array) -> Array:
    q, qd = np.split(state, 2)
    qdd = mechanics.forward_dynamics(q, qd, np.zeros(len(q)))
    return np.concatenate((qd, np.asarray(qdd)))
