"""A window of VS Code, driven as a user would: keys, clicks, and what is there to be seen."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol

from playwright.sync_api import Error, Frame, Locator, Page, TimeoutError, expect
from tests.vscode.code_server import ROOT

SHOTS = ROOT / "artifacts" / "vscode"
TIMEOUT = 60_000
START_TIMEOUT = 90_000


class Server(Protocol):
    """What serves VS Code."""

    def url(self, folder: Path) -> str:
        """Return the address that opens a folder."""
        ...


class Workbench:
    """One window on one folder.

    Attributes:
        page: The browser's page.
        folder: The folder that the window shows.
    """

    def __init__(self, page: Page, server: Server, folder: Path) -> None:
        self.page = page
        self.folder = folder
        page.set_default_timeout(TIMEOUT)
        expect.set_options(timeout=TIMEOUT)
        page.goto(server.url(folder), wait_until="domcontentloaded")
        self.wait_until_up()

    def wait_until_up(self) -> None:
        """Wait for the window, and for its extension host to have found the folder."""
        self.page.wait_for_selector(".explorer-folders-view", timeout=START_TIMEOUT)
        self.page.wait_for_selector(".statusbar-item", timeout=START_TIMEOUT)

    # ------------------------------------------------------------ documents

    def open(self, name: str, text: str | None = None) -> Path:
        """Open a file in the first column, made first if a text is given; return its path."""
        path = self.folder / name
        if text is not None:
            path.write_text(text, encoding="utf-8")
        # Not where the preview is, whose page answers a key a moment later.
        self.press("Control+1")
        first = self.page.locator(".editor-group-container").first
        expect(first).to_have_class(re.compile(r"\bactive\b"))
        self.run("File: Open File...")
        self.page.locator(".quick-input-list .monaco-list-row", has_text=name).first.click()
        self.active_tab(name).wait_for()
        expect(self.page.locator(".quick-input-widget")).to_be_hidden()
        self.page.wait_for_selector(".editor-group-container.active .monaco-editor.focused")
        return path

    def active_tab(self, name: str) -> Locator:
        """The tab of that name, where it is its group's visible one."""
        return self.page.locator(".tab.active", has_text=name).first

    def save(self) -> None:
        """Save the active document."""
        self.press("Control+s")
        expect(self.page.locator(".tab.active.dirty")).to_have_count(0)

    def text_of(self, path: Path) -> str:
        """Save, and return what is in the file."""
        self.save()
        return path.read_text(encoding="utf-8")

    def go_to(self, text: str, path: Path, offset: int = 0) -> None:
        """Put the cursor at the first place of a text in the saved file."""
        before = path.read_text(encoding="utf-8").partition(text)[0] + text[:offset]
        line = before.count("\n") + 1
        column = len(before) - (before.rfind("\n") + 1) + 1
        self.go_to_place(line, column)

    def go_to_place(self, line: int, column: int) -> None:
        """Put the cursor at a place of the document that has the focus, both from 1."""
        self._ask("Control+g", f":{line}:{column}")
        self.press("Enter")
        self.expect_cursor(line, column)

    def expect_cursor(self, line: int, column: int | None = None) -> None:
        """Wait until the status bar tells that place."""
        pattern = rf"Ln {line}, Col {column}\b" if column else rf"Ln {line}, Col"
        place = self.page.locator("#status\\.editor\\.selection")
        expect(place).to_contain_text(re.compile(pattern), timeout=TIMEOUT)

    # ------------------------------------------------------------ keys and commands

    def press(self, key: str) -> None:
        """Press a key."""
        self.page.keyboard.press(key)

    def type(self, text: str) -> None:
        """Type a text, a key at a time."""
        self.page.keyboard.type(text, delay=15)

    def run(self, title: str) -> None:
        """Run a command from the palette."""
        self._ask("F1", f">{title}")
        row = self.page.locator(".quick-input-list .monaco-list-row", has_text=title).first
        row.wait_for()
        row.click()

    def _ask(self, key: str, text: str) -> None:
        """Press a key that opens an input field and fill it; again if it did not stay open."""
        field = self.page.locator(".quick-input-widget input[type=text]")
        for _ in range(10):
            self.press(key)
            try:
                field.fill(text, timeout=3000)
                return
            except TimeoutError:
                # The focus is elsewhere, in the preview's page for example.
                self.page.locator(".editor-group-container .tab.active").first.click()
        raise AssertionError(f"no input field after {key}")

    def eventually(self, see: Callable[[], Any], what: str) -> Any:
        """Return what is seen once it is true."""
        for _ in range(TIMEOUT // 100):
            seen = see()
            if seen:
                return seen
            self.page.wait_for_timeout(100)
        self.screenshot("missing")
        raise AssertionError(f"not seen: {what}")

    # ------------------------------------------------------------ what is there to be seen

    def problems(self) -> Locator:
        """The rows of the Problems panel."""
        panel = self.page.locator(".markers-panel")
        if not panel.is_visible():
            self.press("Control+Shift+m")
            panel.wait_for()
        return panel.locator(".monaco-list-row")

    def squiggles(self, severity: str) -> Locator:
        """The underlined places of a severity: error, warning, info."""
        return self.page.locator(f".editor-instance .squiggly-{severity}")

    def hover(self) -> Locator:
        """Show the hover at the cursor."""
        self.run("Show or Focus Hover")
        return self.page.locator(".monaco-hover:visible .monaco-hover-content").first

    def pane(self, title: str) -> Locator:
        """A part of the side bar, by its title."""
        header = self.page.locator(f'.pane-header[aria-label^="{title}"]')
        return self.page.locator(".pane", has=header)

    def suggestions(self) -> Locator:
        """The rows of the completion list."""
        self.page.wait_for_selector(".suggest-widget.visible")
        return self.page.locator(".suggest-widget.visible .monaco-list-row")

    def status(self, text: str) -> Locator:
        """An item of the status bar."""
        return self.page.locator(".statusbar-item", has_text=text)

    def notifications(self) -> Locator:
        """The messages that popped up."""
        return self.page.locator(".notification-toast")

    def lines(self) -> list[str]:
        """The lines of the active editor that are on the screen, inlay hints included."""
        found = self.page.locator(".editor-group-container.active .view-line").all_inner_texts()
        return [line.replace("\xa0", " ") for line in found]

    def preview_frame(self) -> Frame:
        """The page that kindsl serves, inside the panel."""

        def find() -> Frame | None:
            frames = [frame for frame in self.page.frames if "token=" in frame.url]
            return frames[-1] if frames and _is_drawing(frames[-1]) else None

        frame: Frame = self.eventually(find, "the frame of the preview")
        return frame

    def screenshot(self, name: str) -> Path:
        """Keep a picture of the window."""
        SHOTS.mkdir(parents=True, exist_ok=True)
        path = SHOTS / f"{name}.png"
        self.page.screenshot(path=path)
        return path


def _is_drawing(frame: Frame) -> bool:
    """Return whether a page shows its picture; not one that VS Code has just replaced."""
    try:
        return frame.locator("canvas").first.is_visible()
    except Error:
        return False
