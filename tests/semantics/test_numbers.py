"""What is written, as numbers, and what of it is kept."""

from math import pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.language.semantics.declarations import Inertia, Joint
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.numbers import BODIES, POSES, mass_distribution, triple, written_pose
from kindsl.language.syntax.document import parse
from kindsl.mechanics.rigid.pose import pose_from

POSE = "r_joint j {{ ref_frame {{ translation = ({0}, 2.0, 3.0) rotation = (0.0, {1}, 0.0) }} }}"
BODY = """link a {{ id = 1 inertia_params {{ mass = {0} CoM = (0.0, {1}, 0.3)
    Ix = 0.1 Iy = 0.2 Iz = {2} Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }} children {{}} }}"""


def _joint(*values: str) -> Joint:
    return next(j for i in parse(POSE.format(*values)).islands for j in declarations(i).joints)


def _inertia(*values: str) -> Inertia:
    links = (k for i in parse(BODY.format(*values)).islands for k in declarations(i).links)
    inertia = next(links).inertia
    assert inertia is not None
    return inertia


def _is_kept(thing: Joint | Inertia) -> bool:
    if isinstance(thing, Inertia):
        return thing in (thing.island.facts.get(BODIES) or {})
    return thing.pose.translation in (thing.island.facts.get(POSES) or {})


def test_numbers_alone_are_computed_once() -> None:
    joint, inertia = _joint("1.0", "PI/2.0"), _inertia("2.0", "0.1", "0.3")
    pose = written_pose(joint.pose, {})
    assert pose == pose_from((1.0, 2.0, 3.0), (0.0, pi / 2.0, 0.0))
    assert written_pose(joint.pose, {}) is pose
    body = mass_distribution(inertia, {})
    assert body == (2.0, (0.0, 0.1, 0.3), (0.1, 0.2, 0.3, 0.0, 0.0, 0.0))
    assert mass_distribution(inertia, {}) is body
    assert _is_kept(joint) and _is_kept(inertia)


@settings(max_examples=40, deadline=None, derandomize=True)
@given(st.lists(st.floats(-5.0, 5.0), min_size=1, max_size=4))
def test_what_names_are_in_follows_their_values(values: list[float]) -> None:
    joint, inertia = _joint("a", "0.0"), _inertia("a", "0.1", "<i 0.3>")
    for value in values:
        pose, body = (
            written_pose(joint.pose, {"a": value}),
            mass_distribution(inertia, {"a": value, "<i>": value + 1.0}),
        )
        assert pose is not None and pose.translation == (value, 2.0, 3.0)
        assert body is not None and (body.mass, body.moments[2]) == (value, value + 1.0)
    assert not _is_kept(joint) and not _is_kept(inertia)
    assert written_pose(joint.pose, {}) is None
    assert mass_distribution(inertia, {"<i>": 1.0}) is None


@pytest.mark.parametrize("value", ["1e999", "-1e999", ""])
def test_what_is_no_finite_number_is_not_there(value: str) -> None:
    joint = _joint(value, "0.0")
    assert triple(joint.pose.translation, {}) is None
    assert written_pose(joint.pose, {}) is None
    for place in range(3):
        numbers = ["1.0", "1.0", "1.0"]
        numbers[place] = value
        assert mass_distribution(_inertia(*numbers), {}) is None


def test_the_largest_numbers_are_numbers_too() -> None:
    """Though their sum is not finite."""
    text = BODY.format("1.5e308", "0.0", "1.5e308").replace("Iy = 0.2", "Iy = 1.5e308")
    (link,) = (k for i in parse(text).islands for k in declarations(i).links)
    assert link.inertia is not None
    body = mass_distribution(link.inertia, {})
    assert body is not None and body.mass == body.moments[1] == body.moments[2] == 1.5e308


@pytest.mark.parametrize("lost", ["Ixz = 0.0", "mass = 1.0"])
def test_a_body_without_a_mass_or_a_moment_is_not_known(lost: str) -> None:
    text = BODY.format("1.0", "0.0", "1.0").replace(lost, "")
    links = (k for i in parse(text).islands for k in declarations(i).links)
    inertia = next(links).inertia
    assert inertia is not None and mass_distribution(inertia, {}) is None


@pytest.mark.parametrize(
    "left_out", ["translation = (1.0, 2.0, 3.0)", "rotation = (0.0, 0.0, 0.0)"]
)
def test_a_pose_without_a_vector_is_not_known(left_out: str) -> None:
    text = POSE.format("1.0", "0.0")
    assert left_out in text
    joints = (j for i in parse(text.replace(left_out, "")).islands for j in declarations(i).joints)
    assert written_pose(next(joints).pose, {}) is None
