"""The life of `kindsl preview`: serve, reload on save, print what is clicked, until stopped."""

import asyncio
import os
import signal
import sys
import threading
import webbrowser
from collections.abc import Callable, Mapping
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
        table: Returns values of parameters as lines of the configuration file.
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
    table: Callable[[Mapping[str, float]], str]
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
    server.on_write = lambda _, values: _told(command.table(values))
    address = await server.start()
    await _show(command, server, command.first)
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


def _told(lines: str) -> str:
    """Say on the terminal too what a page is told to write by hand."""
    print(lines, end="", flush=True)
    return lines


async def _reload(command: Command, server: PreviewServer, texts: dict[str, str]) -> None:
    async for is_there in saves(command.paths, command.fingerprint):
        analysis = command.read() if is_there else f"{command.file}: the file was moved or deleted"
        if isinstance(analysis, str):
            print(analysis, file=sys.stderr, flush=True)
            server.lose(command.file, analysis)
            continue
        texts["shown"] = analysis.text
        await _show(command, server, analysis)


async def _show(command: Command, server: PreviewServer, analysis: Analysis) -> None:
    """Show a saved version, then what is found in it; it stands behind values typed in a page."""
    await server.show(command.file, analysis)
    if command.old is None:
        server.saved(command.file)
    findings = await asyncio.to_thread(lambda: analysis.findings)
    await server.show(command.file, analysis, findings)


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
