"""Which form answers, and what is written once and used again."""

from collections import Counter

import numpy as np
import pytest
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.evaluation import book, forms
from kindsl.mechanics.dynamics.evaluation.book import Request
from kindsl.mechanics.dynamics.evaluation.forms import (
    LINEAR,
    MOST_LINKS_TO_GENERATE_FOR,
    SMALLEST_BATCH,
    WORTH_GENERATING,
    Forms,
)
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.quantities import JOINT_VECTORS, STANDARD_GRAVITY, Quantity
from kindsl.mechanics.spatial.arrays import Array

QUANTITIES: list[Quantity] = list(JOINT_VECTORS)
SHORT, LONG = MOST_LINKS_TO_GENERATE_FOR, MOST_LINKS_TO_GENERATE_FOR + 1
SIZES = (1, SMALLEST_BATCH, WORTH_GENERATING - 1, WORTH_GENERATING)
REST, DOWN = np.zeros(6), np.array(STANDARD_GRAVITY)
MOVING, ASIDE = np.array([0.3, -0.2, 0.5, 1.0, -2.0, 0.4]), np.array([1.0, 2.0, -3.0])


def _request(
    quantity: Quantity, shape: tuple[int, ...], n_links: int, v: Array = REST, g: Array = DOWN
) -> Request:
    vectors = np.random.default_rng(2).uniform(-1.0, 1.0, (3, *shape, n_links))
    joints = dict(zip(JOINT_VECTORS[quantity], vectors, strict=False))
    return Request(quantity, shape, {**joints, "v0": v, "g": g})


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """How often each form was asked, and made, instead of an answer."""
    counts: Counter[str] = Counter()

    def counting(name: str) -> object:
        return lambda *_: counts.update([name])

    monkeypatch.setattr(Forms, "by_code", counting("code"))
    monkeypatch.setattr(book, "evaluate", counting("book"))
    return counts


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_short_chains_are_answered_by_code(quantity: Quantity, asked: Counter[str]) -> None:
    chosen = Forms(random_bodies(np.random.default_rng(0), SHORT, is_floating=False))
    for size in SIZES:
        chosen.evaluate(_request(quantity, (size,), SHORT))
    assert asked == {"code": len(SIZES)}


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_long_chains_are_answered_by_what_pays(quantity: Quantity, asked: Counter[str]) -> None:
    """Code for the largest batches if it stays short."""
    chosen = Forms(random_bodies(np.random.default_rng(0), LONG, is_floating=False))
    largest = "code" if quantity in LINEAR else "book"
    for size, form in zip(SIZES, ["book", "book", "book", largest], strict=True):
        before = asked[form]
        chosen.evaluate(_request(quantity, (1, size), LONG))
        assert asked[form] == before + 1, size


def test_no_code_is_written_where_that_is_said(asked: Counter[str]) -> None:
    bodies = random_bodies(np.random.default_rng(0), SHORT, is_floating=False)
    chosen = Forms(bodies, generates_code=False)
    for size in SIZES:
        chosen.evaluate(_request("bias_torque", (size,), SHORT))
    assert asked == {"book": len(SIZES)}


@pytest.mark.parametrize("is_floating", [False, True])
def test_code_is_written_once(is_floating: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each quantity's, for one configuration and for many, at rest and in motion."""
    traced: Counter[tuple[object, ...]] = Counter()
    trees: list[int] = []
    trace, robot_of = forms.trace, forms.robot_of
    monkeypatch.setattr(forms, "trace", lambda *a: traced.update([a[1:]]) or trace(*a))
    monkeypatch.setattr(forms, "robot_of", lambda b: trees.append(1) or robot_of(b))
    bodies = random_bodies(np.random.default_rng(5), 3, is_floating)
    form = Forms(bodies)
    for _ in range(2):
        for quantity in QUANTITIES:
            for shape in ((), (SMALLEST_BATCH - 1,), (SMALLEST_BATCH,), (2, SMALLEST_BATCH), (0,)):
                form.evaluate(_request(quantity, shape, 3))
                form.evaluate(_request(quantity, shape, 3, REST, ASIDE))
    for quantity in QUANTITIES:
        for conditions in ("at_rest", "any"):
            assert traced[quantity, conditions] == 2
    assert trees == [1]


@pytest.mark.parametrize("shape", [(), (SMALLEST_BATCH,)])
@pytest.mark.parametrize(("v", "g"), [(REST, DOWN), (REST, ASIDE), (MOVING, DOWN), (MOVING, ASIDE)])
def test_rest_is_no_velocity_and_standard_gravity(
    shape: tuple[int, ...], v: Array, g: Array
) -> None:
    """Code for rest must not answer for a base that moves, or under another gravity."""
    bodies = random_bodies(np.random.default_rng(2), 3, is_floating=True)
    form = Forms(bodies)
    for quantity in QUANTITIES:
        request = _request(quantity, shape, 3, v, g)
        expected = book.evaluate(bodies, request)
        np.testing.assert_allclose(form.evaluate(request), expected, rtol=1e-9, atol=1e-9)
    is_ready = shape == () and v is REST and g is DOWN
    assert {*form.at_rest} == ({*QUANTITIES} if is_ready else set())


def test_only_few_configurations_make_single_answers_ready() -> None:
    bodies = random_bodies(np.random.default_rng(2), 3, is_floating=True)
    for size, is_ready in ((0, False), (1, True), (SMALLEST_BATCH - 1, True),
                           (SMALLEST_BATCH, False)):  # fmt: skip
        form = Forms(bodies)
        form.evaluate(_request("gravity_torque", (size,), 3))
        assert ("gravity_torque" in form.at_rest) == is_ready


def test_ready_answers_are_for_rest_only() -> None:
    """A second call finds code that is ready for rest; a moving base is another matter."""
    bodies = random_bodies(np.random.default_rng(2), 3, is_floating=True)
    mechanics, q = Mechanics(bodies), np.array([0.1, 0.2, 0.3])
    for arguments in ((), (MOVING,), (None, ASIDE), (MOVING, ASIDE)):
        fresh = Mechanics(bodies).bias_torque(q, q, *arguments)
        for _ in range(2):
            mechanics.bias_torque(q, q)
            np.testing.assert_allclose(mechanics.bias_torque(q, q, *arguments), fresh, atol=1e-12)
