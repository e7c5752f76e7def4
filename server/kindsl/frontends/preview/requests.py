"""Requests of a page: its messages, checked."""

import json
from typing import Any, NamedTuple

from kindsl.frontends.preview.gesture_requests import (
    GESTURES,
    GestureRequest,
    gesture_request,
    is_name,
    is_number,
)

MOST_BYTES = 1 << 16
_REVEALED = ("link", "joint", "frame", "parameter", "finding")


class SetJoint(NamedTuple):
    """Move a joint, radians or metres."""

    name: str
    value: float


class SetJoints(NamedTuple):
    """Move several joints, radians or metres by name."""

    values: dict[str, float]


class WriteParameters(NamedTuple):
    """Give parameters these values in the configuration file."""

    values: dict[str, float]


class KeepPose(NamedTuple):
    """Give a pose a name in the configuration file: positions of its joints, radians or metres."""

    name: str
    joints: dict[str, float]


class SetParameters(NamedTuple):
    """Give parameters values by name, or their own back for None."""

    values: dict[str, float | None]


class Reveal(NamedTuple):
    """Show the source of a link, joint, frame, parameter or (by its number) finding."""

    kind: str
    name: str


class Compare(NamedTuple):
    """Compare with another file that was offered; with none for an empty name."""

    name: str


class ShowMeshes(NamedTuple):
    """Load the meshes that are offered."""


class Hello(NamedTuple):
    """A page has come, maybe with values from before the server was restarted."""

    joints: dict[str, float]
    parameters: dict[str, float]


Request = (
    SetJoint | SetJoints | SetParameters | WriteParameters | KeepPose | Reveal | Compare
    | ShowMeshes | Hello | GestureRequest
)  # fmt: skip


def parse_request(text: str) -> Request | None:
    """Return what a page asks for in JSON, None for anything that is no request."""
    try:
        return request_of(json.loads(text))
    except (ValueError, RecursionError):
        return None


def request_of(data: object) -> Request | None:
    """Return what a page asks for, None for anything that is no request."""
    if not isinstance(data, dict):
        return None
    if data.get("type") == "hello":
        return Hello(_numbers(data.get("joints")), _numbers(data.get("parameters")))
    if data.get("type") == "set-joints":
        return SetJoints(_numbers(data.get("values")))
    if data.get("type") == "set-parameters":
        return SetParameters({**_numbers(data.get("values"))})
    if data.get("type") == "write-parameters":
        return WriteParameters(_numbers(data.get("values")))
    if data.get("type") in GESTURES:
        return gesture_request(data)
    if data.get("type") == "meshes":
        return ShowMeshes()
    name, value = data.get("name"), data.get("value")
    if data.get("type") == "compare":
        return Compare(name) if name == "" or is_name(name) else None
    if not is_name(name):
        return None
    return _named_request(data, name, value)


def _named_request(data: dict[str, Any], name: str, value: object) -> Request | None:
    kind = data.get("type")
    if kind == "set-joint" and is_number(value):
        return SetJoint(name, float(value))
    if kind == "set-parameter" and (value is None or is_number(value)):
        return SetParameters({name: None if value is None else float(value)})
    if kind == "keep-pose":
        return KeepPose(name, _numbers(data.get("values")))
    if kind == "reveal" and data.get("kind") in _REVEALED:
        return Reveal(str(data["kind"]), name)
    return None


def _numbers(data: object) -> dict[str, float]:
    if not isinstance(data, dict):
        return {}
    return {k: float(v) for k, v in data.items() if is_name(k) and is_number(v)}
