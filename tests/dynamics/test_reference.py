"""Documents give the stored reference numbers, see the README beside these."""

import json
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from tests.support.documents import REFERENCE
from tests.support.published import CORPUS, published

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics

# The reference was computed in double precision, RobCoGen's code in single.
TOLERANCE = 1e-9
SINGLE = 3e-6


def references() -> Iterator[object]:
    for path in sorted(REFERENCE.glob("*.json")):
        yield pytest.param(path, id=path.stem)
    for path in sorted((REFERENCE / "published").glob("*.json")):
        yield pytest.param(path, id=path.stem, marks=published)


@pytest.fixture(scope="module", params=references())
def reference(request: pytest.FixtureRequest) -> dict[str, Any]:
    stored: dict[str, Any] = json.loads(request.param.read_text(encoding="utf-8"))
    folder = CORPUS if request.param.parent.name == "published" else REFERENCE
    stored["text"] = (folder / stored["source"]).read_text(encoding="utf-8")
    return stored


@pytest.fixture(scope="module")
def mechanics(reference: dict[str, Any]) -> Mechanics:
    return kindsl.parse(reference["text"], Settings()).mechanism({})


def test_numbers_are_those_of_the_reference(
    reference: dict[str, Any], mechanics: Mechanics
) -> None:
    assert mechanics.bodies.is_floating == reference["floating"]
    for configuration in reference["configurations"]:
        q, qd, qdd = (np.array(configuration[name]) for name in ("q", "qd", "qdd"))
        _compare(configuration, _computed(mechanics, q, qd, qdd, configuration["base_vel"]))


def test_batches_give_the_same_numbers(reference: dict[str, Any], mechanics: Mechanics) -> None:
    repeats = 60
    for configuration in reference["configurations"]:
        q, qd, qdd = (np.array([configuration[name]] * repeats) for name in ("q", "qd", "qdd"))
        computed = _computed(mechanics, q, qd, qdd, configuration["base_vel"])
        last = {name: values[-1] for name, values in computed.items()}
        _compare(configuration, last)


def test_numbers_are_those_of_generated_code(
    reference: dict[str, Any], mechanics: Mechanics
) -> None:
    for configuration in reference["configurations"]:
        theirs = configuration.get("robcogen_octave")
        if theirs is not None:
            q, qd, qdd = (np.array(configuration[name]) for name in ("q", "qd", "qdd"))
            ours = _computed(mechanics, q, qd, qdd, configuration["base_vel"])
            np.testing.assert_allclose(ours["M"], theirs["M"], rtol=0, atol=SINGLE)
            for name, pose in theirs["poses"].items():
                np.testing.assert_allclose(ours[name], pose, rtol=0, atol=SINGLE)


def _computed(
    mechanics: Mechanics, q: np.ndarray, qd: np.ndarray, qdd: np.ndarray, base_vel: Any
) -> dict[str, np.ndarray]:
    v = base_vel if mechanics.bodies.is_floating else None
    computed = {
        "M": mechanics.joint_space_inertia(q),
        "gravity_torque": mechanics.gravity_torque(q),
        "bias": mechanics.bias_torque(q, qd, v),
        **mechanics.forward_kinematics(q),
    }
    result = mechanics.inverse_dynamics(q, qd, qdd, v)
    if isinstance(result, tuple):
        computed["tau"], computed["base_acc"] = result
    else:
        computed["tau"] = result
    return computed


def _compare(configuration: dict[str, Any], computed: dict[str, np.ndarray]) -> None:
    for name, expected in _expected(configuration):
        error = abs(computed[name] - expected).max()
        assert error < TOLERANCE, f"{name}: {error:.1e}"


def _expected(configuration: dict[str, Any]) -> Iterator[tuple[str, np.ndarray]]:
    for name in ("M", "gravity_torque", "bias"):
        yield name, np.array(configuration[name])
    # The stored forces of a floating base begin with the wrench on it, which is zero.
    yield "tau", np.array(configuration["tau"])[-len(configuration["q"]) :]
    if configuration["base_acc"] is not None:
        yield "base_acc", np.array(configuration["base_acc"])
    for name, pose in (configuration["poses"] | configuration["frame_poses"]).items():
        yield name, np.array(pose)
