"""Configurations from plain data, and a sentence for each that does not fit."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kindsl.products.reports.motions import (
    BASE_KEY,
    KEYS,
    ConfigurationSpace,
    Motion,
    MotionError,
    motion,
    motions_from,
)

FIXED = ConfigurationSpace(("shoulder", "elbow"), is_floating=False)
FLOATING = ConfigurationSpace(("shoulder", "elbow"), is_floating=True)
_ZERO = (0.0, 0.0)
_KNOWN = ", ".join(KEYS)
numbers = st.floats(allow_nan=False, allow_infinity=False)


@given(st.fixed_dictionaries({}, optional=dict.fromkeys(KEYS[:4], st.tuples(numbers, numbers))))
def test_what_is_given_is_taken_and_the_rest_is_zero(given_values) -> None:
    (found,) = motions_from({key: list(value) for key, value in given_values.items()}, FIXED)
    assert found == Motion(*(given_values.get(key, _ZERO) for key in KEYS[:4]), (0.0,) * 6)
    named = {k: dict(zip(FIXED.joints, v, strict=True)) for k, v in given_values.items()}
    assert motions_from(named, FIXED) == [found]


def test_joints_that_are_not_named_are_zero_and_integers_are_numbers() -> None:
    (found,) = motions_from({"q": {"elbow": 2}, BASE_KEY: [1, 2, 3, 4, 5, 6]}, FLOATING)
    assert found.q == (0.0, 2.0) and found.base_velocity == (1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
    assert all(type(number) is float for number in (*found.q, *found.base_velocity))


def test_of_a_list_each_is_one() -> None:
    found = motions_from([{"q": [1.0, 2.0]}, {"q": [3.0, 4.0]}], FIXED)
    assert [entry.q for entry in found] == [(1.0, 2.0), (3.0, 4.0)]


@pytest.mark.parametrize(
    ("content", "where", "message"),
    [
        ([], "a.json", "a.json: no configuration is given"),
        ([], "", "no configuration is given"),
        (1, "a.json", "a.json: must be an object with 'q', not a number"),
        ([{}, 1.5], "", "configuration 2: must be an object with 'q', not a number"),
        (None, "", "must be an object with 'q', not null"),
        (True, "", "must be an object with 'q', not a boolean"),
        ("q", "", "must be an object with 'q', not a string"),
        ([[]], "", "configuration 1: must be an object with 'q', not a list"),
        ({"p": []}, "f", f"f: unknown key 'p' (known: {_KNOWN})"),
        ({"q": [1.0]}, "", "'q' has 1 number, the robot has 2 joints: shoulder, elbow"),
        ({"qd": [0, 1, 2]}, "", "'qd' has 3 numbers, the robot has 2 joints: shoulder, elbow"),
        ({"q": 1.0}, "", "'q' must be a list of numbers, not a number"),
        ({"q": [1.0, "2"]}, "", "'q' holds a string, not only numbers"),
        ({"q": [1.0, True]}, "", "'q' holds a boolean, not only numbers"),
        ({"q": [1.0, {}]}, "", "'q' holds an object, not only numbers"),
        ({"q": [1.0, float("nan")]}, "", "'q' holds a number that is not finite"),
        ({"q": [1.0, -float("inf")]}, "", "'q' holds a number that is not finite"),
        ({"tau": {"elbow": 10**400}}, "", "'tau' holds a number that is not finite"),
        ({"q": {"elbo": 1.0}}, "", "'q': there is no joint 'elbo', did you mean 'elbow'?"),
        ({"q": {"wheel": 1.0}}, "", "'q': there is no joint 'wheel'"),
        ({BASE_KEY: [0.0] * 6}, "", f"'{BASE_KEY}' is given, but the base is fixed"),
    ],
)
def test_what_does_not_fit_is_one_sentence(content: object, where: str, message: str) -> None:
    with pytest.raises(MotionError) as caught:
        motions_from(content, FIXED, where)
    assert str(caught.value) == message


@pytest.mark.parametrize(("n", "told"), [(1, "1 number"), (5, "5 numbers"), (7, "7 numbers")])
def test_a_base_s_velocity_has_six_numbers(n: int, told: str) -> None:
    names = {key: f"--{key}" for key in KEYS}
    with pytest.raises(MotionError) as caught:
        motion({BASE_KEY: [0.0] * n}, FLOATING, names)
    assert str(caught.value) == f"--{BASE_KEY} has {told}, the base's velocity has 6"
    assert motion({}, FLOATING, names).base_velocity == (0.0,) * 6
