"""Published models give the stored reference numbers.

Where the folder with the numbers is absent, the tests are skipped.
"""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kindsl.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanism.build import mechanism_of
from kindsl.semantics.model import Model
from kindsl.syntax.document import parse

SHARED = Path(__file__).parents[2] / ".." / "shared"
REFERENCE, CORPUS = SHARED / "reference", SHARED / "corpus"
MODELS = ("ur5_rmt", "hyq", "anymal")
# The reference was computed in double precision; entries are below 1000.
TOLERANCE = 1e-9

pytestmark = pytest.mark.skipif(not REFERENCE.is_dir(), reason=f"{REFERENCE} is not there")


@pytest.fixture(scope="module", params=MODELS)
def reference(request: pytest.FixtureRequest) -> dict[str, Any]:
    stored: dict[str, Any] = json.loads((REFERENCE / f"{request.param}.json").read_text())
    return stored


@pytest.fixture(scope="module")
def mechanics(reference: dict[str, Any]) -> Mechanics:
    text = (CORPUS / reference["source"]).read_text()
    return mechanism_of(Model(parse(text).islands), {})


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
