"""The state of a picture: the last message of each type at each path."""

from collections.abc import Iterable
from functools import lru_cache
from typing import NamedTuple, TypeAlias
from urllib.parse import quote

from kindsl.robots.scene.messages import ROOT, Part


class Key(NamedTuple):
    """The key of a message; a later one with the same key replaces it."""

    path: str
    type: str


Messages: TypeAlias = dict[Key, Part]


@lru_cache(maxsize=1 << 15)
def path_of(*elements: str) -> str:
    """Return the path of named elements; a name can hold any character."""
    return "/".join((ROOT, *(quote(element, safe="") for element in elements)))


def key_of(message: Part) -> Key:
    """Return the key of a message."""
    return Key(message.path, message.type)


def keyed(messages: Iterable[Part]) -> Messages:
    """Return messages by key; of two with the same key the last stays."""
    return {key_of(message): message for message in messages}
