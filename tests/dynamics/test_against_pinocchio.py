"""Random trees give pinocchio's numbers, in both forms.

Tolerance: both sides round; forward dynamics loses the digits of the inertia's condition, some
1e6 for the deepest of these trees, so 1e-9 of a quantity's greatest entry leaves a margin of ten.
"""

from collections.abc import Iterator

import numpy as np
import pytest
from tests.dynamics.pinocchio_model import PinocchioModel
from tests.dynamics.random_bodies import tree_of_seed
from tests.support.amount import usually
from tests.support.differences import assert_close

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation import book
from kindsl.mechanics.dynamics.evaluation.book import Request
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.quantities import JOINT_VECTORS, Quantity

TREES_PER_BLOCK = 30
# Of the trees that code is generated for, which takes nearly all of the time.
GENERATED_STEP = usually(10, thoroughly=1)
GRAVITY = np.array([1.2, -3.4, -9.0])


@pytest.mark.parametrize("block", range(10))
def test_300_random_trees_agree_with_pinocchio(block: int) -> None:
    for seed in range(block * TREES_PER_BLOCK, (block + 1) * TREES_PER_BLOCK):
        bodies, generator = tree_of_seed(seed)
        _check_tree(seed, bodies, generator)


def _check_tree(seed: int, bodies: Bodies, generator: np.random.Generator) -> None:
    q, qd, x = generator.uniform(-2.0, 2.0, (3, bodies.n_links))
    base_velocity = generator.uniform(-1.0, 1.0, 6) * bodies.is_floating
    expected = _expected(bodies, q, qd, x, base_velocity)
    for quantity, got in _from_the_book(bodies, q, qd, x, base_velocity):
        assert_close(f"seed {seed}, book, {quantity}", got, expected[quantity])
    if seed % GENERATED_STEP == 0:
        for quantity, got in _generated(Mechanics(bodies), q, qd, x, base_velocity):
            assert_close(f"seed {seed}, generated, {quantity}", got, expected[quantity])


def _expected(
    bodies: Bodies, q: np.ndarray, qd: np.ndarray, x: np.ndarray, base_velocity: np.ndarray
) -> dict[str, np.ndarray]:
    model = PinocchioModel(bodies, GRAVITY)
    name = bodies.frames[0].name
    expected = {
        "poses": np.array(list(model.poses(q).values())).ravel(),
        "joint_space_inertia": model.joint_space_inertia(q).ravel(),
        "gravity_torque": model.bias_torque(q, 0.0 * q, np.zeros(6)),
        "bias_torque": model.bias_torque(q, qd, base_velocity),
        "jacobian": model.frame_jacobian(q, name),
        "kinetic_energy": np.array(model.kinetic_energy(q, qd, base_velocity)),
    }
    for quantity in ("inverse_dynamics", "forward_dynamics"):
        joints, base = getattr(model, quantity)(q, qd, x, base_velocity)
        both = np.concatenate((joints, base))
        expected[quantity] = both if bodies.is_floating else joints
    if bodies.is_floating:
        expected["center_of_mass"] = model.center_of_mass(q)
        expected["center_of_mass_jacobian"] = model.center_of_mass_jacobian(q)
    return expected


def _generated(
    mechanics: Mechanics, q: np.ndarray, qd: np.ndarray, x: np.ndarray, base_velocity: np.ndarray
) -> Iterator[tuple[str, np.ndarray]]:
    bodies = mechanics.bodies
    v = base_velocity if bodies.is_floating else None
    yield "poses", np.array(list(mechanics.forward_kinematics(q).values())).ravel()
    yield "jacobian", mechanics.jacobian(q, bodies.frames[0].name)
    yield "joint_space_inertia", mechanics.joint_space_inertia(q).ravel()
    yield "gravity_torque", mechanics.gravity_torque(q, GRAVITY)
    yield "bias_torque", mechanics.bias_torque(q, qd, v, GRAVITY)
    yield "kinetic_energy", mechanics.kinetic_energy(q, qd, v)
    for quantity in ("inverse_dynamics", "forward_dynamics"):
        result = getattr(mechanics, quantity)(q, qd, x, v, GRAVITY)
        yield quantity, np.concatenate(result) if bodies.is_floating else result
    if bodies.is_floating:
        yield "center_of_mass", mechanics.center_of_mass(q)
        yield "center_of_mass_jacobian", mechanics.center_of_mass_jacobian(q)


def _from_the_book(
    bodies: Bodies, q: np.ndarray, qd: np.ndarray, x: np.ndarray, base_velocity: np.ndarray
) -> Iterator[tuple[str, np.ndarray]]:
    quantities: list[Quantity] = list(JOINT_VECTORS)
    for quantity in quantities:
        joints = dict(zip(JOINT_VECTORS[quantity], (q, qd, x), strict=False))
        request = Request(quantity, (), {**joints, "v0": base_velocity, "g": GRAVITY})
        yield quantity, book.evaluate(bodies, request)
