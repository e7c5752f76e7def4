"""External forces, a given acceleration of the base, and motions between poses and frames."""

import inspect
from itertools import pairwise

import numpy as np
import pytest
from tests.codegen.robots import bodies_of_seed
from tests.dynamics.random_bodies import random_bodies

import kindsl
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics

SHAPES = [(), (3,), (2, 45), (0,)]


def _state(n: int, shape: tuple[int, ...]) -> np.ndarray:
    return np.random.default_rng(n).uniform(-1.0, 1.0, (3, *shape, n))


def _powers(mechanics: Mechanics, q: np.ndarray, wrenches: np.ndarray) -> np.ndarray:
    """Return what the wrenches on all links do for each velocity variable."""
    first = mechanics.bodies.n_velocities - mechanics.n_joints
    total = np.zeros((*q.shape[:-1], mechanics.bodies.n_velocities))
    total[..., :first] += wrenches[..., 0, :first]
    for number, name in enumerate(mechanics.link_names, start=1):
        J = mechanics.jacobian(q, name)
        total = total + np.einsum("...ij,...i->...j", J, wrenches[..., number, :])
    return total


@pytest.mark.parametrize("seed", [4, 7, 31, 12])
@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("generates_code", [True, False])
def test_external_forces_are_those_of_jacobians(
    seed: int, shape: tuple[int, ...], generates_code: bool
) -> None:
    bodies = bodies_of_seed(seed)
    mechanics = Mechanics(bodies, generates_code=generates_code)
    q, qd, qdd = _state(bodies.n_links, shape)
    v = np.full(6, 0.3) if bodies.is_floating else None
    a = np.linspace(-1.0, 1.0, 6) if bodies.is_floating else None
    wrenches = np.random.default_rng(1).uniform(-5.0, 5.0, (bodies.n_links + 1, 6))
    loads = _powers(mechanics, q, wrenches)
    given = {} if a is None else {"base_acceleration": a}
    free = mechanics.inverse_dynamics(q, qd, qdd, v, **given)
    loaded = mechanics.inverse_dynamics(q, qd, qdd, v, external_forces=wrenches, **given)
    if a is None:
        np.testing.assert_allclose(free - loaded, loads, atol=1e-9)
    else:
        np.testing.assert_allclose(free.tau - loaded.tau, loads[..., 6:], atol=1e-9)
        np.testing.assert_allclose(free.base_wrench - loaded.base_wrench, loads[..., :6], atol=1e-9)


@pytest.mark.parametrize("seed", [4, 7])
@pytest.mark.parametrize("shape", SHAPES, ids=str)
def test_forward_dynamics_inverts_inverse_dynamics_under_load(
    seed: int, shape: tuple[int, ...]
) -> None:
    bodies = bodies_of_seed(seed)
    mechanics = Mechanics(bodies)
    q, qd, qdd = _state(bodies.n_links, shape)
    wrenches = np.random.default_rng(1).uniform(-5.0, 5.0, (*shape, bodies.n_links + 1, 6))
    forces = mechanics.inverse_dynamics(q, qd, qdd, external_forces=wrenches)
    tau = forces.tau if bodies.is_floating else forces
    found = mechanics.forward_dynamics(q, qd, tau, external_forces=wrenches)
    np.testing.assert_allclose(found.qdd if bodies.is_floating else found, qdd, atol=1e-8)
    if bodies.is_floating:
        np.testing.assert_allclose(found.base_acceleration, forces.base_acceleration, atol=1e-8)
        held = mechanics.inverse_dynamics(
            q, qd, qdd, external_forces=wrenches, base_acceleration=forces.base_acceleration
        )
        np.testing.assert_allclose(held.base_wrench, np.zeros((*shape, 6)), atol=1e-9)
        np.testing.assert_allclose(held.tau, tau, atol=1e-9)


def test_wrong_loads_are_named() -> None:
    fixed, q = Mechanics(bodies_of_seed(4)), np.zeros(bodies_of_seed(4).n_links)
    with pytest.raises(ValueError, match="'base_acceleration' is given, but the base is fixed"):
        fixed.inverse_dynamics(q, q, q, base_acceleration=np.zeros(6))
    n = len(q) + 1
    with pytest.raises(ValueError, match=rf"\(6,\), expected \(..., {n}, 6\)"):
        fixed.forward_dynamics(q, q, q, external_forces=np.zeros(6))


@pytest.mark.parametrize("seed", [4, 7, 31])
def test_a_relative_jacobian_is_a_difference(seed: int) -> None:
    bodies = random_bodies(np.random.default_rng(seed), 5, is_floating=bool(seed % 2))
    mechanics, step = Mechanics(bodies), 1e-6
    first = bodies.n_velocities - bodies.n_links
    q = np.random.default_rng(1).uniform(-1.0, 1.0, bodies.n_links)
    names = [*bodies.link_names, *(frame.name for frame in bodies.frames)]

    def relative(q: np.ndarray, base: str, target: str) -> np.ndarray:
        poses = mechanics.forward_kinematics(q)
        return np.linalg.inv(poses[base]) @ poses[target]

    for base, target in pairwise(names):
        J, here = mechanics.relative_jacobian(q, base, target), relative(q, base, target)
        assert not J[:, :first].any()
        for joint in range(bodies.n_links):
            ends = [relative(q + sign * step * np.eye(len(q))[joint], base, target)
                    for sign in (-1.0, 1.0)]  # fmt: skip
            slope = kindsl.pose_error(*ends) / (2.0 * step)
            turned = np.concatenate((here[:3, :3] @ slope[:3], here[:3, :3] @ slope[3:]))
            np.testing.assert_allclose(J[:, first + joint], turned, atol=1e-7)


@pytest.mark.parametrize("angle", [0.0, 1e-12, 1e-8, 0.9e-4, 1.1e-4, 0.5, 3.0, np.pi - 1e-7])
def test_a_motion_leads_where_the_error_says(angle: float) -> None:
    generator = np.random.default_rng(3)
    axes = generator.normal(size=(20, 3))
    axes[:3] = np.eye(3)
    motions = np.concatenate(
        (angle * axes / np.linalg.norm(axes, axis=-1)[:, None], generator.normal(size=(20, 3))),
        axis=-1,
    )
    robot = Mechanics(random_bodies(generator, 2, is_floating=True))
    start = robot.integrate(np.zeros(2), np.zeros(2), 1.0, None, generator.normal(size=6)).base_pose
    moved = robot.integrate(np.ones(2), np.ones(2), 0.5, start, 2.0 * motions)
    np.testing.assert_allclose(moved.q, np.full((20, 2), 1.5))
    R = moved.base_pose[..., :3, :3]
    np.testing.assert_allclose(R @ np.swapaxes(R, -1, -2), np.eye(3) + 0.0 * R, atol=1e-14)
    found = kindsl.pose_error(start, moved.base_pose)
    np.testing.assert_allclose(found, motions, rtol=0.0, atol=1e-9 if angle > 3.0 else 1e-14)


def test_a_half_turn_has_an_axis() -> None:
    start = np.eye(4)
    for axis in np.eye(3):
        turned = np.eye(4)
        turned[:3, :3] = 2.0 * np.outer(axis, axis) - np.eye(3)
        assert abs(kindsl.pose_error(start, turned)[:3]) == pytest.approx(np.pi * axis)


def test_a_fixed_base_only_moves_its_joints() -> None:
    robot = Mechanics(random_bodies(np.random.default_rng(1), 3, is_floating=False))
    np.testing.assert_allclose(
        robot.integrate([1.0, 2.0, 3.0], [1.0, 0.0, -1.0], 0.1), [1.1, 2, 2.9]
    )
    with pytest.raises(ValueError, match="the base is fixed"):
        robot.integrate(np.zeros(3), np.zeros(3), 0.1, None, np.zeros(6))


def test_configurations_and_base_poses_have_one_batch_shape() -> None:
    robot, rest = Mechanics(random_bodies(np.random.default_rng(1), 3, is_floating=True)), [0.0] * 3
    poses = np.zeros((5, 4, 4)) + np.eye(4)
    for given in ((np.zeros((5, 3)), rest, 0.1), (rest, rest, 0.1, poses)):
        q, base_pose = robot.integrate(*given)
        assert (q.shape, base_pose.shape) == ((5, 3), (5, 4, 4))
    with pytest.raises(ValueError, match="the batch dimensions cannot be broadcast"):
        robot.integrate(np.zeros((4, 3)), rest, 0.1, poses)


@pytest.mark.parametrize(
    ("pose", "message"),
    [
        (np.eye(3), r"has shape \(3, 3\), expected \(..., 4, 4\)"),
        (np.zeros(4), r"has shape \(4,\), expected \(..., 4, 4\)"),
        (np.full((4, 4), np.nan), "holds a value that is not finite"),
        ("a", "holds something that is not a real number"),
    ],
)
def test_what_is_no_pose_is_named(pose: object, message: str) -> None:
    robot, rest = Mechanics(random_bodies(np.random.default_rng(1), 3, is_floating=True)), [0.0] * 3
    with pytest.raises(ValueError, match=f"^'base_pose' {message}$"):
        robot.integrate(rest, rest, 0.1, pose)
    for number, name in enumerate(("A_T_B", "A_T_C")):
        given = [np.eye(4), np.eye(4)]
        given[number] = pose
        with pytest.raises(ValueError, match=f"^'{name}' {message}$"):
            kindsl.pose_error(*given)


def test_a_step_in_time_refuses_what_it_would_lose() -> None:
    robot, rest = (
        Mechanics(random_bodies(np.random.default_rng(1), 3, is_floating=False)),
        [0.0] * 3,
    )
    with pytest.raises(ValueError, match="'base_pose' is given, but the base is fixed"):
        robot.integrate(rest, rest, 0.1, np.eye(4))
    with pytest.raises(ValueError, match="'dt' holds a value that is not finite"):
        robot.integrate(rest, rest, np.nan)


def test_help_names_the_types_of_poses() -> None:
    signature = "(A_T_B: 'npt.ArrayLike', A_T_C: 'npt.ArrayLike') -> 'Array'"
    assert str(inspect.signature(kindsl.pose_error)) == signature
