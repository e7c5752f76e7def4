"""`kindsl.setComponent`: one number in, one edit of one version out."""

import pytest
from tests.support.lsp import RawClient, ready_client

ARM = """\
Robot r {
RobotBase base { children { a via j } }
link a { id = 1 children {} }
r_joint j { ref_frame { translation = (0.350, x, 0.0) rotation = (0.0, 2.0*twist[1.0], 0.0) } }
}
"""
URI = "untitled:arm"
VERSIONED = {"workspace": {"workspaceEdit": {"documentChanges": True}, "applyEdit": True}}


@pytest.fixture
def client():
    with ready_client(VERSIONED) as client:
        client.open(URI, ARM, version=7)
        yield client


def set_component(client: RawClient, component: str, value: float, step: float | None = None):
    thing = {"kind": "joint", "name": "j", "component": component, "value": value, "step": step}
    arguments = {"command": "kindsl.setComponent", "arguments": [URI, thing]}
    return client.request("workspace/executeCommand", arguments)


def test_one_labelled_edit_of_the_version_that_was_seen(client):
    assert set_component(client, "x", 0.4123, 0.01) == {
        "applied": True, "text": "0.410", "reason": None,
    }  # fmt: skip
    asked = client.notification("workspace/applyEdit")
    assert asked["label"] == "Set x of joint 'j'"
    (change,) = asked["edit"]["documentChanges"]
    assert change["textDocument"] == {"uri": URI, "version": 7}
    start = {"line": 3, "character": 39}
    (edit,) = change["edits"]
    assert (edit["newText"], edit["range"]["start"]) == ("0.410", start)


def test_a_default_is_solved_for(client):
    assert set_component(client, "ry", 0.5)["text"] == "0.25"
    (change,) = client.notification("workspace/applyEdit")["edit"]["documentChanges"]
    assert [edit["newText"] for edit in change["edits"]] == ["0.25"]


def test_an_unbound_parameter_writes_nothing(client):
    assert set_component(client, "y", 0.5) == {"applied": True, "text": "0.5", "reason": None}
    assert not [m for m in client.drain() if m.get("method") == "workspace/applyEdit"]


def test_what_cannot_be_set_says_why(client):
    refused = set_component(client, "w", 0.5)
    assert refused["reason"] == "joint 'j' has no component 'w'"
    assert not refused["applied"]


@pytest.mark.parametrize("options", [None, {}, {"kind": "joint"}, {"kind": "joint", "name": 3}])
def test_wrong_arguments_are_refused(client, options):
    params = {"command": "kindsl.setComponent", "arguments": [URI, options]}
    assert client.refusal("workspace/executeCommand", params)["code"] == -32602
