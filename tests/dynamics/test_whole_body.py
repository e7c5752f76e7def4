"""Quantities for controllers: pinocchio's numbers on random trees, in NumPy and in generated code.

Tolerance as in `test_against_pinocchio`: the condition of the inertia costs some digits.
"""

from collections.abc import Iterator
from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from tests.codegen.robots import CONTROL, bodies_of_seed
from tests.dynamics.pinocchio_model import PinocchioModel
from tests.dynamics.random_bodies import tree_of_seed
from tests.support.amount import usually
from tests.support.differences import assert_close

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.generation.emitters.numbers import evaluate
from kindsl.mechanics.dynamics.generation.function import inputs_of
from kindsl.mechanics.dynamics.generation.functions import QUANTITIES
from kindsl.mechanics.dynamics.generation.jacobians import feet
from kindsl.mechanics.dynamics.generation.robot import robot_of
from kindsl.mechanics.spatial.arrays import Array
from kindsl.products.codegen.reference import Reference, independent_contacts, sample

SEEDS = range(0, 300, usually(5, thoroughly=1))
# Code for long trees takes long to record.
MOST_LINKS = usually(8, thoroughly=20)
GRAVITY = np.array([1.2, -3.4, -9.0])


def _tree(seed: int) -> tuple[Bodies, np.random.Generator]:
    bodies, generator = tree_of_seed(seed)
    if bodies.is_floating:
        return bodies, generator
    return replace(bodies, masses=np.concatenate(([0.0], bodies.masses[1:]))), generator


@pytest.mark.parametrize("block", range(6))
def test_numpy_gives_pinocchios_numbers(block: int) -> None:
    for seed in SEEDS[block::6]:
        bodies, generator = _tree(seed)
        for what, got, expected in _pairs(bodies, generator):
            assert_close(f"seed {seed}, {what}", got, expected)


def _pairs(bodies: Bodies, generator: np.random.Generator) -> Iterator[tuple[str, Array, Array]]:
    mechanics, model = Mechanics(bodies), PinocchioModel(bodies, GRAVITY)
    q, qd, x = generator.uniform(-2.0, 2.0, (3, bodies.n_links))
    v0, a0 = generator.uniform(-1.0, 1.0, (2, 6)) * bodies.is_floating
    v, a = (v0, a0) if bodies.is_floating else (None, None)
    names = [frame.name for frame in bodies.frames]
    matrix = mechanics.centroidal_momentum_matrix(q)
    yield "matrix", matrix, model.centroidal_momentum_matrix(q)
    drift = mechanics.centroidal_momentum_drift(q, qd, v)
    yield "drift", drift, model.centroidal_momentum_drift(q, qd, v0)
    for name in names:
        velocity, acceleration = model.frame_motion(q, qd, x, v0, a0, name)
        yield "velocity", mechanics.frame_velocity(q, qd, name, v), velocity
        yield "acceleration", mechanics.frame_acceleration(q, qd, x, name, v, a), acceleration
        _, drift = model.frame_motion(q, qd, 0.0 * x, v0, 0.0 * a0, name)
        yield "frame's drift", mechanics.frame_acceleration_drift(q, qd, name, v), drift
    inverse = mechanics.joint_space_inertia_inverse(q)
    yield "inverse", inverse, model.joint_space_inertia_inverse(q)
    yield "Coriolis", mechanics.coriolis_matrix(q, qd, v), model.coriolis_matrix(q, qd, v0)
    for is_rigid, rows in ((False, slice(3, 6)), (True, slice(0, 6))):
        held = _independent(mechanics, q, names, rows)
        if not held:
            continue
        found = mechanics.constrained_forward_dynamics(
            q, qd, x, held, v, GRAVITY, is_rigid=is_rigid
        )
        motion, forces, Lambda = model.constrained_forward_dynamics(q, qd, x, v0, held, rows)
        base = found.base_acceleration if bodies.is_floating else np.zeros(0)
        yield "held", np.concatenate((base, found.qdd)), motion
        yield "contact forces", found.contact_forces.ravel(), forces
        yield "Lambda", found.Lambda, Lambda


def _independent(mechanics: Mechanics, q: Array, names: list[str], rows: slice) -> list[str]:
    """Return frames that hold different motions, such that rounding does not matter."""
    held, J = list[str](), np.zeros((0, mechanics.bodies.n_velocities))
    for name in names:
        more = np.concatenate((J, mechanics.jacobian(q, name)[rows]))
        if len(more) <= more.shape[1] and np.linalg.cond(more) < 100.0:
            held, J = [*held, name], more
    return held


@pytest.mark.parametrize("block", range(6))
def test_generated_code_gives_the_numbers_of_numpy(block: int) -> None:
    for seed in SEEDS[block::6]:
        bodies, _ = _tree(seed)
        if bodies.n_links <= MOST_LINKS:
            _check_generated(seed, bodies)


def _check_generated(seed: int, bodies: Bodies) -> None:
    robot, mechanics = robot_of(bodies), Mechanics(bodies)
    inputs, values = inputs_of(robot), sample(bodies, seed)
    names = [foot.name for foot in feet(robot)]
    held = _independent(mechanics, values["q"], names, slice(3, 6))
    values["active"] = np.array([float(name in held) for name in names])
    reference = Reference(mechanics, values)
    for name in CONTROL:
        for function in QUANTITIES[name].build(robot, inputs):
            given = {
                term.index: float(value)
                for argument in function.arguments
                for term, value in zip(argument.components, values[argument.name], strict=True)
            }
            for result, answer in zip(function.results, reference.results(function), strict=True):
                got = np.array(evaluate(robot.graph, given, result.entries))
                assert_close(f"seed {seed}, {function.name}", got, answer.ravel())


@pytest.mark.parametrize("seed", [3, 4])
def test_batches_are_single_answers(seed: int) -> None:
    bodies = bodies_of_seed(seed)
    mechanics, generator = Mechanics(bodies), np.random.default_rng(seed)
    q, qd, x = generator.uniform(-2.0, 2.0, (3, 2, 3, bodies.n_links))
    v = (generator.uniform(-1.0, 1.0, (2, 3, 6)),) if bodies.is_floating else ()
    name = bodies.frames[0].name
    contacts = [name] if bodies.is_floating else []
    for method, arguments, named in (
        ("centroidal_momentum_matrix", (q,), ()),
        ("centroidal_momentum_drift", (q, qd, *v), ()),
        ("frame_velocity", (q, qd), (name, *v)),
        ("frame_acceleration", (q, qd, x), (name, *v)),
        ("frame_acceleration_drift", (q, qd), (name, *v)),
        ("joint_space_inertia_inverse", (q,), ()),
        ("coriolis_matrix", (q, qd, *v), ()),
        ("constrained_forward_dynamics", (q, qd, x), (contacts, *v)),
    ):
        whole = getattr(mechanics, method)(*arguments, *named)
        for place in np.ndindex(2, 3):
            one = [argument[place] for argument in arguments]
            base = [n[place] if isinstance(n, np.ndarray) else n for n in named]
            single = getattr(mechanics, method)(*one, *base)
            parts = (
                zip(whole, single, strict=True) if isinstance(whole, tuple) else [(whole, single)]
            )
            for many, alone in parts:
                np.testing.assert_allclose(many[place], alone, rtol=1e-9, atol=1e-9)


def test_a_coriolis_matrix_is_half_of_what_turns_the_inertia() -> None:
    """`C + C^T` is its rate, and `C v` with gravity the bias torque."""
    bodies = bodies_of_seed(4)
    mechanics, generator = Mechanics(bodies), np.random.default_rng(4)
    q, qd = generator.uniform(-1.0, 1.0, (2, bodies.n_links))
    C, step = mechanics.coriolis_matrix(q, qd), 1e-6
    after, before = (mechanics.joint_space_inertia(q + sign * step * qd) for sign in (1, -1))
    np.testing.assert_allclose(C + C.T, (after - before) / (2.0 * step), atol=1e-7)
    bias = C @ qd + mechanics.gravity_torque(q, GRAVITY)
    np.testing.assert_allclose(mechanics.bias_torque(q, qd, None, GRAVITY), bias, atol=1e-12)


def test_contacts_that_hold_a_motion_twice_are_told() -> None:
    bodies = bodies_of_seed(3)
    mechanics, rest = Mechanics(bodies), np.zeros(bodies.n_links)
    name = bodies.frames[0].name
    with pytest.raises(ValueError, match="hold some motion twice"):
        mechanics.constrained_forward_dynamics(rest, rest, rest, [name, name])
    with pytest.raises(ValueError, match="there is no link or frame 'fot'"):
        mechanics.constrained_forward_dynamics(rest, rest, rest, ["fot"])
    with pytest.raises(ValueError, match="the base is fixed"):
        Mechanics(bodies_of_seed(4)).frame_velocity({}, {}, "base", np.zeros(6))


def test_contacts_are_chosen_such_that_none_is_held_twice() -> None:
    bodies = bodies_of_seed(3)
    name = bodies.frames[0].name
    chosen = independent_contacts(Mechanics(bodies), np.zeros(bodies.n_links), [name, name])
    assert chosen.tolist() == [1.0, 0.0]


class _AlmostTheSame:
    """Mechanics of contacts whose second one holds one motion of the first, but for little."""

    def __init__(self, difference: float) -> None:
        self.bodies = SimpleNamespace(n_velocities=6)
        self.difference = difference

    def jacobian(self, _: object, name: str) -> Array:
        if name == "first":
            return np.eye(6)
        return np.vstack((np.eye(6)[:3], [1.0, 0.0, self.difference, 0.0, 0.0, 0.0], np.eye(6)[:2]))


@pytest.mark.parametrize(("difference", "is_held"), [(1e-3, False), (0.1, True)])
def test_contacts_that_are_nearly_held_are_not_chosen(difference: float, is_held: bool) -> None:
    mechanics = cast(Mechanics, _AlmostTheSame(difference))
    chosen = independent_contacts(mechanics, np.zeros(6), ["first", "second"])
    assert chosen.tolist() == [1.0, float(is_held)]


def test_without_contacts_the_motion_is_free() -> None:
    bodies = bodies_of_seed(3)
    mechanics, generator = Mechanics(bodies), np.random.default_rng(3)
    q, qd, tau = generator.uniform(-1.0, 1.0, (3, bodies.n_links))
    held = mechanics.constrained_forward_dynamics(q, qd, tau, [])
    free = mechanics.forward_dynamics(q, qd, tau)
    np.testing.assert_allclose(held.qdd, free.qdd, atol=1e-9)
    np.testing.assert_allclose(held.base_acceleration, free.base_acceleration, atol=1e-9)
    assert held.contact_forces.shape == (0, 3)
    assert held.Lambda.shape == (0, 0)
