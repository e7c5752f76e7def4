"""Whatever a page sends is either a request or nothing."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kindsl.frontends.preview.requests import Hello, Reveal, SetJoint, SetParameters, parse_request

json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda children: (
        st.lists(children, max_size=4) | st.dictionaries(st.text(max_size=8), children, max_size=4)
    ),
    max_leaves=12,
)
kinds = st.sampled_from(["set-joint", "set-parameter", "reveal", "hello", "eval", None, 3])


@given(st.text() | json_values.map(json.dumps))
def test_nothing_raises(text):
    parse_request(text)


@given(kind=kinds, name=json_values, value=json_values, what=json_values, joints=json_values)
def test_requests_are_well_formed(kind, name, value, what, joints):
    text = json.dumps({"type": kind, "name": name, "value": value, "kind": what, "joints": joints})
    request = parse_request(text)
    if isinstance(request, SetJoint):
        assert isinstance(request.value, float)
    if isinstance(request, Hello):
        assert all(isinstance(number, float) for number in request.joints.values())


@pytest.mark.parametrize(
    ("message", "request_"),
    [
        ({"type": "set-joint", "name": "a", "value": 1}, SetJoint("a", 1.0)),
        ({"type": "set-parameter", "name": "a", "value": None}, SetParameters({"a": None})),
        ({"type": "reveal", "kind": "link", "name": "a"}, Reveal("link", "a")),
        ({"type": "reveal", "kind": "file", "name": "/etc/passwd"}, None),
        ({"type": "set-joint", "name": "a", "value": "1"}, None),
        ({"type": "set-joint", "name": "a", "value": True}, None),
        ({"type": "set-joint", "name": "a" * 300, "value": 1}, None),
        ({"type": "set-joint", "name": "\ud800", "value": 1}, None),
        ({"type": "hello", "joints": {"\udfff": 1.0}}, Hello({}, {})),
        ({"type": "reveal", "kind": [], "name": "a"}, None),
        ({"type": "set_control", "name": "a", "callback": "alert(1)"}, None),
    ],
)
def test_examples(message, request_):
    assert parse_request(json.dumps(message)) == request_


def test_not_finite_is_no_number():
    assert parse_request('{"type": "set-joint", "name": "a", "value": NaN}') is None
    assert parse_request('{"type": "set-joint", "name": "a", "value": 1e999}') is None


def test_deep_nesting_is_nothing():
    assert parse_request("[" * 60000) is None
