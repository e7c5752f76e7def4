"""The last value of every property, and what changes from one state to the next."""

from collections.abc import Iterable
from typing import NamedTuple, TypeAlias

from kindsl.robots.scene.messages import Delete, Part

# "/kindsl/TREE": nothing above a tree is ever deleted.
_TREE_DEPTH = 3


class Key(NamedTuple):
    """The key of a message; a later one with the same key replaces it."""

    path: str
    type: str


Messages: TypeAlias = dict[Key, Part]


def key_of(message: Part) -> Key:
    """Return the key of a message."""
    return Key(message.path, message.type)


def keyed(messages: Iterable[Part]) -> Messages:
    """Return messages by key; of two with the same key the last stays."""
    return {key_of(message): message for message in messages}


def changes(old: Messages, new: Messages) -> list[Part]:
    """Return what a page that shows `old` must be sent to show `new`: deletions first.

    A page can forget a path with all below, but not one property of it; so what stays of a path
    that loses one is sent again.
    """
    lost_paths = {key.path for key in old.keys() - new.keys()}
    deleted: set[str] = set()
    if lost_paths:
        kept = _with_ancestors(key.path for key in new)
        deleted = {_highest_gone(path, kept) for path in lost_paths}
    parts: list[Part] = [Delete(path) for path in sorted(deleted)]
    for key, message in new.items():
        known = old.get(key)
        # Most are the same object, which comparing would only find out field by field.
        is_new = known is not message and known != message
        if is_new or (deleted and not deleted.isdisjoint(_with_ancestors((key.path,)))):
            parts.append(message)
    return parts


def _with_ancestors(paths: Iterable[str]) -> set[str]:
    known: set[str] = set()
    for path in paths:
        while path and path not in known:
            known.add(path)
            path = path.rpartition("/")[0]
    return known


def _highest_gone(path: str, kept: set[str]) -> str:
    """Return the highest ancestor of a path that nothing kept lies below, else the path."""
    while path.count("/") >= _TREE_DEPTH:
        above = path.rpartition("/")[0]
        if above in kept:
            break
        path = above
    return path
