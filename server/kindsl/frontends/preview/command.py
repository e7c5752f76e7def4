"""The life of `kindsl preview`: serve, reload on save, print what is clicked, until stopped."""

import asyncio
import os
import signal
import sys
import threading
import webbrowser
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from typing import NamedTuple

from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.requests import KeepPose, Reveal, WriteParameters
from kindsl.frontends.preview.server import PreviewServer
from kindsl.frontends.preview.steps import Writing
from kindsl.frontends.preview.watch import Fingerprint, saves
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.span import Span


class Command(NamedTuple):
    """The options of the command.

    Attributes:
        file: The document.
        read: Reads it; returns why not if it cannot be read.
        first: The document as it is at the start.
        add: Adds to its preview what else is asked for.
        port: To listen on; 0 for a free one.
        opens_browser: Whether to open the page.
        paths: The document and what else it is shown with: a configuration file, twins.
        fingerprint: Of these files, taken before they were read.
        keep: Keeps values of parameters or a pose in the configuration file; returns the lines to
            be written by hand if it may not.
        write: Writes what was dragged; returns why not, or an empty text. None if nothing may be.
    """

    file: str
    read: Callable[[], Analysis | str]
    first: Analysis
    add: Callable[[DocumentPreview], None]
    port: int
    opens_browser: bool
    paths: tuple[str, ...]
    fingerprint: Fingerprint
    keep: Callable[[WriteParameters | KeepPose], str]
    write: Callable[[Writing], str] | None = None


async def serve(command: Command) -> None:
    """Serve the document's preview until interrupted.

    Raises:
        PreviewUnavailableError: Something is not installed, or the port is taken.
        PoseError: The robot has no such pose.
    """
    follower = _Follower(command)
    server = follower.server
    server.on_write = follower.keep
    address = await server.start()
    await follower.show(command.first)
    command.add(follower.shown)
    print(address, flush=True)
    if command.opens_browser:
        _open_browser(address)
    reloading = asyncio.ensure_future(follower.follow())
    try:
        await _until_stopped(reloading)
    finally:
        reloading.cancel()
        await server.stop()


class _Follower:
    """Keeps the page in line with the file, and the file with what is dragged in the page."""

    def __init__(self, command: Command) -> None:
        self._command = command
        self._analysis: Analysis | None = None
        self._redrawing: asyncio.Task[None] | None = None
        self.server = PreviewServer(
            self._print_place,
            on_edit=None if command.write is None else partial(self._edit, command.write),
            port=command.port,
            session=os.path.abspath(command.file),  # noqa: PTH100 (a path may hold any bytes)
        )

    @property
    def shown(self) -> DocumentPreview:
        """The document's preview, once it is shown."""
        shown = self.server.at(self._command.file)
        assert shown is not None
        return shown

    async def follow(self) -> None:
        """Show each version that is saved."""
        command = self._command
        async for is_there in saves(command.paths, command.fingerprint):
            if is_there:
                await self._reload()
            else:
                self._lose(f"{command.file}: the file was moved or deleted")

    async def show(self, analysis: Analysis) -> None:
        """Show a saved version, then its findings; it stands behind values typed in a page."""
        file, server = self._command.file, self.server
        self._analysis = analysis
        await server.show(file, analysis)
        self.shown.keep_as_ghost()
        findings = await asyncio.to_thread(lambda: analysis.findings)
        # What was dragged meanwhile is shown already.
        if self._analysis is analysis:
            await server.show(file, analysis, findings)

    async def _reload(self) -> None:
        analysis, shown = self._command.read(), self._analysis
        if isinstance(analysis, str):
            self._lose(analysis)
        elif shown is None or (analysis.text, analysis.settings) != (shown.text, shown.settings):
            await self.show(analysis)
        else:
            self.shown.recompare()

    def _lose(self, message: str) -> None:
        self._analysis = None
        print(message, file=sys.stderr, flush=True)
        self.shown.lose(message)

    async def _edit(self, write: Callable[[Writing], str], _key: str, writing: Writing) -> str:
        """Write what was dragged, and show it without waiting for the next look at the file."""
        reason = write(writing)
        if not reason:
            print(f"{self._command.file}: {writing.label}", flush=True)
            self._redrawing = asyncio.ensure_future(self._reload())
        return reason

    def keep(self, _key: str, wanted: WriteParameters | KeepPose) -> str:
        """Keep values or a pose; return and print the lines that the user has to write by hand."""
        lines = self._command.keep(wanted)
        print(lines, end="", flush=True)
        if not lines:
            self._redrawing = asyncio.ensure_future(self._reload())
        return lines

    def _print_place(self, key: str, span: Span, chosen: Reveal) -> None:
        text = "" if self._analysis is None else self._analysis.text
        line, column = LineIndex(text).position(span.start)
        what = "finding" if chosen.kind == "finding" else f"{chosen.kind} {chosen.name}"
        print(f"{key}:{line + 1}:{column + 1}: {what}", flush=True)


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
