"""The life of `kindsl preview`: serve, reload on save, print what is clicked, until stopped."""

import asyncio
import os
import signal
import sys
import threading
import webbrowser
from collections.abc import Callable
from contextlib import suppress
from typing import NamedTuple

from kindsl.analysis.analysis import Analysis
from kindsl.preview.documents import OnEdit
from kindsl.preview.dragging import Writing
from kindsl.preview.requests import Reveal
from kindsl.preview.server import PreviewServer
from kindsl.preview.watch import Fingerprint, saves
from kindsl.text.lines import LineIndex
from kindsl.text.span import Span


class Command(NamedTuple):
    """What the command was told.

    Attributes:
        file: The document.
        read: Reads it; returns why not if it cannot be read.
        first: The document as it is at the start.
        old: The document to stand behind it, if any.
        port: To listen on; 0 for a free one.
        opens_browser: Whether to open the page.
        paths: The document and the configuration file that holds for it, if any.
        fingerprint: Of these files, taken before they were read.
        write: Writes what was dragged; returns why not, or an empty text. None if nothing may be.
    """

    file: str
    read: Callable[[], Analysis | str]
    first: Analysis
    old: Analysis | None
    port: int
    opens_browser: bool
    paths: tuple[str, ...]
    fingerprint: Fingerprint
    write: Callable[[Writing], str] | None = None


async def serve(command: Command) -> None:
    """Serve the document's preview until interrupted.

    Raises:
        PreviewUnavailableError: Something is not installed, or the port is taken.
        ModelError: The document to compare with has no bodies.
    """
    texts = {"shown": command.first.text}

    def print_place(key: str, span: Span, chosen: Reveal) -> None:
        line, column = LineIndex(texts["shown"]).position(span.start)
        what = "finding" if chosen.kind == "finding" else f"{chosen.kind} {chosen.name}"
        print(f"{key}:{line + 1}:{column + 1}: {what}", flush=True)

    session = os.path.abspath(command.file)  # noqa: PTH100 (a path may hold any bytes)
    server = PreviewServer(
        print_place, on_edit=_editing(command), port=command.port, session=session
    )
    address = await server.start()
    await _show(server, command.file, command.first)
    if command.old is not None:
        server.compare(command.file, command.old)
    print(address, flush=True)
    if command.opens_browser:
        _open_browser(address)
    reloading = asyncio.ensure_future(_reload(command, server, texts))
    try:
        await _until_stopped(reloading)
    finally:
        reloading.cancel()
        await server.stop()


def _editing(command: Command) -> OnEdit | None:
    write = command.write
    if write is None:
        return None

    async def edit(_key: str, writing: Writing) -> str:
        reason = write(writing)
        if not reason:
            print(f"{command.file}: {writing.label}", flush=True)
        return reason

    return edit


async def _reload(command: Command, server: PreviewServer, texts: dict[str, str]) -> None:
    async for _ in saves(command.paths, command.fingerprint):
        analysis = command.read()
        if isinstance(analysis, str):
            print(analysis, file=sys.stderr, flush=True)
            continue
        texts["shown"] = analysis.text
        await _show(server, command.file, analysis)


async def _show(server: PreviewServer, file: str, analysis: Analysis) -> None:
    """Show a version, then what is found in it."""
    await server.show(file, analysis)
    await server.show(file, analysis, await asyncio.to_thread(lambda: analysis.findings))


async def _until_stopped(reloading: "asyncio.Future[None]") -> None:
    """Wait for Ctrl-C or a request to terminate, or for reloading to fail."""
    stopped = asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM):
        with suppress(NotImplementedError, RuntimeError):
            loop.add_signal_handler(number, stopped.set)
    waiting = asyncio.ensure_future(stopped.wait())
    done, _ = await asyncio.wait((waiting, reloading), return_when=asyncio.FIRST_COMPLETED)
    waiting.cancel()
    if reloading in done:
        reloading.result()


def _open_browser(address: str) -> None:
    """Open the page where there is a screen; a browser in the terminal would take it over."""
    has_screen = sys.platform in ("darwin", "win32") or bool(
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    )
    if has_screen:
        threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()
