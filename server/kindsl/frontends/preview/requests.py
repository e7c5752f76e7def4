"""Requests of a page: its messages, checked."""

import json
import math
import re
from collections.abc import Mapping
from contextlib import suppress
from typing import Annotated, Any, Literal, NamedTuple, NewType, TypeAlias, get_args

from cattrs import BaseValidationError, Converter, transform_error
from cattrs.cols import is_mapping, is_namedtuple, namedtuple_dict_structure_factory

from kindsl.robots.scene.messages import Position, Quantity, Travel

MOST_BYTES = 1 << 16
_LONGEST_NAME = 200
# A name that is not empty.
Name = NewType("Name", str)
Kind: TypeAlias = Literal["joint", "frame", "com"]
Component: TypeAlias = Literal["x", "y", "z", "rx", "ry", "rz"]
Gesture: TypeAlias = Literal["add-frame", "add-child", "mirror-leg", "pose-as-zero"]
Revision: TypeAlias = Annotated[int, "of the text that the page shows"]


class BadRequestError(ValueError):
    """A message that is not a valid request; the text is one sentence."""


class SetJoints(NamedTuple):
    """Move joints."""

    values: Annotated[Mapping[str, Travel], "by name"]


class SetParameters(NamedTuple):
    """Give parameters values in the picture only, or their own back for null."""

    values: Annotated[Mapping[str, Quantity | None], "by name"]


class WriteParameters(NamedTuple):
    """Give parameters these values in the configuration file."""

    values: Annotated[Mapping[str, Quantity], "by name"]


class KeepPose(NamedTuple):
    """Give a pose a name in the configuration file."""

    name: Name
    values: Annotated[Mapping[str, Travel], "positions by joint"]


class Reveal(NamedTuple):
    """Show the source of a thing."""

    kind: Literal["link", "joint", "frame", "parameter", "finding"]
    name: Annotated[str, "of a finding its number in the list"]


class Compare(NamedTuple):
    """Compare with another file that was offered; with none for an empty name."""

    name: str


class ShowMeshes(NamedTuple):
    """Load the meshes that are offered."""


class Hello(NamedTuple):
    """Greet the server, maybe with values from before it was restarted."""

    joints: Annotated[Mapping[str, Travel], "by name"] = {}
    parameters: Annotated[Mapping[str, Quantity], "by name"] = {}


class Grasp(NamedTuple):
    """Show the handles of a joint, frame or centre of mass; none for an empty name."""

    kind: Literal[Kind, ""]
    name: str


class Drag(NamedTuple):
    """Move a handle."""

    kind: Kind
    name: str
    component: Component
    value: Travel
    phase: Literal["move", "drop", "cancel"]
    revision: Revision
    step: Annotated[Travel | None, "the value becomes a multiple of this; null for any"] = None
    carries: Annotated[bool, "whether the moments of a centre of mass move along"] = False


class Plan(NamedTuple):
    """Add or rewrite something as a whole; undo or redo what was written, discard a plan."""

    gesture: Literal[Gesture, "undo", "redo", "discard"]
    revision: Revision
    name: Annotated[str, "of the link; empty for a pose"] = ""
    point: Annotated[Position, "where, in the link's frame"] = (0.0, 0.0, 0.0)
    joints: Annotated[Mapping[str, Travel], "of a pose, by name"] = {}
    accepted: Annotated[bool, "whether to write it, not only to show it"] = False


GestureRequest: TypeAlias = Grasp | Drag | Plan
Request: TypeAlias = (
    SetJoints | SetParameters | WriteParameters | KeepPose | Reveal | Compare | ShowMeshes | Hello
    | GestureRequest
)  # fmt: skip


def type_of(kind: type) -> str:
    """Return the `type` of a kind of request: `set-joints`."""
    return re.sub(r"\B([A-Z])", r"-\1", kind.__name__).lower()


_KINDS: Mapping[str, type[Request]] = {type_of(kind): kind for kind in get_args(Request)}


def parse_request(text: str | bytes) -> Request:
    """Return what a page asks for in JSON.

    Raises:
        BadRequestError: The text is no request.
    """
    try:
        data = json.loads(text)
    except (ValueError, RecursionError):
        raise BadRequestError("a message is not JSON") from None
    return request_of(data)


def request_of(data: object) -> Request:
    """Return what a page asks for.

    Raises:
        BadRequestError: The data is no request.
    """
    word = data.get("type") if isinstance(data, dict) else None
    kind = _KINDS.get(word) if isinstance(word, str) else None
    if kind is None:
        raise BadRequestError("a message has no known type")
    try:
        request: Request = _CONVERTER.structure(data, kind)
    except BaseValidationError as error:
        problem = transform_error(error, format_exception=_problem)[0]
        raise BadRequestError(f"'{word}' is no request: {problem}") from None
    return request


def _problem(error: BaseException, _: object) -> str:
    if isinstance(error, KeyError):
        return "missing"
    return str(error) if isinstance(error, BadRequestError) else "not an allowed value"


def _values(data: Any, kind: Any) -> dict[str, Any]:
    """Return the values that can be meant: a page greets with all that it has, odd ones too."""
    if not isinstance(data, dict):
        raise BadRequestError("values have names")
    found: dict[str, Any] = {}
    for name, value in data.items():
        with suppress(BadRequestError):
            found[_name(name, Name)] = _CONVERTER.structure(value, get_args(kind)[1])
    return found


def _text(data: Any, _: Any) -> str:
    if isinstance(data, str) and len(data) <= _LONGEST_NAME and data.isprintable():
        return data
    raise BadRequestError("a name is a short text of characters that can be printed")


def _name(data: Any, _: Any) -> Name:
    if data == "":
        raise BadRequestError("a name is empty")
    return Name(_text(data, str))


def _number(data: Any, _: Any) -> float:
    is_real = isinstance(data, int | float) and not isinstance(data, bool)
    if is_real and abs(data) < 1e12 and math.isfinite(data):
        return float(data)
    raise BadRequestError("a number is finite and below 1e12")


_CONVERTER = Converter()
_CONVERTER.register_structure_hook_factory(
    is_namedtuple, lambda kind: namedtuple_dict_structure_factory(kind, _CONVERTER)
)
_CONVERTER.register_structure_hook(str, _text)
_CONVERTER.register_structure_hook(float, _number)
_CONVERTER.register_structure_hook(int, lambda data, _: int(_number(data, float)))
_CONVERTER.register_structure_hook(bool, lambda data, _: data is True)
_CONVERTER.register_structure_hook(Name, _name)
_CONVERTER.register_structure_hook_func(is_mapping, _values)
