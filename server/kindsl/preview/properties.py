"""The last value of every property, and what changes from one state to the next."""

from collections.abc import Iterable

from kindsl.preview.wire import Message, Messages, delete

# "/kindsl/TREE": nothing above a tree is ever deleted.
_TREE_DEPTH = 3


def changes(old: Messages, new: Messages) -> list[Message]:
    """Return what a page that shows `old` must be sent to show `new`: deletions first."""
    paths = {key.path for key in new}
    gone_paths = {key.path for key in old} - paths
    deletions: list[Message] = []
    if gone_paths:
        kept = _with_ancestors(paths)
        deletions = [delete(path) for path in sorted({_highest_gone(p, kept) for p in gone_paths})]
    return deletions + [message for key, message in new.items() if old.get(key) != message]


def _with_ancestors(paths: Iterable[str]) -> set[str]:
    known: set[str] = set()
    for path in paths:
        while path and path not in known:
            known.add(path)
            path = path.rpartition("/")[0]
    return known


def _highest_gone(path: str, kept: set[str]) -> str:
    """Return the highest ancestor of a path, or itself, that nothing kept lies below."""
    while path.count("/") >= _TREE_DEPTH:
        above = path.rpartition("/")[0]
        if above in kept:
            break
        path = above
    return path
