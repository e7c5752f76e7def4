"""Requests of a page to move or add something: its messages, checked."""

import math
from collections.abc import Mapping
from typing import Any, NamedTuple, TypeGuard

_LONGEST_NAME = 200
_KINDS = ("joint", "frame", "com")
_PHASES = ("move", "drop", "cancel")
_PLANS = ("add-frame", "add-child", "mirror-leg", "pose-as-zero", "undo", "redo", "discard")
_MOST_JOINTS = 10_000


class Grasp(NamedTuple):
    """Show the handles of a joint, frame or centre of mass; none for an empty name."""

    kind: str
    name: str


class Drag(NamedTuple):
    """Move a handle.

    Attributes:
        kind: `joint`, `frame` or `com`.
        name: Of the thing.
        component: `x y z rx ry rz`.
        value: Metres or radians.
        step: The value becomes a multiple of this; None for any value.
        phase: `move`, `drop`, or `cancel`.
        revision: Of the text that the page shows.
        carries: Whether the moments of a centre of mass move along.
    """

    kind: str
    name: str
    component: str
    value: float
    step: float | None
    phase: str
    revision: int
    carries: bool = False


class Plan(NamedTuple):
    """Add or rewrite something as a whole.

    Attributes:
        gesture: `add-frame`, `add-child`, `mirror-leg`, `pose-as-zero`; `undo` or `redo` what was
            written from pages; `discard` what was planned.
        name: Of the link; empty for a pose.
        point: Where, in the link's frame, metres.
        joints: Positions by name, for a pose.
        is_accepted: Whether to write it, not only to show it.
        revision: Of the text that the page shows.
    """

    gesture: str
    name: str
    point: tuple[float, float, float]
    joints: Mapping[str, float]
    is_accepted: bool
    revision: int


GESTURES = ("grasp", "drag", "plan")
GestureRequest = Grasp | Drag | Plan


def gesture_request(data: Mapping[str, Any]) -> GestureRequest | None:
    """Return what a page asks for, None for anything that is no such request."""
    kind = data.get("type")
    if kind == "grasp":
        return _grasp(data)
    if kind == "drag":
        return _drag(data)
    return _plan(data) if kind == "plan" else None


def _grasp(data: Mapping[str, Any]) -> Grasp | None:
    kind, name = data.get("kind"), data.get("name")
    if name == "":
        return Grasp("", "")
    return Grasp(str(kind), str(name)) if kind in _KINDS and is_name(name) else None


def _drag(data: Mapping[str, Any]) -> Drag | None:
    kind, name, component = data.get("kind"), data.get("name"), data.get("component")
    value, step, phase = data.get("value"), data.get("step"), data.get("phase")
    revision = data.get("revision")
    if kind not in _KINDS or phase not in _PHASES or not (is_name(name) and is_name(component)):
        return None
    if not (is_number(value) and is_number(revision) and (step is None or is_number(step))):
        return None
    snap = None if step is None else float(step)
    thing = (str(kind), str(name), str(component))
    carries = kind == "com" and data.get("carries") is True
    return Drag(*thing, float(value), snap, str(phase), int(revision), carries)


def _plan(data: Mapping[str, Any]) -> Plan | None:
    gesture, name, revision = data.get("gesture"), data.get("name", ""), data.get("revision")
    point, joints = data.get("point", [0.0, 0.0, 0.0]), data.get("joints", {})
    if gesture not in _PLANS or not (name == "" or is_name(name)) or not is_number(revision):
        return None
    if not isinstance(point, list) or len(point) != 3 or not all(map(is_number, point)):
        return None
    if not isinstance(joints, dict) or len(joints) > _MOST_JOINTS:
        return None
    known = {k: float(v) for k, v in joints.items() if is_name(k) and is_number(v)}
    x, y, z = map(float, point)
    accepted = data.get("accepted") is True
    return Plan(str(gesture), str(name), (x, y, z), known, accepted, int(revision))


def is_name(value: object) -> TypeGuard[str]:
    """Return whether a page may mean something by it: short, and characters only."""
    return isinstance(value, str) and 0 < len(value) <= _LONGEST_NAME and value.isprintable()


def is_number(value: Any) -> TypeGuard[float]:
    """Return whether a page may mean a number by it: finite, and not beyond all measure."""
    is_real = isinstance(value, int | float) and not isinstance(value, bool)
    return is_real and abs(value) < 1e12 and math.isfinite(value)
