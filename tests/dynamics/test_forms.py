"""All forms are equal: single, batched, in chunks, at rest or moving."""

import numpy as np
import pytest
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.evaluation import book, forms
from kindsl.mechanics.dynamics.evaluation.book import Request
from kindsl.mechanics.dynamics.evaluation.forms import (
    CHUNK,
    MOST_LINKS_TO_GENERATE_FOR,
    SMALLEST_BATCH,
    WORTH_GENERATING,
    Forms,
)
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.quantities import JOINT_VECTORS, STANDARD_GRAVITY, Quantity

# Rounding only; forward dynamics loses the digits of the inertia's condition.
TOLERANCE = 1e-10
QUANTITIES: list[Quantity] = list(JOINT_VECTORS)
SHAPES = [(), (1,), (3, 2), (0,), (SMALLEST_BATCH,), (7, SMALLEST_BATCH)]


@pytest.mark.parametrize("quantity", QUANTITIES)
@pytest.mark.parametrize("is_floating", [False, True])
@pytest.mark.parametrize("is_at_rest", [False, True])
def test_forms_are_equal(quantity: Quantity, is_floating: bool, is_at_rest: bool) -> None:
    for seed, n_links in enumerate((1, 2, 5, 9)):
        generator = np.random.default_rng(seed)
        bodies = random_bodies(generator, n_links, is_floating)
        form = Forms(bodies)
        for shape in SHAPES:
            n_vectors = len(JOINT_VECTORS[quantity])
            vectors = generator.uniform(-3.0, 3.0, (n_vectors, *shape, n_links))
            v, gravity = np.zeros(6), np.array(STANDARD_GRAVITY)
            if not is_at_rest:
                v = generator.uniform(-1.0, 1.0, (*shape, 6)) * is_floating
                gravity = generator.uniform(-9.0, 9.0, 3)
            joints = dict(zip(JOINT_VECTORS[quantity], vectors, strict=True))
            request = Request(quantity, shape, {**joints, "v0": v, "g": gravity})
            got, expected = form.by_code(request), book.evaluate(bodies, request)
            assert got.shape == expected.shape
            scale = abs(expected).max(initial=1e-3)
            assert abs(got - expected).max(initial=0.0) <= TOLERANCE * scale


@pytest.mark.parametrize("size", [CHUNK - 1, CHUNK, CHUNK + 1, 2 * CHUNK + 3])
def test_chunks_do_not_show(size: int) -> None:
    bodies = random_bodies(np.random.default_rng(0), 3, is_floating=True)
    q, qd, tau = np.random.default_rng(1).uniform(-3.0, 3.0, (3, size, 3))
    mechanics = Mechanics(bodies)
    qdd, base = mechanics.forward_dynamics(q, qd, tau)  # type: ignore[misc]
    for row in (0, 1, size // 2, size - 2, size - 1):
        single, single_base = mechanics.forward_dynamics(q[row], qd[row], tau[row])  # type: ignore[misc]
        assert qdd[row] == pytest.approx(single, rel=1e-9, abs=1e-9)
        assert base[row] == pytest.approx(single_base, rel=1e-9, abs=1e-9)


def test_angles_of_all_sizes_keep_their_digits() -> None:
    """Batches take cosine and sine from the half angle's tangent, which grows without bound."""
    bodies = random_bodies(np.random.default_rng(3), 1, is_floating=False)
    assert bodies.joint_kinds == ("revolute",)
    near = np.array([0.0, -0.0, 1e-300, 1e-9, np.pi / 2, np.pi, -np.pi, 3 * np.pi, 1e4])
    q = np.concatenate((near, np.nextafter(near, 9.0), np.linspace(-20.0, 20.0, 200)))[:, None]
    mechanics = Mechanics(bodies)
    batch = mechanics.forward_kinematics(q)["link1"]
    singles = np.stack([mechanics.forward_kinematics(row)["link1"] for row in q])
    assert abs(batch - singles).max() < 1e-15 * 4


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_long_chains_never_wait_for_code(
    quantity: Quantity, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Unless the batch is so large that waiting for code is the shortest wait."""
    n_links = MOST_LINKS_TO_GENERATE_FOR + 1
    chosen = Forms(random_bodies(np.random.default_rng(0), n_links, is_floating=True))
    traced = []
    monkeypatch.setattr(forms, "trace", lambda *_: traced.append(1))
    vectors = {name: np.zeros(n_links) for name in JOINT_VECTORS[quantity]}
    vectors |= {"v0": np.zeros(6), "g": np.array(STANDARD_GRAVITY)}
    for size in (1, SMALLEST_BATCH, SMALLEST_BATCH + 1):
        chosen.evaluate(Request(quantity, (size,), vectors))
    assert not traced


def test_large_batches_of_long_chains_are_worth_code() -> None:
    n_links = MOST_LINKS_TO_GENERATE_FOR + 1
    bodies = random_bodies(np.random.default_rng(0), n_links, is_floating=False)
    q = np.random.default_rng(1).uniform(-1.0, 1.0, (WORTH_GENERATING, n_links))
    mechanics = Mechanics(bodies)
    for rows in (slice(1), slice(SMALLEST_BATCH)):
        torque = mechanics.gravity_torque(q[rows])
        assert mechanics.gravity_torque(q)[rows] == pytest.approx(torque, rel=1e-9, abs=1e-9)
