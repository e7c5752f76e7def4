"""Messages as bytes for the viewer, and as JSON."""

import json
import math
from array import array
from collections.abc import Callable, Mapping
from dataclasses import is_dataclass
from typing import Any

from kindsl.robots.scene.geometry import Shape, lowered
from kindsl.robots.scene.messages import Change, Part

# MessagePack's extension types of the viewer, by the kind of number in a typed array.
_EXTENSIONS = {"f": 0x17, "I": 0x16}


def as_dict(message: Part | Change) -> dict[str, Any]:
    """Return a message as dictionaries and lists, with its shapes in meshcat's form."""
    fields = {name: _as_plain(value) for name, value in vars(message).items()}
    return {"type": message.type, **fields}


def encode(message: Part | Change) -> bytes:
    """Return a message's MessagePack bytes."""
    import umsgpack  # type: ignore[import-untyped]

    def extension(numbers: "array[Any]") -> Any:
        return umsgpack.Ext(_EXTENSIONS[numbers.typecode], numbers.tobytes())

    handlers = {array: extension}
    content = as_dict(message)
    try:
        packed: bytes = umsgpack.packb(content, ext_handlers=handlers)
    except UnicodeEncodeError:
        packed = umsgpack.packb(_mapped(content, _printable), ext_handlers=handlers)
    return packed


def as_json(message: Part | Change) -> str:
    """Return a message as JSON, with arrays as lists.

    What is no finite number becomes null, since JSON has no other word for it.
    """
    content = as_dict(message)
    try:
        return _json(content)
    except ValueError:
        return _json(_mapped(content, _finite))


def _as_plain(value: Any) -> Any:
    if isinstance(value, Shape):
        return lowered(value)
    if type(value) is tuple:
        # Numbers and texts, of which there are most, are plain already.
        has_more = bool(value) and not isinstance(value[0], float | str)
        return [_as_plain(item) for item in value] if has_more else value
    if isinstance(value, tuple):
        return {name: _as_plain(item) for name, item in value._asdict().items()}  # type: ignore[attr-defined]
    if isinstance(value, Mapping):
        return dict(value)
    return as_dict(value) if is_dataclass(value) else value  # type: ignore[arg-type]


def _json(value: object) -> str:
    return json.dumps(value, default=list, separators=(",", ":"), allow_nan=False)


def _mapped(value: Any, plain: Callable[[Any], Any]) -> Any:
    """Return a message with each number and text in it as a function has it."""
    if isinstance(value, dict):
        return {key: _mapped(item, plain) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_mapped(item, plain) for item in value]
    return plain(value)


def _finite(value: Any) -> Any:
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _printable(value: Any) -> Any:
    """Return a text without the surrogates that undecodable bytes of a document leave."""
    return value.encode(errors="replace").decode() if isinstance(value, str) else value
