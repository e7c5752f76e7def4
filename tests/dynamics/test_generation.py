"""Recorded arithmetic is folded, shared and written out without loss."""

import math
import operator
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.dynamics.random_bodies import random_bodies, random_inertia, random_rotation, with_drives
from tests.support.spatial import pseudo_inertia

from kindsl.mechanics.dynamics.generation import forward_dynamics
from kindsl.mechanics.dynamics.generation.emitters.numbers import evaluate
from kindsl.mechanics.dynamics.generation.emitters.numpy_rows import batch_function, run_in_chunks
from kindsl.mechanics.dynamics.generation.emitters.scalar_python import (
    scalar_function,
    scalar_source,
)
from kindsl.mechanics.dynamics.generation.emitters.straight_line import computed
from kindsl.mechanics.dynamics.generation.factorization import solve_symmetric
from kindsl.mechanics.dynamics.generation.function import inputs_of
from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.robot import robot_of
from kindsl.mechanics.dynamics.generation.terms import Graph, Term, cosine_and_sine, operations
from kindsl.mechanics.dynamics.generation.trace import Trace, trace
from kindsl.mechanics.dynamics.quantities import SingularInertiaError

numbers = st.one_of(
    st.sampled_from([0.0, 1.0, -1.0, 2.0]), st.floats(-3.0, 3.0, allow_subnormal=False)
)
# A program is a list of operations, each on two earlier values or constants.
steps = st.lists(
    st.tuples(
        st.sampled_from("+-*n"),
        st.one_of(st.integers(0, 8), numbers),
        st.one_of(st.integers(0, 8), numbers),
    ),
    min_size=1,
    max_size=25,
)


OPERATIONS = {"+": operator.add, "-": operator.sub, "*": operator.mul, "n": lambda a, _: -a}


def _run(program: list[tuple[str, object, object]], values: list[object]) -> list[object]:
    for operation, *places in program:
        a, b = (
            values[place % len(values)] if isinstance(place, int) else place for place in places
        )
        values.append(OPERATIONS[operation](a, b))
    return values[-4:]


@settings(max_examples=150, deadline=None, derandomize=True)
@given(steps, st.lists(st.floats(-2.0, 2.0), min_size=3, max_size=3))
def test_code_computes_what_was_recorded(
    program: list[tuple[str, object, object]], inputs: list[float]
) -> None:
    graph = Graph()
    argument = graph.vector(3)
    outputs = _run(program, [*argument])
    recorded = Trace(graph, [argument], outputs)  # type: ignore[arg-type]
    expected = _run(program, [*inputs])
    scale = max(1.0, *(abs(value) for value in _run(program, [2.0, 2.0, 2.0])), *map(abs, expected))
    single = scalar_function(recorded)(np.array(inputs))
    batch = run_in_chunks(batch_function(recorded), [np.array([inputs] * 5)], 5, 2)
    tolerance = 1e-9 * scale
    assert single == pytest.approx(expected, abs=tolerance)
    for column in batch.T:
        assert column == pytest.approx(expected, abs=tolerance)


def test_constants_are_folded() -> None:
    graph = Graph()
    x, y = graph.vector(2)
    assert x * 0.0 == 0.0
    assert x - x == 0.0
    assert x * 0.5 + x * -0.5 == 0.0
    for same in (
        x + 0.0,
        x * 1.0,
        -(-x),  # noqa: B002
        0.0 + x,
        (x * 2.0) * 0.5,
        (x * -1.0) * -1.0,
        x * 0.25 + x * 0.75,
        x * 3.0 - x * 2.0,
    ):
        assert isinstance(same, Term)
        assert same.index == x.index
    assert (x / 4.0).index == (x * 0.25).index
    assert (x + y).index == (y + x).index
    assert (-(x - y)).index == (y - x).index
    assert cosine_and_sine(0.0) == (1.0, 0.0)


def test_what_no_output_needs_is_left_out() -> None:
    graph = Graph()
    argument = graph.vector(2)
    x, y = argument
    x * y + 3.0
    assert "*" not in scalar_source(Trace(graph, [argument], [x + y]))


def test_inputs_and_what_is_known_are_not_computed() -> None:
    graph = Graph()
    x, y = graph.vector(2)
    product = x * y
    total = product + 3.0
    assert isinstance(product, Term) and isinstance(total, Term)
    assert computed(graph, [total, 2.0], []) == [product.index, total.index]
    assert computed(graph, [total], [product.index]) == [total.index]
    assert computed(graph, [total], [total.index]) == []


def test_fixed_base_costs_less_than_floating() -> None:
    generator = np.random.default_rng(0)
    sizes = []
    for is_floating in (False, True):
        robot = robot_of(random_bodies(generator, 3, is_floating))
        sizes.append(len(trace(robot, "bias_torque", "at_rest").needed()))
    assert sizes[0] < sizes[1]


def test_scalar_code_refuses_what_is_not_finite() -> None:
    robot = robot_of(random_bodies(np.random.default_rng(0), 2, is_floating=False))
    function = scalar_function(trace(robot, "joint_space_inertia", "at_rest"))
    for value in (math.nan, math.inf, -math.inf):
        with pytest.raises(OverflowError):
            function(np.array([0.0, value]))


@pytest.mark.parametrize("seed", range(10))
def test_mass_distributions_move_as_pseudo_inertias(seed: int) -> None:
    generator = np.random.default_rng(seed)
    mass, com, inertia = random_inertia(generator)
    P = pseudo_inertia(np.asarray(mass), com, inertia)
    body = MassMoments(P[:3, :3].tolist(), P[:3, 3].tolist(), mass)
    R, r, angle = random_rotation(generator), generator.uniform(-1.0, 1.0, 3), 0.7
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, r
    Z = np.eye(4)
    Z[:2, :2] = [[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]]
    moved = body.rotated_about_z(math.cos(angle), math.sin(angle))
    moved = moved.rotated(R.tolist()).displaced(r.tolist())
    expected = T @ Z @ P @ Z.T @ T.T
    assert np.array(moved.second) == pytest.approx(expected[:3, :3])
    assert moved.first == pytest.approx(expected[:3, 3].tolist())
    assert np.array(body.inertia()) == pytest.approx(inertia)


@pytest.mark.parametrize("size", [1, 2, 6])
def test_symmetric_systems_are_solved(size: int) -> None:
    generator = np.random.default_rng(size)
    root = generator.normal(size=(size, size))
    A, b = root @ root.T + np.eye(size), generator.normal(size=size)
    assert A @ solve_symmetric(A.tolist(), b.tolist()) == pytest.approx(b)


def test_a_singular_system_is_an_error() -> None:
    with pytest.raises(SingularInertiaError):
        solve_symmetric([[0.0]], [1.0])


@pytest.mark.parametrize(
    ("n_links", "is_floating"), [(5, False), (5, True), (20, True), (34, False)]
)
def test_both_ways_of_forward_dynamics_agree(
    n_links: int, is_floating: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And of both the one with fewer operations is taken."""
    generator = np.random.default_rng(n_links)
    robot = robot_of(with_drives(random_bodies(generator, n_links, is_floating), generator))
    x, found, counts = inputs_of(robot), [], []
    values = {index: float(generator.uniform(-1.0, 1.0)) for index in robot.graph.inputs}
    for shallow, deep in ((0.0, 0.0), (1e9, 1e9), (0.0, 1e9)):
        monkeypatch.setattr(forward_dynamics, "SURELY_SHALLOW", shallow)
        monkeypatch.setattr(forward_dynamics, "SURELY_DEEP", deep)
        entries = forward_dynamics.forward_dynamics(robot.tree, x)
        found.append(np.array(evaluate(robot.graph, values, entries)))
        counts.append(operations(robot.graph, entries))
    scale = abs(found[1]).max()
    np.testing.assert_allclose(found[0], found[1], atol=1e-11 * scale)
    assert counts[2] == min(counts[:2])


def test_forward_dynamics_of_a_chain_grows_with_its_length() -> None:
    sizes = []
    for n in (30, 60):
        bodies = random_bodies(np.random.default_rng(1), n, is_floating=False)
        robot = robot_of(replace(bodies, parents=tuple(range(n))))
        x = replace(inputs_of(robot), external=[])
        sizes.append(operations(robot.graph, forward_dynamics.forward_dynamics(robot.tree, x)))
    # Not twice as many exactly: some axes are turned by right angles, as chance has it.
    assert sizes[1] < 2.4 * sizes[0]
