"""What callers of the mechanics see: names, shapes, batches and errors."""

from dataclasses import replace

import numpy as np
import pytest
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.bodies import BodyFrame
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.quantities import SingularInertiaError

FIXED = Mechanics(random_bodies(np.random.default_rng(1), 4, is_floating=False))
FLOATING = Mechanics(random_bodies(np.random.default_rng(2), 4, is_floating=True))
Q = np.zeros(4)


@pytest.mark.parametrize("shape", [(), (2,), (2, 3), (0,), (100,), (5, 20)])
@pytest.mark.parametrize("mechanics", [FIXED, FLOATING])
def test_leading_dimensions_are_batches(mechanics: Mechanics, shape: tuple[int, ...]) -> None:
    q = np.full((*shape, 4), 0.3)
    nv = mechanics.bodies.n_velocities
    poses = mechanics.forward_kinematics(q)
    assert list(poses)[:4] == ["link1", "link2", "link3", "link4"]
    assert {pose.shape for pose in poses.values()} == {(*shape, 4, 4)}
    assert {pose.shape for pose in mechanics.joint_poses(q).values()} == {(*shape, 4, 4)}
    assert mechanics.jacobian(q, "link3").shape == (*shape, 6, nv)
    assert mechanics.joint_space_inertia(q).shape == (*shape, nv, nv)
    assert mechanics.center_of_mass(q).shape == (*shape, 3)
    assert mechanics.center_of_mass_jacobian(q).shape == (*shape, 3, nv)
    assert mechanics.gravity_torque(q).shape == (*shape, nv)
    assert mechanics.bias_torque(q, q).shape == (*shape, nv)
    assert mechanics.kinetic_energy(q, q).shape == shape
    assert mechanics.potential_energy(q).shape == shape


@pytest.mark.parametrize("method", ["inverse_dynamics", "forward_dynamics"])
@pytest.mark.parametrize("shape", [(), (2, 3), (0,), (100,)])
def test_results_depend_on_the_base_only(method: str, shape: tuple[int, ...]) -> None:
    q = np.full((*shape, 4), 0.3)
    assert getattr(FIXED, method)(q, q, q).shape == (*shape, 4)
    for arguments in ((), (np.zeros(6),), (np.ones(6), (0.0, 1.0, 2.0))):
        joints, base = getattr(FLOATING, method)(q, q, q, *arguments)
        assert joints.shape == (*shape, 4)
        assert base.shape == (*shape, 6)


@pytest.mark.parametrize("batch_shape", [(), (3,), (100,), (2, 50)])
def test_poses_are_a_mapping_by_name(batch_shape: tuple[int, ...]) -> None:
    q = np.full((*batch_shape, FIXED.bodies.n_links), 0.3)
    frames = [frame.name for frame in FIXED.bodies.frames]
    for poses in (FIXED.forward_kinematics(q), FIXED.forward_kinematics(q)):
        assert list(poses) == list(poses.keys()) == [*FIXED.bodies.link_names, *frames]
        assert len(poses) == len(list(poses))
        assert all(pose.shape == (*batch_shape, 4, 4) for pose in poses.values())
        assert repr(poses) == repr(dict(poses))
        with pytest.raises(KeyError):
            poses["nowhere"]


def test_poses_of_one_configuration_are_the_caller_s() -> None:
    q = np.full(FIXED.bodies.n_links, 0.3)
    FIXED.forward_kinematics(q)
    poses = FIXED.forward_kinematics(q)
    name = FIXED.bodies.link_names[0]
    poses[name][0, 3] = 7.0
    assert poses[name][0, 3] == 7.0
    assert FIXED.forward_kinematics(q)[name][0, 3] != 7.0


def test_arguments_broadcast() -> None:
    q, qd = np.linspace(0.0, 1.0, 12).reshape((3, 1, 4)), np.ones((2, 4))
    gravity = np.array([[0.0, 0.0, -9.81], [0.0, 0.0, -1.62]])
    bias = FLOATING.bias_torque(q, qd, np.ones(6), gravity)
    assert bias.shape == (3, 2, 10)
    one = FLOATING.bias_torque(q[2, 0], qd[1], np.ones(6), gravity[1])
    assert bias[2, 1] == pytest.approx(one, rel=1e-12)


def test_lists_and_integers_are_taken() -> None:
    assert FIXED.gravity_torque([0, 0, 0, 0]) == pytest.approx(FIXED.gravity_torque(Q))
    assert FIXED.gravity_torque(Q.astype(np.float32)) == pytest.approx(FIXED.gravity_torque(Q))


def test_a_second_call_gives_the_same_numbers() -> None:
    q = np.linspace(0.1, 0.7, 4)
    first, second = FIXED.inverse_dynamics(q, q, q), FIXED.inverse_dynamics(q, q, q)
    assert np.array_equal(np.asarray(first), np.asarray(second))
    first_poses, second_poses = FIXED.forward_kinematics(q), FIXED.forward_kinematics(q)
    first_poses["link1"][:] = 0.0
    assert second_poses["link1"][3, 3] == 1.0


def test_poses_join_the_frames() -> None:
    q = np.linspace(0.1, 0.7, 4)
    poses = FIXED.forward_kinematics(q)
    for frame in FIXED.bodies.frames:
        names = (FIXED.bodies.base_name, *FIXED.bodies.link_names)
        carrier = poses.get(names[frame.body], np.eye(4))
        assert poses[frame.name][:3, 3] == pytest.approx(
            carrier[:3, :3] @ frame.body_r_frame + carrier[:3, 3]
        )


@pytest.mark.parametrize("mechanics", [FIXED, FLOATING])
def test_a_joint_is_where_its_link_is_at_zero(mechanics: Mechanics) -> None:
    """Whatever the positions of the other joints."""
    bodies, q = mechanics.bodies, np.linspace(0.1, 0.7, 4)
    joints = mechanics.joint_poses(q)
    assert [*joints] == [*mechanics.joint_names] == [*bodies.joint_names]
    assert mechanics.link_names == bodies.link_names
    for index, (joint, link) in enumerate(zip(bodies.joint_names, bodies.link_names, strict=True)):
        at_zero = q * (np.arange(4) != index)
        pose = mechanics.forward_kinematics(at_zero)[link]
        np.testing.assert_allclose(joints[joint], pose, atol=1e-14)


def test_masses_add_up() -> None:
    masses = FLOATING.subtree_masses()
    assert masses["base"] == pytest.approx(FLOATING.total_mass())
    assert masses["link4"] == pytest.approx(FLOATING.bodies.masses[4])


@pytest.mark.parametrize(
    ("q", "message"),
    [
        (np.zeros(3), r"'q' has shape \(3,\), expected \(\.\.\., 4\)"),
        (np.zeros((4, 3)), r"'q' has shape \(4, 3\), expected \(\.\.\., 4\)"),
        (1.0, r"'q' has shape \(\), expected \(\.\.\., 4\)"),
        ("abcd", "'q' holds something that is not a real number"),
        ([1.0, 2.0, [3.0], 4.0], "'q' holds something that is not a real number"),
        ([1.0, 2.0, 3.0, 4.0j], "'q' holds something that is not a real number"),
        ([0.0, np.nan, 0.0, 0.0], "'q' holds a value that is not finite"),
        ([0.0, 0.0, 0.0, np.inf], "'q' holds a value that is not finite"),
        (np.full((100, 4), np.nan), "'q' holds a value that is not finite"),
    ],
)
def test_wrong_positions_are_named(q: object, message: str) -> None:
    FIXED.joint_space_inertia(Q)
    with pytest.raises(ValueError, match=message):
        FIXED.joint_space_inertia(q)  # type: ignore[arg-type]


def test_values_too_large_are_refused() -> None:
    with pytest.raises(ValueError, match="'q', 'qd': the values are too large"):
        FIXED.bias_torque(np.full(4, 1e308), Q)


def test_the_wrong_argument_is_named() -> None:
    with pytest.raises(ValueError, match=r"'qdd' has shape \(5,\), expected \(\.\.\., 4\)"):
        FIXED.inverse_dynamics(Q, Q, np.zeros(5))
    with pytest.raises(ValueError, match="'tau' holds a value that is not finite"):
        FIXED.forward_dynamics(Q, Q, np.full(4, np.nan))
    with pytest.raises(ValueError, match=r"'gravity' has shape \(2,\), expected \(\.\.\., 3\)"):
        FIXED.gravity_torque(Q, (0.0, 1.0))
    with pytest.raises(
        ValueError, match=r"'base_velocity' has shape \(3,\), expected \(\.\.\., 6\)"
    ):
        FLOATING.bias_torque(Q, Q, np.zeros(3))


def test_batches_that_do_not_go_together_are_named() -> None:
    message = r"cannot be broadcast: 'q' \(2, 4\), 'qd' \(3, 4\)$"
    with pytest.raises(ValueError, match=message):
        FIXED.bias_torque(np.zeros((2, 4)), np.zeros((3, 4)))
    with pytest.raises(ValueError, match=message):
        FIXED.kinetic_energy(np.zeros((2, 4)), np.zeros((3, 4)))


def test_a_fixed_base_does_not_move() -> None:
    with pytest.raises(ValueError, match="'base_velocity' is given, but the base is fixed"):
        FIXED.bias_torque(Q, Q, np.zeros(6))
    with pytest.raises(ValueError, match="'base_velocity' is given, but the base is fixed"):
        FIXED.kinetic_energy(Q, Q, np.zeros(6))


def test_an_unknown_name_gets_the_nearest() -> None:
    with pytest.raises(ValueError, match="there is no link or frame 'lnk3', did you mean 'link3'"):
        FIXED.jacobian(Q, "lnk3")


def test_the_base_has_a_jacobian_too() -> None:
    assert not FIXED.jacobian(Q, "base").any()
    assert np.array_equal(FLOATING.jacobian(Q, "base")[:, :6], np.eye(6))


@pytest.mark.parametrize("n_configurations", [1, 3, 100])
@pytest.mark.parametrize("is_floating", [False, True])
def test_what_nothing_resists_is_an_error(is_floating: bool, n_configurations: int) -> None:
    bodies = random_bodies(np.random.default_rng(0), 2, is_floating)
    massless = Mechanics(
        replace(bodies, masses=np.zeros(3), coms=np.zeros((3, 3)), inertias=np.zeros((3, 3, 3)))
    )
    q = np.zeros((n_configurations, 2))
    with pytest.raises(SingularInertiaError, match="the inertia matrix is singular"):
        massless.forward_dynamics(q, q, q)
    with pytest.raises(ValueError, match="total mass is zero"):
        massless.center_of_mass(q)
    with pytest.raises(ValueError, match="total mass is zero"):
        massless.center_of_mass_jacobian(q)
    if is_floating:
        with pytest.raises(SingularInertiaError, match="the inertia matrix is singular"):
            massless.inverse_dynamics(q, q, q)


@pytest.mark.parametrize("is_floating", [False, True])
@pytest.mark.parametrize("n_configurations", [1, 60])
def test_the_joint_that_nothing_resists_is_named(is_floating: bool, n_configurations: int) -> None:
    bodies = random_bodies(np.random.default_rng(4), 3, is_floating)
    leaf = max(range(1, 4), key=lambda body: body not in bodies.parents[1:])
    masses, coms, inertias = bodies.masses.copy(), bodies.coms.copy(), bodies.inertias.copy()
    masses[leaf], coms[leaf], inertias[leaf] = 0.0, 0.0, 0.0
    mechanics = Mechanics(replace(bodies, masses=masses, coms=coms, inertias=inertias))
    q = np.full((n_configurations, 3), 0.3)
    told = f"nothing resists motion of joint '{bodies.joint_names[leaf - 1]}'"
    with pytest.raises(SingularInertiaError, match=told):
        mechanics.forward_dynamics(q, q, q)
    with pytest.raises(SingularInertiaError, match=told):
        mechanics.forward_dynamics_derivatives(q, q, q)


def test_names_never_enter_generated_code() -> None:
    evil = '"); raise SystemExit("'
    bodies = random_bodies(np.random.default_rng(0), 2, is_floating=True)
    named = replace(
        bodies,
        base_name="\n",
        link_names=(evil, "x"),
        joint_names=(evil, "x"),
        frames=(BodyFrame("'", 1, np.eye(3), np.zeros(3)),),
    )
    assert set(Mechanics(named).forward_kinematics(np.zeros(2))) == {evil, "x", "'"}
    assert len(Mechanics(named).forward_kinematics(np.zeros((100, 2)))) == 3
