"""The surroundings of a session: a process of its own, or a browser's worker."""

import os
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from kindsl.frontends.lsp.session.worker import Worker

if TYPE_CHECKING:
    from kindsl.frontends.preview.documents import DocumentPreviews, OnEdit, OnReveal


class Surroundings(NamedTuple):
    """The surroundings of a session.

    Attributes:
        worker: Does the long work.
        new_previews: Makes what shows documents and tells what was clicked and dragged; raises
            ImportError if something is not installed.
        n_helpers: In how many processes long work about closed files is done.
        has_files: Whether others than the client may write the files that are read.
    """

    worker: Worker
    new_previews: "Callable[[OnReveal, OnEdit], DocumentPreviews]"
    n_helpers: int = 0
    has_files: bool = True


def process() -> Surroundings:
    """Return what a process offers: a thread, and a server on the loopback interface."""
    return Surroundings(Worker(), _preview_server, os.cpu_count() or 1)


def _preview_server(on_reveal: "OnReveal", on_edit: "OnEdit") -> "DocumentPreviews":
    from kindsl.frontends.preview.server import PreviewServer

    return PreviewServer(on_reveal, on_edit=on_edit)
