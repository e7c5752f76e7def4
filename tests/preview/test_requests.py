"""Whatever a page sends is either a request or refused with a reason."""

import json
from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kindsl.frontends.preview.requests import (
    BadRequestError,
    Drag,
    Hello,
    Plan,
    Reveal,
    SetJoints,
    SetParameters,
    parse_request,
)

json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda children: (
        st.lists(children, max_size=4) | st.dictionaries(st.text(max_size=8), children, max_size=4)
    ),
    max_leaves=12,
)
kinds = st.sampled_from(
    ["set-joints", "set-parameters", "reveal", "hello", "drag", "plan", "grasp", "eval", None, 3]
)
fields = st.sampled_from(
    ["name", "kind", "value", "values", "joints", "component", "point", "phase", "revision", "step"]
)
DRAG = {
    "type": "drag", "kind": "joint", "name": "a", "component": "x", "value": 1, "phase": "move",
    "revision": 3,
}  # fmt: skip


@given(st.text() | json_values.map(json.dumps))
def test_a_text_is_refused_at_most(text):
    with suppress(BadRequestError):
        parse_request(text)


@given(kind=kinds, data=st.dictionaries(fields, json_values))
def test_requests_are_well_formed(kind, data):
    with suppress(BadRequestError):
        request = parse_request(json.dumps({**DRAG, **data, "type": kind}))
        if isinstance(request, SetJoints):
            assert all(isinstance(number, float) for number in request.values.values())
        if isinstance(request, Hello):
            assert all(isinstance(number, float) for number in request.joints.values())
        if isinstance(request, Drag):
            assert isinstance(request.value, float) and isinstance(request.revision, int)


@pytest.mark.parametrize(
    ("message", "request_"),
    [
        ({"type": "set-joints", "values": {"a": 1}}, SetJoints({"a": 1.0})),
        ({"type": "set-parameters", "values": {"a": None}}, SetParameters({"a": None})),
        ({"type": "reveal", "kind": "link", "name": "a"}, Reveal("link", "a")),
        # A page greets with all that it has: what cannot be meant is passed over.
        ({"type": "hello", "joints": {"\udfff": 1.0, "b": 2}}, Hello({"b": 2.0}, {})),
        ({"type": "set-joints", "values": {"a": "1", "b": True}}, SetJoints({})),
        ({"type": "set-joints", "values": {"a" * 300: 1, "": 1}}, SetJoints({})),
        ({"type": "plan", "gesture": "undo", "revision": 1}, Plan("undo", 1)),
        (DRAG, Drag("joint", "a", "x", 1.0, "move", 3)),
    ],
)
def test_requests(message, request_):
    assert parse_request(json.dumps(message)) == request_


@pytest.mark.parametrize(
    ("message", "reason"),
    [
        (
            {"type": "reveal", "kind": "file", "name": "/etc/passwd"},
            "'reveal' is no request: not an allowed value @ $.kind",
        ),
        (
            {"type": "reveal", "kind": [], "name": "a"},
            "'reveal' is no request: not an allowed value @ $.kind",
        ),
        (
            {"type": "reveal", "kind": "link", "name": "\ud800"},
            "'reveal' is no request: "
            "a name is a short text of characters that can be printed @ $.name",
        ),
        (
            {"type": "keep-pose", "name": "", "values": {}},
            "'keep-pose' is no request: a name is empty @ $.name",
        ),
        ({"type": "keep-pose", "name": "a"}, "'keep-pose' is no request: missing @ $.values"),
        (
            {**DRAG, "value": True},
            "'drag' is no request: a number is finite and below 1e12 @ $.value",
        ),
        ({"type": "set_control", "callback": "alert(1)"}, "a message has no known type"),
        ({"type": ["hello"]}, "a message has no known type"),
        ([], "a message has no known type"),
    ],
)
def test_refusals_say_what_is_wrong_and_where(message, reason):
    with pytest.raises(BadRequestError) as refused:
        parse_request(json.dumps(message))
    assert str(refused.value) == reason


@pytest.mark.parametrize("number", ["NaN", "1e999", "1e12"])
def test_not_finite_is_no_number(number):
    with pytest.raises(BadRequestError, match="finite"):
        parse_request(json.dumps(DRAG).replace('"value": 1', f'"value": {number}'))


@pytest.mark.parametrize("text", ["[" * 60000, "{", b"\xff", ""])
def test_no_json_is_refused(text):
    with pytest.raises(BadRequestError, match="is not JSON"):
        parse_request(text)
