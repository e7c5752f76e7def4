"""The semantic tokens that the client knows, to tell it only what has changed."""

import itertools
from array import array
from bisect import bisect_left
from collections.abc import Callable
from typing import Any

from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document

_SERIAL = itertools.count()


class TokenMemory:
    """The tokens that were told last for each document, to tell only what has changed."""

    __slots__ = ("_told",)

    def __init__(self) -> None:
        self._told: dict[str, tuple[str, bytes]] = {}

    def tell(self, uri: str, data: "array[int]", known: str | None) -> dict[str, Any]:
        """Return tokens, or the difference to the ones that the client says it knows."""
        result_id, new = str(next(_SERIAL)), data.tobytes()
        before = self._told.get(uris.key(uri))
        self._told[uris.key(uri)] = result_id, new
        if before is None or before[0] != known:
            return {"resultId": result_id, "data": data.tolist()}
        return {"resultId": result_id, "edits": _difference(before[1], new)}

    def forget(self, document: Document) -> None:
        """Drop what was told of a document."""
        self._told.pop(uris.key(document.uri), None)


def _difference(old: bytes, new: bytes) -> list[dict[str, Any]]:
    """Return the one edit between the common beginning and the common end of two rows."""
    size = array("I").itemsize
    shorter = min(len(old), len(new)) // size
    prefix = _common(shorter, lambda n: old[: n * size] == new[: n * size])
    suffix = _common(
        shorter - prefix, lambda n: old[len(old) - n * size :] == new[len(new) - n * size :]
    )
    if (prefix + suffix) * size == len(old) == len(new):
        return []
    inserted = array("I")
    inserted.frombytes(new[prefix * size : len(new) - suffix * size])
    deleted = len(old) // size - prefix - suffix
    return [{"start": prefix, "deleteCount": deleted, "data": inserted.tolist()}]


def _common(most: int, is_common: Callable[[int], bool]) -> int:
    return bisect_left(range(1, most + 1), True, key=lambda n: not is_common(n))
