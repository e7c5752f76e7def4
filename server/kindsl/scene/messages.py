"""Messages to the page: what each says, what tells it from others, and its bytes.

The drawing messages are meshcat's (`set_object`, `set_transform`, `delete`); the others are our own
and are understood by our page only. All have a type and most a path, which is the place in the
scene that they speak of: `/kindsl/TREE/GROUP/NAME/CATEGORY/MARK`.
"""

import json
import math
from array import array
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any, NamedTuple, TypeAlias
from urllib.parse import quote

from kindsl.scene.geometry import Shape, lowered

Message: TypeAlias = Mapping[str, Any]

ROOT = "/kindsl"
# MessagePack's extension types of the viewer, by the kind of number in a typed array.
_EXTENSIONS = {"f": 0x17, "I": 0x16}


class Key(NamedTuple):
    """What a message is the value of; a later one with the same key replaces it."""

    path: str
    type: str


Messages: TypeAlias = dict[Key, Message]


@lru_cache(maxsize=1 << 15)
def path_of(*elements: str) -> str:
    """Return the path of named elements; a name can hold any character."""
    return "/".join((ROOT, *(quote(element, safe="") for element in elements)))


def key_of(message: Message) -> Key:
    """Return the key of a message."""
    return Key(message.get("path", ""), message["type"])


def keyed(messages: Iterable[Message]) -> Messages:
    """Return messages by key; of two with the same key the last stays."""
    return {key_of(message): message for message in messages}


def set_object(path: str, shape: Shape) -> Message:
    """Return the message that draws a shape at a path."""
    return {"type": "set_object", "path": path, "object": shape}


def set_transform(path: str, matrix: tuple[float, ...]) -> Message:
    """Return the message that places a path; `matrix` has 16 numbers, column by column."""
    return {"type": "set_transform", "path": path, "matrix": matrix}


def delete(path: str) -> Message:
    """Return the message that removes a path and all below."""
    return {"type": "delete", "path": path}


def encode(message: Message) -> bytes:
    """Return a message's MessagePack bytes, with its shape in meshcat's form."""
    import umsgpack  # type: ignore[import-untyped]

    def extension(numbers: "array[Any]") -> Any:
        return umsgpack.Ext(_EXTENSIONS[numbers.typecode], numbers.tobytes())

    handlers = {array: extension}
    try:
        packed: bytes = umsgpack.packb(_whole(message), ext_handlers=handlers)
    except UnicodeEncodeError:
        packed = umsgpack.packb(_printable(_whole(message)), ext_handlers=handlers)
    return packed


def as_json(message: Message) -> str:
    """Return a message as JSON, with its shape in meshcat's form and arrays as lists.

    What is no finite number becomes null, since JSON has no other word for it.
    """
    try:
        return _json(_whole(message))
    except ValueError:
        return _json(_finite(_whole(message)))


def _json(value: object) -> str:
    return json.dumps(value, default=list, separators=(",", ":"), allow_nan=False)


def _finite(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    return [_finite(item) for item in value] if isinstance(value, list | tuple) else value


def _whole(message: Message) -> dict[str, Any]:
    shape = message.get("object")
    return {**message, "object": lowered(shape)} if isinstance(shape, Shape) else dict(message)


def _printable(value: Any) -> Any:
    """Return a message without the surrogates that undecodable bytes of a document leave."""
    if isinstance(value, str):
        return value.encode(errors="replace").decode()
    return {key: _printable(v) for key, v in value.items()} if isinstance(value, dict) else value
