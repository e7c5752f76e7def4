"""What has a pose or a length, also while someone types."""

import pytest

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.rules.geometry import lengths, posed_things, rotations
from kindsl.judgement.rules.tiny_values import is_negligible, is_tiny
from kindsl.language.semantics.declarations import Declarations

BODY = """link arm { id = 1
    inertia_params { mass = 1.0 %s Ix=0.1 Iy=0.1 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children {}
    frames { tool { %s %s } }
}"""
PLACE, TURN = "translation = (0.1, 0.0, 0.0)", "rotation = (0.2, 0.0, 0.0)"
JOINT = f"r_joint j {{ ref_frame {{ {PLACE} {TURN} }} }}"


def declared(block: str) -> Declarations:
    model = analyse(f"Robot R {{ RobotBase b {{ children {{ arm via j }} }}\n{block}\n}}").model
    return next(d for d in model.declared if d.links or d.joints)


def first_values(vectors) -> list[float]:
    return [vector.components[0].literal for vector in vectors]


@pytest.mark.parametrize("place", [PLACE, ""])
@pytest.mark.parametrize("turn", [TURN, ""])
@pytest.mark.parametrize("com", ["CoM = (0.3, 0.0, 0.0)", ""])
def test_what_is_missing_has_no_length_and_no_angle(place: str, turn: str, com: str) -> None:
    body = declared(BODY % (com, place, turn))
    assert len(list(posed_things(body))) == 1
    assert first_values(rotations(body)) == [0.2] * bool(turn)
    assert first_values(lengths(body)) == [0.1] * bool(place) + [0.3] * bool(com)


def test_a_link_without_inertia_has_no_com() -> None:
    assert list(lengths(declared("link arm { id = 1 children {} }"))) == []


def test_a_joint_has_a_pose() -> None:
    joint = declared(JOINT)
    assert [thing.name for thing in posed_things(joint)] == ["j"]
    assert first_values(rotations(joint)) == [0.2]
    assert first_values(lengths(joint)) == [0.1]


@pytest.mark.parametrize(
    ("value", "expected"),
    [(0.0, False), (1e-300, True), (4.9e-6, True), (-4.9e-6, True), (5e-6, False), (1.0, False)],
)
def test_a_tiny_value_is_one_that_robcogen2_takes_for_zero(value: float, expected: bool) -> None:
    assert is_tiny(value) == expected


@pytest.mark.parametrize(
    ("product", "moments", "expected"),
    [
        (0.9e-4, (0.5, 1.0, 0.1), True),
        (-0.9e-4, (0.5, -1.0, 0.1), True),
        (1e-4, (0.5, 1.0, 0.1), False),
        (-1.1e-4, (0.5, 1.0, 0.1), False),
        (1e-5, (), False),
    ],
)
def test_a_product_is_negligible_beside_the_greatest_moment(
    product: float, moments: tuple[float, ...], expected: bool
) -> None:
    assert is_negligible(product, moments) == expected
