"""What is prepared before code is generated: rounding is taken out, forces stay the same."""

from dataclasses import replace

import numpy as np
import pytest
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.generation.emitters.numbers import evaluate
from kindsl.mechanics.dynamics.generation.function import Inputs
from kindsl.mechanics.dynamics.generation.inverse_dynamics import inverse_dynamics
from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.terms import Graph, Term
from kindsl.mechanics.dynamics.generation.tree import (
    ROUNDING,
    Tree,
    mass_distributions,
    masses_near_base,
    tree_of,
)
from kindsl.mechanics.dynamics.generation.vectors import EYE
from kindsl.mechanics.rigid.joint_kind import JointKind

NEAR = 0.5 * ROUNDING


def test_right_angles_become_exact() -> None:
    """Else products with 6e-17 are carried through all the code."""
    quarter = np.array([[NEAR, -1.0 + NEAR, 0.0], [1.0, -NEAR, 0.0], [0.0, 0.0, 1.0 - NEAR]])
    turned = np.array([[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]])
    bodies = random_bodies(np.random.default_rng(1), 2, is_floating=False)
    rotations = tree_of(replace(bodies, p_R_j=np.array([quarter, turned]))).rotations
    assert rotations == [EYE, [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], turned.tolist()]


@pytest.mark.parametrize("kind", ["revolute", "prismatic"])
def test_what_only_rounding_left_of_a_body_is_gone(kind: JointKind) -> None:
    near, far = 1e-17, 1e-14
    first = [1.0, near, far] if kind == "prismatic" else [1.0, near, 5.0]
    second = [[0.0, 0.0, 0.0]] * 3 if kind == "prismatic" else [
        [1.0, near, far], [near, 2.0, near], [far, near, 7.0]
    ]  # fmt: skip
    body = MassMoments([[*row] for row in second], first, 2.0)
    none = MassMoments([[0.0] * 3 for _ in range(3)], [0.0] * 3, 0.0)
    found = masses_near_base(["revolute", kind], [0, 0], [EYE, EYE], [[0.0] * 3] * 2, [none, body])
    if kind == "prismatic":
        assert found[1].first == [1.0, 0.0, far]
    else:
        assert found[1].second == [[1.0, 0.0, far], [0.0, 2.0, 0.0], [far, 0.0, 0.0]]
        assert found[1].first == [1.0, 0.0, 0.0]


@pytest.mark.parametrize("is_floating", [False, True])
def test_masses_may_be_known_later(is_floating: bool) -> None:
    """Parameters of a document become inputs of the code; forces are those of the numbers."""
    bodies = random_bodies(np.random.default_rng(11), 4, is_floating)
    known, graph = tree_of(bodies), Graph()
    numbers: dict[int, float] = {}

    def later(value: float) -> Term:
        unknown = graph.input()
        numbers[unknown.index] = value
        return unknown

    given = [
        MassMoments(
            [[float(x) for x in row] for row in body.second],
            [later(body.first[0]), body.first[1], later(body.first[2])],  # type: ignore[arg-type]
            later(body.mass),  # type: ignore[arg-type]
        )
        for body in mass_distributions(bodies)
    ]
    masses = masses_near_base(known.kinds, known.parents, known.rotations, known.positions, given)
    tree = Tree(known.parents, known.kinds, known.rotations, known.positions, masses, is_floating)
    generator = np.random.default_rng(3)
    q, qd, qdd = generator.uniform(-2.0, 2.0, (3, 4)).tolist()
    v0, g = (generator.uniform(-1.0, 1.0, 6) * is_floating).tolist(), [0.1, 0.2, -9.0]
    forces = inverse_dynamics(tree, Inputs(q, qd, qdd, [], v0, [0.0] * 6, g, []))
    base = (v0,) if is_floating else (None,)
    mechanics = Mechanics(bodies)
    M = mechanics.joint_space_inertia(q)[:, -4:]
    expected = M @ qdd + mechanics.bias_torque(q, qd, *base, g)
    np.testing.assert_allclose(evaluate(graph, numbers, forces), expected, rtol=1e-10, atol=1e-10)


def test_a_single_link_has_joints_of_its_own() -> None:
    tree = tree_of(random_bodies(np.random.default_rng(1), 1, is_floating=False))
    assert tree.parents == [0, 0]
    assert [*tree.links()] == [*tree.links_leaves_first()] == [1]
