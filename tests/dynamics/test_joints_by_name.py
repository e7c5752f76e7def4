"""Values of joints by their names, as on the command line."""

from pathlib import Path

import numpy as np
import pytest

import kindsl

ARM = Path(__file__).parents[2] / "examples" / "industrial_arm.kindsl"


@pytest.fixture(scope="module")
def arm():
    return kindsl.load(ARM).mechanism()


def test_a_mapping_is_the_vector_that_it_names(arm) -> None:
    first, third = arm.joint_names[0], arm.joint_names[2]
    by_name, q = {third: 0.5, first: -1.0}, np.array([-1.0, 0.0, 0.5, 0.0, 0.0, 0.0])
    np.testing.assert_array_equal(arm.joint_space_inertia(by_name), arm.joint_space_inertia(q))
    tau = arm.inverse_dynamics(by_name, {first: 2.0}, {})
    zero = np.zeros(6)
    np.testing.assert_array_equal(tau, arm.inverse_dynamics(q, 2.0 * np.eye(6)[0], zero))
    tool = arm.link_names[-1]
    np.testing.assert_array_equal(arm.jacobian(by_name, tool), arm.jacobian(q, tool))
    np.testing.assert_array_equal(
        arm.forward_kinematics(by_name)[tool], arm.forward_kinematics(q)[tool]
    )
    assert arm.kinetic_energy(by_name, {first: 2.0}) == arm.kinetic_energy(q, 2.0 * np.eye(6)[0])


def test_values_may_be_batches(arm) -> None:
    first, third = arm.joint_names[0], arm.joint_names[2]
    M = arm.joint_space_inertia({first: np.linspace(0.0, 1.0, 5), third: 0.25})
    assert M.shape == (5, 6, 6)
    np.testing.assert_array_equal(M[4], arm.joint_space_inertia({first: 1.0, third: 0.25}))


def test_an_unknown_name_is_told(arm) -> None:
    name = arm.joint_names[0]
    with pytest.raises(ValueError, match=f"there is no joint '{name}x', did you mean '{name}'"):
        arm.joint_space_inertia({f"{name}x": 1.0})
    with pytest.raises(ValueError, match="not a real number"):
        arm.joint_space_inertia({name: "far"})


def test_names_in_public() -> None:
    document = kindsl.load(ARM)
    assert type(document) is kindsl.Document
    assert (type(document).__name__, type(document).__module__) == ("Document", "kindsl")
    assert dir(kindsl) == sorted(kindsl.__all__)
