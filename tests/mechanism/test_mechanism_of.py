"""From documents to numbers: inertia frames, bindings, and what is refused."""

from pathlib import Path

import numpy as np
import pytest
from tests.support.spatial import rotation_from_intrinsic_xyz

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.spatial.inertia import move_inertia
from kindsl.robots.mechanism.reading import reachable_linkage, whole_linkage

ROOT = Path(__file__).parents[2]

ARM = (ROOT / "examples" / "industrial_arm.kindsl").read_text()


def mechanism(text: str, **parameters: float) -> Mechanics:
    return kindsl.parse(text, Settings()).mechanism(parameters)


LINK = """Robot R {{
RobotBase b {{ children {{ l via j }} }}
link l {{ id = 1
inertia_params {{ mass = {m} CoM = ({c[0]}, {c[1]}, {c[2]})
Ix = {I[0]} Iy = {I[1]} Iz = {I[2]} Ixy = {I[3]} Ixz = {I[4]} Iyz = {I[5]} ref_frame = f }}
children {{}}
frames {{ f {{ translation = ({r[0]}, {r[1]}, {r[2]}) rotation = ({a[0]}, {a[1]}, {a[2]}) }} }} }}
r_joint j {{ ref_frame {{ translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }} }} }}"""


@pytest.mark.parametrize("seed", range(10))
def test_inertia_frame_holds_for_com_and_moments(seed: int) -> None:
    chance = np.random.default_rng(seed)
    m, c, r, a = 2.0, chance.normal(size=3), chance.normal(size=3), chance.uniform(-3, 3, 3)
    I = chance.normal(size=6)  # noqa: E741 (the field's letter)
    text = LINK.format(m=m, c=c.round(9), r=r.round(9), a=a.round(9), I=I.round(9))
    bodies = mechanism(text).bodies
    tensor = np.array([[I[0], -I[3], -I[4]], [-I[3], I[1], -I[5]], [-I[4], -I[5], I[2]]])
    com, inertia = move_inertia(np.array(m), c, tensor, rotation_from_intrinsic_xyz(a), r)
    np.testing.assert_allclose(bodies.coms[1], com, atol=1e-7)
    np.testing.assert_allclose(bodies.inertias[1], inertia, atol=1e-6)


def test_all_unbound_parameters_are_named() -> None:
    text = ARM.replace("mass = 8.058", "mass = m2")
    with pytest.raises(kindsl.UnboundParameterError, match="'m2', 'tool_length'") as caught:
        mechanism(text)
    assert caught.value.names == ("m2", "tool_length")
    assert mechanism(text, m2=1.0, tool_length=0.5).total_mass() == pytest.approx(10.642)


DEFECTS = {
    "there is no link 'nowhere'": ("upper_arm via", "nowhere via"),
    "there is no joint 'hinge'": ("via shoulder_lift", "via hinge"),
    "'shoulder' and 'upper_arm' have the same id 1": ("id = 2", "id = 1"),
    "no link has the id 2": ("id = 2", "id = 9"),
    "has the id 2, not greater than 3": ("id = 2", "id = 3", "id = 3", "id = 2"),
    "loop: shoulder -> upper_arm -> shoulder": ("forearm via elbow", "shoulder via elbow"),
    "loop: base -> shoulder -> upper_arm -> forearm -> base": ("wrist_1_link via", "base via"),
    "used twice": ("via wrist_3", "via wrist_2"),
    "has no frame 'nofr'": ("ref_frame = forearm_com", "ref_frame = nofr"),
    "'CoM' has no value": ("(-0.2125", "(1.0/0.0"),
    "inertia of 'shoulder': 'CoM' is missing": ("CoM = (0.0, -0.00193, -0.02561)", ""),
}  # fmt: skip


@pytest.mark.parametrize("message", DEFECTS)
def test_defects_are_told_with_their_names(message: str) -> None:
    changes = DEFECTS[message]
    text = ARM
    if len(changes) == 4:
        text = text.replace(changes[0], "id = @").replace(changes[2], changes[3])
        text = text.replace("id = @", changes[1])
    else:
        assert changes[0] in text
        text = text.replace(changes[0], changes[1], 1)
    with pytest.raises(kindsl.ModelError, match=message):
        mechanism(text, tool_length=0.1)


def test_drawing_needs_no_ids_and_passes_over_what_hangs_nowhere() -> None:
    text = ARM.replace("id = 2", "id = 1").replace("wrist_2_link via wrist_2", "")
    model = kindsl.parse(text, Settings()).model
    skeleton = reachable_linkage(model, {"tool_length": 0.1})
    assert skeleton.link_names == ("shoulder", "upper_arm", "forearm", "wrist_1_link")


def test_a_fixed_base_does_not_matter() -> None:
    moving = mechanism(ARM, tool_length=0.1)
    assert moving.total_mass() == pytest.approx(17.7)
    for mass in ("m0", "40.0"):
        other = mechanism(ARM.replace("mass = 4.0", f"mass = {mass}"), tool_length=0.1)
        assert np.array_equal(other.center_of_mass([0.1] * 6), moving.center_of_mass([0.1] * 6))
    floating = ARM.replace("RobotBase base", "RobotBase base floating")
    assert mechanism(floating, tool_length=0.1).total_mass() == pytest.approx(21.7)


def test_a_second_base_is_refused_in_a_sentence() -> None:
    text = ARM.replace("RobotBase", "RobotBase other { children {} }\nRobotBase", 1)
    with pytest.raises(kindsl.ModelError, match="there is a second base, '"):
        whole_linkage(kindsl.parse(text, Settings()).model, {})
