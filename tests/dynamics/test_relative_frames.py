"""Poses and Jacobians of one frame seen from another, against poses seen from the base."""

import math
from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from tests.codegen.robots import bodies_of_seed

from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.generation.emitters.numbers import evaluate
from kindsl.mechanics.dynamics.generation.function import Function, Inputs, inputs_of
from kindsl.mechanics.dynamics.generation.jacobians import feet
from kindsl.mechanics.dynamics.generation.relative_frames import (
    between,
    relative_columns,
    relative_jacobians,
    relative_poses,
)
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame, Robot, robot_of
from kindsl.mechanics.dynamics.generation.terms import Term, needed
from kindsl.mechanics.dynamics.generation.vectors import EYE, ZERO
from kindsl.mechanics.spatial.arrays import Array

STEP = 1e-6
SEEDS = (4, 7, 12, 31)


def _recorded(seed: int) -> tuple[Robot, Inputs, Mechanics, Array]:
    bodies = bodies_of_seed(seed)
    robot = robot_of(bodies)
    q = np.random.default_rng(seed).uniform(-2.0, 2.0, bodies.n_links)
    return robot, inputs_of(robot), Mechanics(bodies), q


def _result(robot: Robot, inputs: Inputs, function: Function, q: Array) -> Array:
    assert [argument.name for argument in function.arguments] == ["q"]
    (result,) = function.results
    numbers = {x.index: value for x, value in zip(inputs.q, q, strict=True)}  # type: ignore[union-attr]
    return np.array(evaluate(robot.graph, numbers, result.entries)).reshape(result.shape)


def _seen(mechanics: Mechanics, q: Array, base: PlacedFrame, target: PlacedFrame) -> Array:
    poses = mechanics.forward_kinematics(q)
    seen: Array = np.linalg.inv(poses[base.name]) @ poses[target.name]
    return seen


@pytest.mark.parametrize("seed", SEEDS)
def test_a_pose_is_that_in_the_base_seen_from_the_other(seed: int) -> None:
    robot, inputs, mechanics, q = _recorded(seed)
    pairs = list(product(robot.targets, robot.targets))
    functions = relative_poses(robot, inputs, pairs)
    for (base, target), function in zip(pairs, functions, strict=True):
        assert function.name == f"pose_{target.name}_in_{base.name}"
        assert function.about == (target.name, base.name)
        found = _result(robot, inputs, function, q)
        np.testing.assert_allclose(found, _seen(mechanics, q, base, target)[:3], atol=1e-12)


@pytest.mark.parametrize("seed", SEEDS)
def test_only_the_joints_between_two_frames_matter(seed: int) -> None:
    """To their pose and Jacobian, however far both are from the base."""
    robot, inputs, _, _ = _recorded(seed)
    q = {
        term.index: joint for joint, term in enumerate(inputs.q, start=1) if isinstance(term, Term)
    }
    for base, target in product(robot.targets, robot.targets):
        pair = [(base, target)]
        functions = [
            *relative_poses(robot, inputs, pair), *relative_jacobians(robot, inputs, pair),
        ]  # fmt: skip
        for function in functions:
            used = {q[i] for i in needed(robot.graph, function.results[0].entries) if i in q}
            assert used <= {*between(robot, base, target)}, function.name


@pytest.mark.parametrize("seed", SEEDS)
def test_a_jacobian_is_the_slope_of_the_pose(seed: int) -> None:
    """Its columns are those of the joints that move one frame against the other, and no others."""
    robot, inputs, mechanics, q = _recorded(seed)
    pairs = list(product(robot.targets, robot.targets))
    functions = {function.name: function for function in relative_jacobians(robot, inputs, pairs)}
    for base, target in pairs:
        slopes = _slopes(mechanics, q, base, target)
        moving = [joint for joint, slope in slopes.items() if abs(slope).max() > 1e-7]
        name = f"jacobian_{target.name}_in_{base.name}"
        joints = between(robot, base, target)
        assert {*moving} <= {*joints}
        assert (name in functions) == bool(joints)
        if joints:
            assert functions[name].about == (target.name, base.name)
            found = _result(robot, inputs, functions[name], q)
            expected = np.stack([slopes[joint] for joint in joints], axis=1)
            np.testing.assert_allclose(found, expected, atol=1e-7)


def _slopes(
    mechanics: Mechanics, q: Array, base: PlacedFrame, target: PlacedFrame
) -> dict[int, Array]:
    """Return what each joint's rate makes of a frame's pose: turning, then motion of its origin."""
    R = _seen(mechanics, q, base, target)[:3, :3]
    slopes = {}
    for joint, step in enumerate(STEP * np.eye(len(q)), start=1):
        ahead, behind = (_seen(mechanics, q + s * step, base, target) for s in (1.0, -1.0))
        rate = (ahead - behind) / (2.0 * STEP)
        turning = rate[:3, :3] @ R.T
        around = [turning[2, 1], turning[0, 2], turning[1, 0]]
        slopes[joint] = np.array([*around, *rate[:3, 3]])
    return slopes


@pytest.mark.parametrize("seed", SEEDS)
def test_a_foot_is_what_carries_nothing(seed: int) -> None:
    robot, inputs, mechanics, q = _recorded(seed)
    carrying = {*mechanics.bodies.parents}
    ends = {body for body in range(1, mechanics.n_joints + 1) if body not in carrying}
    assert {foot.body for foot in feet(robot)} == ends
    assert len(feet(robot)) == len(ends)
    for foot in feet(robot):
        on_it = [frame for frame in robot.frames if frame.body == foot.body]
        assert foot in on_it or not on_it
        assert all(math.hypot(*frame.r) <= math.hypot(*foot.r) for frame in on_it)
    chosen = replace(robot, chosen=robot.frames)
    assert feet(chosen) == tuple(frame for frame in robot.frames if frame.body in ends)
    numbers = {x.index: value for x, value in zip(inputs.q, q, strict=True)}  # type: ignore[union-attr]
    poses = mechanics.forward_kinematics(q)
    base = PlacedFrame(robot.base_name, 0, EYE, ZERO)
    for foot in feet(robot):
        columns_of_foot = relative_columns(robot, inputs.q, base, foot)
        found = np.array([evaluate(robot.graph, numbers, x) for x in columns_of_foot]).T
        R = poses[foot.name][:3, :3]
        own = mechanics.jacobian(q, foot.name)[:, -mechanics.n_joints :]
        expected = np.concatenate((R @ own[:3], R @ own[3:]))
        columns = [joint - 1 for joint in mechanics.bodies.support(foot.body)[::-1]]
        np.testing.assert_allclose(found, expected[:, columns], atol=1e-12)


def test_a_frame_on_the_base_has_a_jacobian_without_columns() -> None:
    robot, inputs, _, _ = _recorded(4)
    here, there = (PlacedFrame(name, 0, EYE, [x, 0.0, 0.0]) for name, x in (("a", 0.1), ("b", 0.2)))
    assert relative_columns(robot, inputs.q, here, there) == []
